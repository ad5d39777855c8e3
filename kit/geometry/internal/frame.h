// SPDX-License-Identifier: Apache-2.0
// Three orthonormal, right-handed directions.
#pragma once

#include <array>

#include <solidsubdiv/kit/geometry/internal/vec3.h>

namespace SolidSubdiv::Geometry::Internal {

using Frame = std::array<Vec3, 3>;

inline constexpr Frame kCoordinateAxes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

/// The frame with axis k + 1 (cyclically) turned by an angle towards axis k + 2.
inline Frame TurnAbout(const Frame& frame, std::size_t k, double cosine, double sine) {
    const Vec3 &u = frame[(k + 1) % 3], &v = frame[(k + 2) % 3];
    Frame turned = frame;
    turned[(k + 1) % 3] = cosine * u + sine * v;
    turned[(k + 2) % 3] = cosine * v - sine * u;
    return turned;
}

}  // namespace SolidSubdiv::Geometry::Internal
