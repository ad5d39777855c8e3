// SPDX-License-Identifier: Apache-2.0
// How regular a complex is: histograms of what surrounds its vertices and edges. Of the tet/oct split in the
// tetrahedral view (octahedra cut into four tets around their major diagonals), of polyhedra as they are.
#pragma once

#include <vector>

#include <solidsubdiv/vtr/level.h>
#include <solidsubdiv/vtr/polyhedral_level.h>

namespace SolidSubdiv::Geometry {

/// Entry k: how many have the value k.
using Histogram = std::vector<Offset>;

/// Regular is what the split itself makes inside: of tets and octs / of polyhedra.
struct ValenceHistograms {
    Histogram vertex_edges;    ///< all vertices: edges at the vertex
    Histogram solid_adjacent;  ///< vertices inside solids: adjacent vertices, those across major diagonals included;
                               ///< regular: 14 / 6
    Histogram surface_edges;   ///< vertices on boundaries and surfaces: edges of the surface; regular: 6 / 4
    Histogram links;           ///< edges inside solids, and major diagonals: cells around them; regular: 4 and 6 / 4
};

/// @pre level.is_full
ValenceHistograms MeasureValences(const Vtr::Level& level);
ValenceHistograms MeasureValences(const Vtr::PolyhedralLevel& level);

}  // namespace SolidSubdiv::Geometry
