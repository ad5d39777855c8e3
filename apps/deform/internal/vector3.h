// SPDX-License-Identifier: Apache-2.0
// Three numbers, and the few operations on them that the room needs.
#pragma once

#include <array>
#include <cmath>
#include <span>

#include <solidsubdiv/sdc/types.h>

namespace SolidSubdiv::Deform::Internal {

using Vector3 = std::array<double, 3>;

inline Vector3 PointAt(std::span<const double> positions, Index i) {
    const double* const p = positions.data() + 3 * static_cast<std::size_t>(i);
    return {p[0], p[1], p[2]};
}
inline Vector3 Minus(const Vector3& a, const Vector3& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline double Dot(const Vector3& a, const Vector3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Vector3 Cross(const Vector3& a, const Vector3& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline double Length(const Vector3& a) { return std::sqrt(Dot(a, a)); }

/// The sum of weighted positions.
inline Vector3 WeightedSum(std::span<const Index> indices, std::span<const double> weights,
                           std::span<const double> positions) {
    Vector3 sum{};
    for (std::size_t k = 0; k < indices.size(); ++k) {
        const double* const p = positions.data() + 3 * static_cast<std::size_t>(indices[k]);
        for (std::size_t c = 0; c < 3; ++c) sum[c] += weights[k] * p[c];
    }
    return sum;
}

/// x with x0 columns[0] + x1 columns[1] + x2 columns[2] = right; zero where the columns are all but dependent: their
/// determinant is less than a thousandth of what columns of their lengths could have.
inline Vector3 SolveColumns(const std::array<Vector3, 3>& columns, const Vector3& right) {
    const auto& [a, b, c] = columns;
    const double det = Dot(a, Cross(b, c));
    if (!(std::abs(det) > 1e-3 * Length(a) * Length(b) * Length(c))) return {};
    return {Dot(right, Cross(b, c)) / det, Dot(a, Cross(right, c)) / det, Dot(a, Cross(b, right)) / det};
}

}  // namespace SolidSubdiv::Deform::Internal
