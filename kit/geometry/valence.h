// SPDX-License-Identifier: Apache-2.0
// How regular a complex is: histograms of what surrounds its vertices and edges, in the tetrahedral view (octahedra cut
// into four tets around their major diagonals).
#pragma once

#include <vector>

#include <solidsubdiv/vtr/level.h>

namespace SolidSubdiv::Geometry {

/// Entry k: how many have the value k.
using Histogram = std::vector<Offset>;

struct ValenceHistograms {
    Histogram vertex_edges;    ///< all vertices: edges at the vertex
    Histogram solid_adjacent;  ///< vertices inside solids: adjacent vertices, those across major diagonals included;
                               ///< 14 is regular
    Histogram surface_edges;   ///< vertices on boundaries and surfaces: edges of the surface; 6 is regular
    Histogram links;           ///< edges inside solids, and major diagonals: tets around them; 4 and 6 are regular
};

/// @pre level.is_full
ValenceHistograms MeasureValences(const Vtr::Level& level);

}  // namespace SolidSubdiv::Geometry
