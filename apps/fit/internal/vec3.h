// SPDX-License-Identifier: Apache-2.0
// Points and directions in space, as few operations as fitting needs.
#pragma once

#include <cmath>
#include <span>
#include <vector>

#include <solidsubdiv/sdc/types.h>

namespace SolidSubdiv::Fit::Internal {

struct Vec3 {
    double x = 0, y = 0, z = 0;

    double operator[](std::size_t axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
    friend Vec3 operator+(const Vec3& a, const Vec3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
    friend Vec3 operator-(const Vec3& a, const Vec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
    friend Vec3 operator*(double s, const Vec3& a) { return {s * a.x, s * a.y, s * a.z}; }
};

inline double Dot(const Vec3& a, const Vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vec3 Cross(const Vec3& a, const Vec3& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double Length(const Vec3& a) { return std::sqrt(Dot(a, a)); }
/// Of length 1, or zero.
inline Vec3 Unit(const Vec3& a) {
    const double length = Length(a);
    return length > 0 ? 1 / length * a : Vec3{};
}
inline Vec3 PointAt(std::span<const double> positions, Index i) {
    const double* const p = positions.data() + 3 * static_cast<std::size_t>(i);
    return {p[0], p[1], p[2]};
}
inline void SetPoint(std::vector<double>& positions, Index i, const Vec3& p) {
    double* const to = positions.data() + 3 * static_cast<std::size_t>(i);
    to[0] = p.x, to[1] = p.y, to[2] = p.z;
}

}  // namespace SolidSubdiv::Fit::Internal
