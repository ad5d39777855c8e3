// SPDX-License-Identifier: Apache-2.0
// A place in a complex: an element of a level, and where in it. What a scheme makes of it is its point. Splits halve
// coordinates, so a place of one level is a place of later ones (among cells that stay other than hexahedra: of the
// next).
//
//     const Far::Place middle{.element = 7, .at = {.25, .25, .25}};
//     const auto rows = Far::MakePlaceRows(refiner, 2, {&middle, 1});  // weights of the vertices of level 2
//
// Coordinates by element, and the weights of its vertices (linear within the parts that are named):
//
//   tet          (u, v, w), all >= 0 and u + v + w <= 1: v1, v2, v3 weigh u, v, w, and v0 the rest
//   octahedron   (u, v, w) with |u| + |v| + |w| <= 1: v0, v1 at (+-1, 0, 0), v2, v3 at (0, +-1, 0), v4, v5 at
//                (0, 0, +-1); linear in the four tets around the major diagonal v0 v1, where its middle is (0, 0, 0)
//   hexahedron   (u, v, w) in [0, 1]^3, trilinear: v1 at (1, 0, 0), v3 at (0, 1, 0), v4 at (0, 0, 1)
//   other cell   its part k is a tet; counting the corners of all faces of the cell one after another, it has the
//                corner of that number and the one that follows it in its face: (u, v, w) weigh the face's centroid,
//                the corner, the next corner, the rest is the cell's centroid
//   triangle     (u, v): v1, v2 weigh u, v. Among polyhedra a triangle is a polygon
//   quad         (u, v) in [0, 1]^2, bilinear: v1 at (1, 0), v3 at (0, 1)
//   polygon      its part k is the triangle at edge k: (u, v) weigh corner k and the next, the rest the centroid
#pragma once

#include <array>
#include <span>

#include <solidsubdiv/far/stencil_table.h>

namespace SolidSubdiv::Far {

struct Place {
    Index element = 0;  ///< of a level of tets and octahedra: t, or n_tets + o
    Index part = 0;     ///< of cells and faces that have parts, otherwise 0
    std::array<double, 3> at{};
};

/// What `element` counts: cells, or the level's boundary faces (faces of one cell or none, as in boundary_vertices).
enum class Elements { Cells, BoundaryFaces };

/// @throws InvalidInput naming the place whose element or part is not there or whose coordinates are not finite
void CheckPlaces(const TopologyRefiner& refiner, int level, std::span<const Place> places, Elements elements);

/// Linear (or multilinear) weights of the vertices of a level, a row a place: the cheap form that embeds points in a
/// refined lattice. At most 8 weights a row in tets, octahedra and hexahedra.
/// Coordinates beyond their ranges extrapolate; a vertex may stand twice in a row. @throws InvalidInput as CheckPlaces
StencilRows<double> MakePlaceRows(const TopologyRefiner& refiner, int level, std::span<const Place> places,
                                  Elements elements = Elements::Cells);

}  // namespace SolidSubdiv::Far
