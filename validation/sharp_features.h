// SPDX-License-Identifier: Apache-2.0
// What `sharp` features make of a solid's boundary, as tags that another program takes: by sets, not by the library.
#pragma once

#include <array>
#include <vector>

#include "cells_oracle.h"
#include "surface_levels.h"

namespace SolidSubdiv::Validation {

/// Infinitely sharp: the edges and vertices that one cell has. @param edges_of_cells each edge of a cell once
SurfaceTags SharpFeaturesOf(const std::vector<std::vector<std::array<int, 2>>>& edges_of_cells);
SurfaceTags SharpFeaturesOf(const Complex& complex);

/// Both.
SurfaceTags Merged(SurfaceTags tags, const SurfaceTags& others);

}  // namespace SolidSubdiv::Validation
