// SPDX-License-Identifier: Apache-2.0
// Where cells meet in an edge or in a vertex only: places at which no chain of faces leads from one to the other.
#pragma once

#include <vector>

#include <solidsubdiv/vtr/level.h>
#include <solidsubdiv/vtr/polyhedral_level.h>

namespace SolidSubdiv::Geometry {

/// What lies elsewhere does not matter: two cells of a ring that closes in an edge meet in that edge only.
struct TouchingCells {
    std::vector<Index> edges;     ///< of the level, ascending: their cells are several fans
    std::vector<Index> vertices;  ///< ascending: their cells fall into groups that share no edge there
};

/// @pre level.is_full. Cost: linear in the corners of faces.
TouchingCells FindTouchingCells(const Vtr::Level& level);
TouchingCells FindTouchingCells(const Vtr::PolyhedralLevel& level);

}  // namespace SolidSubdiv::Geometry
