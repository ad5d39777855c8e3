// SPDX-License-Identifier: Apache-2.0
// OpenMesh's modified butterfly refinement of a triangle surface, as plain arrays. An oracle: it shares no code with
// the library. It holds for closed surfaces; at boundaries OpenMesh has rules of its own
// (docs/butterfly-boundaries.md).
#pragma once

#include <vector>

#include "surface_levels.h"

namespace SolidSubdiv::Validation {

/// Levels 0 to max_level in double precision, without rows; old vertices keep their numbers.
/// @throws std::runtime_error if OpenMesh can't hold the surface (it takes oriented manifolds)
std::vector<SurfaceLevel> RefineByOpenMesh(const ControlSurface& surface, int max_level);

}  // namespace SolidSubdiv::Validation
