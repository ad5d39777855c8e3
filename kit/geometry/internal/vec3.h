// SPDX-License-Identifier: Apache-2.0
// Points and directions in space, as few operations as geometry needs.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include <solidsubdiv/sdc/types.h>

namespace SolidSubdiv::Geometry::Internal {

struct Vec3 {
    double x = 0, y = 0, z = 0;

    friend Vec3 operator+(const Vec3& a, const Vec3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
    friend Vec3 operator-(const Vec3& a, const Vec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
    friend Vec3 operator-(const Vec3& a) { return {-a.x, -a.y, -a.z}; }
    friend Vec3 operator*(double s, const Vec3& a) { return {s * a.x, s * a.y, s * a.z}; }
};

inline double Dot(const Vec3& a, const Vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vec3 Cross(const Vec3& a, const Vec3& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double Det(const Vec3& a, const Vec3& b, const Vec3& c) { return Dot(a, Cross(b, c)); }
inline double Length(const Vec3& a) { return std::sqrt(Dot(a, a)); }

inline Vec3 PointAt(std::span<const double> positions, Index v) {
    const double* p = positions.data() + 3 * static_cast<std::size_t>(v);
    return {p[0], p[1], p[2]};
}

}  // namespace SolidSubdiv::Geometry::Internal
