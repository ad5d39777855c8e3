// SPDX-License-Identifier: Apache-2.0
// The boundary faces of level 0 as triangles and quads over nodes, in whose coordinates places are linear or bilinear;
// and facets, which are made in them.
#pragma once

#include <array>
#include <vector>

#include <solidsubdiv/far/limit_stencil_table.h>
#include <solidsubdiv/kit/geometry/internal/vec3.h>
#include <solidsubdiv/kit/geometry/tessellation.h>

namespace SolidSubdiv::Geometry::Internal {

using At = std::array<double, 2>;  ///< (u, v)

inline At Middle(const At& a, const At& b) { return {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2}; }

/// A facet with the numbers of its vertices, or a piece with its nodes.
struct Facet {
    FacetDomain domain;
    int n_corners = 3;
    std::array<Index, 4> vertices{kNoIndex, kNoIndex, kNoIndex, kNoIndex};
};

/// Nodes are the control vertices, then the centres of the faces that are cut into triangles.
struct BoundaryPieces {
    Index n_nodes = 0;
    std::vector<Facet> pieces{};  ///< by face, then part
};

/// @param cuts_quads into four triangles around a centre: by a diagonal, two quads with the same opposite corners would
/// meet in it. @throws InvalidInput if is_left_out has another length than there are boundary faces
BoundaryPieces FindPieces(const Far::TopologyRefiner& refiner, const std::vector<bool>& is_left_out, bool cuts_quads);

/// Limit rows at places in boundary faces of level 0, and their tangents if asked for.
/// @throws InvalidInput naming a face with a place that has no limit
struct LimitRows {
    Far::StencilRows<double> rows;
    std::array<Far::StencilRows<double>, 2> tangents;
};
LimitRows MakeLimitRows(const Far::TopologyRefiner& refiner, const Sdc::Scheme& scheme,
                        std::span<const Far::Place> places, bool tangents, const Progress& progress);

/// Points of places on the boundary's limit, asked for again and again; rows are made a part of the places at a time,
/// and not kept. The refiner outlives it.
class LimitPoints {
  public:
    LimitPoints(const Far::TopologyRefiner& refiner, const Sdc::Scheme& scheme, const Progress& progress);
    /// @throws InvalidInput naming a place that has no limit
    std::vector<Vec3> At(std::span<const Far::Place> places, std::span<const double> positions);

  private:
    const Sdc::Scheme scheme_;
    Far::LimitStencilTableFactory factory_;
};

/// (n_rows, width) numbers from (n_sources, width). @throws InvalidInput on another size
std::vector<double> Apply(const Far::StencilRows<double>& rows, std::span<const double> values, int width);

/// Where triangles are tested inside, as weights of their corners: a lattice of fifths.
inline constexpr std::array<std::array<double, 3>, 6> kTestsInside{
    {{.6, .2, .2}, {.2, .6, .2}, {.2, .2, .6}, {.4, .4, .2}, {.2, .4, .4}, {.4, .2, .4}}};

/// The distance of p to a segment or to a triangle.
double DistanceTo(const Vec3& p, const Vec3& a, const Vec3& b);
double DistanceTo(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c);

/// Bisects triangles until the limit is as close as the tolerance says.
struct CloseFacets {
    std::vector<Facet> facets;  ///< by face
    Index n_vertices = 0;
    double error = 0;
    Offset n_tests = 0;
};
CloseFacets BisectToTolerance(const Far::TopologyRefiner& refiner, const Sdc::Scheme& scheme,
                              std::span<const double> positions, const TessellationOptions& options,
                              const BoundaryPieces& triangles);

}  // namespace SolidSubdiv::Geometry::Internal
