// SPDX-License-Identifier: Apache-2.0
// Small triangle surfaces with borders, one for each feature.
#pragma once

#include <string>
#include <vector>

#include "cells_oracle.h"

namespace SolidSubdiv::Validation {

struct SurfaceShape {
    std::string name;
    std::vector<Triangle> triangles;
    std::vector<double> positions;  ///< (n_vertices, 3), shaken
};

/// Manifold ones, then ones that meet themselves in a vertex or an edge.
std::vector<SurfaceShape> OpenSurfaces();

}  // namespace SolidSubdiv::Validation
