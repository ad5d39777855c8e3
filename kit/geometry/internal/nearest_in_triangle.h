// SPDX-License-Identifier: Apache-2.0
// The point of a triangle nearest to the origin: corners come relative to the point that is asked for.
#pragma once

#include <array>

#include <solidsubdiv/kit/geometry/internal/vec3.h>

namespace SolidSubdiv::Geometry::Internal {

/// Weights of the second and the third corner of the nearest point; corners may coincide.
/// Source: ericson2005, section 5.1.5, with the origin as the point.
inline std::array<double, 2> NearestInTriangle(const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 ab = b - a, ac = c - a;
    const double d1 = -Dot(ab, a), d2 = -Dot(ac, a);
    if (d1 <= 0 && d2 <= 0) return {0, 0};
    const double d3 = -Dot(ab, b), d4 = -Dot(ac, b);
    if (d3 >= 0 && d4 <= d3) return {1, 0};
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0 && d1 >= 0 && d3 <= 0 && d1 > d3) return {d1 / (d1 - d3), 0};
    const double d5 = -Dot(ab, c), d6 = -Dot(ac, c);
    if (d6 >= 0 && d5 <= d6) return {0, 1};
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0 && d2 >= 0 && d6 <= 0 && d2 > d6) return {0, d2 / (d2 - d6)};
    const double va = d3 * d6 - d5 * d4;
    if (va <= 0 && d4 >= d3 && d5 >= d6) {
        const double w = (d4 - d3) / ((d4 - d3) + (d5 - d6));
        return {1 - w, w};
    }
    const double sum = va + vb + vc;
    return {vb / sum, vc / sum};
}

}  // namespace SolidSubdiv::Geometry::Internal
