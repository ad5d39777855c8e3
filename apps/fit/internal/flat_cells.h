// SPDX-License-Identifier: Apache-2.0
// Cells that have no volume at a corner in the limit.
//
// A boundary is smooth where it is no crease, and so are creases: three edges of a cell that meet on a smooth patch of
// the boundary, and lie on it, lie in its tangent plane in the limit, two edges on one crease in its tangent. The
// refined cell between them gets flat there, and folds as soon as anything moves.
#pragma once

#include <solidsubdiv/apps/fit/internal/tet_cutter.h>

namespace SolidSubdiv::Fit::Internal {

/// Cuts them, so that an edge leads away between those. Edges between faces of two patches are creases.
void CutFlatCells(TetCutter& cutter);

}  // namespace SolidSubdiv::Fit::Internal
