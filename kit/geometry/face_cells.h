// SPDX-License-Identifier: Apache-2.0
// How many cells a face of a level bounds, whatever the level's split: 0 (a surface element), 1 (a solid's
// boundary), 2.
#pragma once

#include <solidsubdiv/vtr/level.h>
#include <solidsubdiv/vtr/polyhedral_level.h>

namespace SolidSubdiv::Geometry {

/// @pre level.is_full
inline int CellsOfFace(const Vtr::Level& level, Index face) { return level.face_tags[face].n_cells(); }
inline int CellsOfFace(const Vtr::PolyhedralLevel& level, Index face) { return level.NCells(face); }

}  // namespace SolidSubdiv::Geometry
