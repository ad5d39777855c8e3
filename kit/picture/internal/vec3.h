// SPDX-License-Identifier: Apache-2.0
// Three numbers with the few operations that a ray tracer needs.
#pragma once

#include <cmath>

namespace SolidSubdiv::Picture::Internal {

template <class T>
struct Vec3 {
    T x{}, y{}, z{};

    template <class U>
    explicit operator Vec3<U>() const {
        return {static_cast<U>(x), static_cast<U>(y), static_cast<U>(z)};
    }
    friend constexpr Vec3 operator+(Vec3 a, Vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
    friend constexpr Vec3 operator-(Vec3 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
    friend constexpr Vec3 operator-(Vec3 a) { return {-a.x, -a.y, -a.z}; }
    friend constexpr Vec3 operator*(T s, Vec3 a) { return {s * a.x, s * a.y, s * a.z}; }
    friend constexpr Vec3 operator*(Vec3 a, Vec3 b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
    Vec3& operator+=(Vec3 b) { return *this = *this + b; }
};

using Vec3f = Vec3<float>;
using Vec3d = Vec3<double>;

template <class T>
constexpr T Dot(Vec3<T> a, Vec3<T> b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class T>
constexpr Vec3<T> Cross(Vec3<T> a, Vec3<T> b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class T>
T Length(Vec3<T> a) {
    return std::sqrt(Dot(a, a));
}
/// The direction of a; zero stays zero.
template <class T>
Vec3<T> Unit(Vec3<T> a) {
    const T length = Length(a);
    return length > 0 ? (1 / length) * a : a;
}

/// Two directions that make a right-handed frame with the unit vector n.
template <class T>
struct Frame {
    Vec3<T> s, t, n;
    explicit Frame(Vec3<T> normal) : n(normal) {
        const Vec3<T> away = std::abs(n.x) < T(0.6) ? Vec3<T>{1, 0, 0} : Vec3<T>{0, 1, 0};
        s = Unit(Cross(away, n));
        t = Cross(n, s);
    }
    Vec3<T> ToWorld(Vec3<T> v) const { return v.x * s + v.y * t + v.z * n; }
};

}  // namespace SolidSubdiv::Picture::Internal
