// SPDX-License-Identifier: Apache-2.0
// How far points reach in given directions, and which of them reach farthest.
#pragma once

#include <span>
#include <vector>

#include <solidsubdiv/kit/geometry/internal/vec3.h>

namespace SolidSubdiv::Geometry::Internal {

/// Along one direction. Among points that reach equally far the first by x, y, z: no order of the points matters.
struct Extremes {
    double least = 0, greatest = 0;  ///< of Dot(direction, point - origin)
    Vec3 at_least, at_greatest;
};

/// One a direction, of points (n, 3). Parallel, the same bits for any number of threads. @pre there are points
std::vector<Extremes> FindExtremes(std::span<const double> points, const Vec3& origin,
                                   std::span<const Vec3> directions);

}  // namespace SolidSubdiv::Geometry::Internal
