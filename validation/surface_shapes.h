// SPDX-License-Identifier: Apache-2.0
// Small triangle surfaces with borders, one for each feature.
#pragma once

#include <string>
#include <vector>

#include "surface_levels.h"

namespace SolidSubdiv::Validation {

struct SurfaceShape {
    std::string name;
    std::vector<Triangle> triangles;
    std::vector<double> positions;  ///< (n_vertices, 3), shaken
};

/// A third of the surface's edges as creases and some of its vertices as corners, of every sharpness: whole, broken,
/// infinite. No vertex has more than two semi-sharp edges: sums of more depend on their order, in single precision, and
/// under Chaikin's rule whole branches hang on the last bit. @param infinite none but infinite ones
SurfaceTags RandomTags(const std::vector<Triangle>& triangles, std::uint32_t seed, bool infinite);
SurfaceTags RandomTags(const std::vector<Polygon>& faces, std::uint32_t seed, bool infinite);

/// Manifold ones, then ones that meet themselves in a vertex or an edge.
std::vector<SurfaceShape> OpenSurfaces();

/// Those, and the boundaries of manifold solids: closed surfaces of every kind.
std::vector<SurfaceShape> AllSurfaces();

}  // namespace SolidSubdiv::Validation
