// SPDX-License-Identifier: Apache-2.0
// OpenSubdiv's refinements of surfaces, as plain arrays. An oracle: it shares no code with the library.
#pragma once

#include <vector>

#include "surface_levels.h"

namespace SolidSubdiv::Validation {

/// Levels 0 to max_level, in double precision.
/// @throws std::runtime_error if OpenSubdiv refuses the surface
std::vector<SurfaceLevel> RefineByOpenSubdiv(const ControlSurface& surface, int max_level, int max_row_level);

/// The same by Catmull-Clark's rules, or linearly.
std::vector<SurfaceLevel> RefineByOpenSubdiv(const PolygonSurface& surface, int max_level, int max_row_level);

}  // namespace SolidSubdiv::Validation
