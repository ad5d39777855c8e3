// SPDX-License-Identifier: Apache-2.0
// Levels of a triangle surface as another program gave them: finds out which vertex split which edge, and matches two
// programs' levels by that, never by position.
#pragma once

#include <vector>

#include "findings.h"
#include "surface_levels.h"

namespace SolidSubdiv::Validation {

/// Fills in the coarse level's edges and children from the triangles of both levels: old vertices keep their numbers,
/// a new vertex is the child of the edge between the two old ones that it is joined to.
/// @throws std::runtime_error if the fine level is not the coarse one with every triangle split in four
void FindChildren(SurfaceLevel& coarse, const SurfaceLevel& fine);

/// Positions of two refinements of one control surface, over the size of its box. Faults: levels whose vertices or
/// triangles do not match.
/// @pre both with the same vertices at level 0, and children in all levels but the last
Findings CompareLevels(const std::vector<SurfaceLevel>& levels, const std::vector<SurfaceLevel>& oracle);

}  // namespace SolidSubdiv::Validation
