// SPDX-License-Identifier: Apache-2.0
// The limit of a boundary surface as triangles or quads that keep to it: of a uniform rate, or as few as a tolerance
// takes.
//
//     const auto uniform = Geometry::TessellateBoundary(refiner, Sdc::BoxSpline{}, {.rate = 8});
//     const auto close = Geometry::TessellateBoundary(refiner, Sdc::BoxSpline{}, positions, {.tolerance = 0.01});
//     close.Positions(positions);        // again and again as control points move
//     close.Normals(positions);
//
// Watertight: faces that meet in an edge or a corner of the control mesh share the vertices there, and no vertex lies
// inside another facet's edge. What is closed stays closed, with the same Euler characteristic.
//
// By tolerance: facets begin as the faces of the control mesh and are bisected (newest vertex bisection, of
// mitchell1991adaptive) where the limit is further away than asked for. Whether an edge is cut is decided for the edge,
// not for its sides: by the limit's distance to it, by the distance to the facets whose longest edge it is, and by what
// keeps the mesh without hanging vertices. docs/sampling.md shows both kinds.
#pragma once

#include <array>
#include <span>
#include <vector>

#include <solidsubdiv/far/place.h>
#include <solidsubdiv/far/stencil_table.h>
#include <solidsubdiv/sdc/progress.h>
#include <solidsubdiv/sdc/schemes.h>

namespace SolidSubdiv::Geometry {

struct TessellationOptions {
    /// [1, 4096]: every edge of the control mesh becomes as many: triangles n^2 triangles, quads n^2 quads, the
    /// triangles between a polygon's edges and its centre n^2 triangles each.
    int rate = 4;
    /// > 0: absolute distance to the limit, in the positions' unit; takes the place of the rate.
    double tolerance = 0;
    /// [0, 30], with a tolerance: how often an edge may be halved at most.
    int max_halvings = 12;
    bool quads = false;   ///< with a rate: keep the quads that quads are cut into; otherwise two triangles each
    bool normals = true;  ///< make tangents
    /// More are refused. [1, 5e8]
    Offset max_facets = 20'000'000;
    /// Boundary faces of level 0 that get no facets: holes. Empty, or one entry a boundary face.
    std::vector<bool> is_left_out{};
    Progress progress{};

    /// @throws InvalidInput
    void Validate() const;
};

/// What a facet covers: a triangle or quad in the coordinates of a boundary face of level 0 (far/place.h).
struct FacetDomain {
    Index face = 0;
    Index part = 0;
    std::array<std::array<double, 2>, 4> corners{};  ///< (u, v), in the order of the facet's vertices

    /// @param weights of the corners
    Far::Place At(std::array<double, 4> weights) const;
};

struct Tessellation {
    std::vector<Index> triangles;      ///< (n, 3), counterclockwise from outside (surface elements: as given)
    std::vector<Index> quads;          ///< (n, 4)
    std::vector<FacetDomain> domains;  ///< of the triangles, then of the quads

    std::vector<Far::Place> places;  ///< of each vertex, in the first face that has it
    Far::StencilRows<double> rows;   ///< (n_vertices): limits over the control vertices
    /// Along u and v of a face; a vertex has a row in every face that meets there, its own vertices' first.
    std::array<Far::StencilRows<double>, 2> tangents;
    std::vector<Index> tangent_vertices;  ///< of each row of tangents; empty without normals

    /// By tolerance only: the largest distance found between the limit and the facets that cover it; on edges of the
    /// control mesh, where borders and creases are, between the limit and the facets' edge.
    double error = 0;
    Offset n_tests = 0;  ///< test points

    Index n_vertices() const { return rows.n_rows(); }
    Offset n_facets() const { return static_cast<Offset>(domains.size()); }

    /// Values at the vertices from `width` values at each control vertex. @throws InvalidInput on a wrong size
    std::vector<double> Values(std::span<const double> control, int width) const;
    std::vector<double> Positions(std::span<const double> control) const { return Values(control, 3); }
    /// Unit normals (n_vertices, 3), the mean of those of the faces that meet: where the surface is smooth they agree.
    /// Where tangents vanish or are parallel (a collapsed face), the mean of the facets' normals by area.
    std::vector<double> Normals(std::span<const double> control) const;
};

/// At a rate: topology alone. @throws InvalidInput if the scheme can't refine the mesh, there are too many facets, or
/// naming a boundary face with a place that has no limit
Tessellation TessellateBoundary(const Far::TopologyRefiner& refiner, const Sdc::Scheme& scheme,
                                const TessellationOptions& options);

/// By tolerance (or at a rate, where there is none), for control points (n_vertices, 3). What is found to deviate by
/// more than 0.8 of the tolerance is cut: between test points, a quarter of an edge apart on edges and a fifth inside,
/// deviations of up to 1.14 times those at them were found. `error` says what was reached: more than the tolerance
/// where max_halvings did not do.
/// @throws InvalidInput as the other
Tessellation TessellateBoundary(const Far::TopologyRefiner& refiner, const Sdc::Scheme& scheme,
                                std::span<const double> positions, const TessellationOptions& options);

struct TessellationError {
    double largest = 0;  ///< distance of a test point of the limit to the facets that cover it
    Offset n_tests = 0;
};

/// Tests every triangle, and both halves of every quad, at six points inside, and every edge at its quarters
/// (the nearest of its facets counts).
TessellationError MeasureError(const Far::TopologyRefiner& refiner, const Sdc::Scheme& scheme,
                               const Tessellation& tessellation, std::span<const double> positions,
                               const Progress& progress = {});

}  // namespace SolidSubdiv::Geometry
