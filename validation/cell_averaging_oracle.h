// SPDX-License-Identifier: Apache-2.0
// One step of cell averaging, the plain way: split every cell linearly, then average over the new cells at each point.
// An oracle: it shares no code with the library, and goes by sets of vertices alone.
//
// Sources: Schaefer, Hakenberg, Warren 2004 (schaefer2004); Bajaj, Schaefer, Warren, Xu 2002 (bajaj2002).
#pragma once

#include <array>
#include <map>
#include <vector>

#include "cells_oracle.h"
#include "surface_levels.h"

namespace SolidSubdiv::Validation {

/// What a new point came from: a vertex, the two ends of an edge, the vertices of a face or a cell, ascending.
using Parent = std::vector<int>;
using Point = std::array<double, 3>;

/// The new points that a rule placed; those that it has no word about are left out.
struct NewPoints {
    std::map<Parent, Point> of_vertices_and_edges;
    std::map<Parent, Point> of_faces;
    std::map<Parent, Point> of_cells;
};

/// smooth-tet, inside. @param positions (n, 3)
NewPoints AverageTetOct(const Complex& complex, const std::vector<double>& positions);

/// mlca. @param cells faces of each cell; the boundary is one of surfaces @param sharp whether edges and vertices in
/// one cell are sharp. Vertices where the boundary is no manifold, and edges with other than two boundary faces, are
/// left out.
NewPoints AveragePolyhedra(const std::vector<std::vector<Polygon>>& cells, const std::vector<double>& positions,
                           bool sharp);

}  // namespace SolidSubdiv::Validation
