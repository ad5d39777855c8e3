// SPDX-License-Identifier: Apache-2.0
// Principal components of points: the directions in which they vary most and least.
#pragma once

#include <array>
#include <span>

#include <solidsubdiv/kit/geometry/box.h>
#include <solidsubdiv/kit/geometry/internal/frame.h>

namespace SolidSubdiv::Geometry::Internal {

struct PrincipalAxes {
    Frame axes = kCoordinateAxes;
    std::array<double, 3> variances{};  ///< descending; in units of the box's longest side, halved and squared
};

/// Of points, (n, 3), in a box around them. Coordinates are taken to 30 bits and summed exactly, so that neither the
/// order of the points nor the number of threads matters. @pre there are points
PrincipalAxes FindPrincipalAxes(std::span<const double> points, const Box& box);

}  // namespace SolidSubdiv::Geometry::Internal
