// SPDX-License-Identifier: Apache-2.0
// VTK's butterfly refinement (vtkButterflySubdivisionFilter: the modified butterfly) of triangle surfaces, as plain
// arrays. An oracle: it shares no code with the library. It holds for closed surfaces; at boundaries VTK has rules of
// its own (docs/butterfly-boundaries.md).
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "surface_levels.h"

namespace SolidSubdiv::Validation {

struct VtkRefinement {
    std::vector<SurfaceLevel> levels;  ///< 0 and up, without rows; old vertices keep their numbers
    std::string refused;               ///< why the levels end before the last, in VTK's words, or empty
};

/// Runs vtk_butterfly.py once for all surfaces; `scratch` is a folder to write in. Positions are in double precision.
/// A level that is not the one before with every triangle split in four counts as refused.
/// @throws Unavailable if VTK's Python module is not there
std::vector<VtkRefinement> RefineByVtk(const std::filesystem::path& script, const std::filesystem::path& scratch,
                                       std::span<const ControlSurface> surfaces, int max_level);

}  // namespace SolidSubdiv::Validation
