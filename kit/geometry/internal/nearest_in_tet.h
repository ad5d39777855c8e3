// SPDX-License-Identifier: Apache-2.0
// The point of a tetrahedron nearest to the origin: corners come relative to the point that is asked for.
#pragma once

#include <array>
#include <limits>

#include <solidsubdiv/kit/geometry/internal/vec3.h>

namespace SolidSubdiv::Geometry::Internal {

struct Nearest {
    Vec3 at;  ///< coordinates in the cell, within their ranges
    double distance = std::numeric_limits<double>::infinity();
};

using TetCorners = std::array<Vec3, 4>;

/// Weights of corners 1, 2, 3 of the nearest point, whatever the tet's orientation, flat ones too.
Nearest NearestInTet(const TetCorners& corners);

/// The same where the origin lies within `reach` of the tet; otherwise a distance that is larger than reach, found
/// sooner.
Nearest HoldInTet(const TetCorners& corners, double reach);

}  // namespace SolidSubdiv::Geometry::Internal
