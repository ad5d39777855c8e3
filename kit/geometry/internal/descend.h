// SPDX-License-Identifier: Apache-2.0
// Gauss-Newton steps within the unit cube towards a place whose point is the origin, or the nearest to it around.
//
// For any map with PointOf(at) and Jacobian(at): a trilinear cell, or a smooth one that a cell's place is the start
// for.
#pragma once

#include <solidsubdiv/kit/geometry/internal/nearest_in_tet.h>

namespace SolidSubdiv::Geometry::Internal {

/// Solves (a0 a1 a2) x = b for columns a; not finite where they are dependent.
inline Vec3 SolveColumns(const std::array<Vec3, 3>& a, const Vec3& b) {
    const Vec3 n0 = Cross(a[1], a[2]), n1 = Cross(a[2], a[0]), n2 = Cross(a[0], a[1]);
    return (1 / Dot(a[0], n0)) * Vec3{Dot(b, n0), Dot(b, n1), Dot(b, n2)};
}

/// The step from `at` towards the origin along coordinates that may still move; `point` is that of at.
inline Vec3 GaussNewtonStep(const std::array<Vec3, 3>& columns, const Vec3& at, const Vec3& point) {
    const double t[3] = {at.x, at.y, at.z};
    bool moves[3];
    for (std::size_t k = 0; k < 3; ++k) {
        const double slope = Dot(columns[k], point);
        moves[k] = !((t[k] <= 0 && slope >= 0) || (t[k] >= 1 && slope <= 0));
    }
    if (moves[0] && moves[1] && moves[2]) {
        const Vec3 step = SolveColumns(columns, -point);
        if (std::isfinite(step.x) && std::isfinite(step.y) && std::isfinite(step.z)) return step;
    }
    // Normal equations of the coordinates that move, a little heavier than they are, so that there is a solution.
    double heaviest = 0;
    for (std::size_t k = 0; k < 3; ++k) heaviest = std::max(heaviest, Dot(columns[k], columns[k]));
    double matrix[3][3], right[3];
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) matrix[j][i] = moves[i] && moves[j] ? Dot(columns[i], columns[j]) : 0;
        matrix[i][i] += moves[i] ? 1e-12 * heaviest : 1;
        right[i] = moves[i] ? -Dot(columns[i], point) : 0;
    }
    const std::array<Vec3, 3> normal{Vec3{matrix[0][0], matrix[1][0], matrix[2][0]},
                                     Vec3{matrix[0][1], matrix[1][1], matrix[2][1]},
                                     Vec3{matrix[0][2], matrix[1][2], matrix[2][2]}};
    return SolveColumns(normal, {right[0], right[1], right[2]});
}

/// Ends where the distance is at most `enough`, or where no step makes it less.
template <class Map>
Nearest Descend(const Map& map, const Vec3& start, double enough) {
    constexpr int kMostSteps = 30, kMostHalvings = 8;
    const auto clamped = [](const Vec3& a) {
        return Vec3{std::clamp(a.x, 0.0, 1.0), std::clamp(a.y, 0.0, 1.0), std::clamp(a.z, 0.0, 1.0)};
    };
    Vec3 point = map.PointOf(start);
    Nearest best{start, Length(point)};
    for (int i = 0; i < kMostSteps && best.distance > enough; ++i) {
        Vec3 step = GaussNewtonStep(map.Jacobian(best.at), best.at, point);
        if (!(std::isfinite(step.x) && std::isfinite(step.y) && std::isfinite(step.z))) break;
        const double before = best.distance;
        for (int k = 0; k < kMostHalvings; ++k, step = 0.5 * step) {
            const Vec3 at = clamped(best.at + step), there = map.PointOf(at);
            const double distance = Length(there);
            if (!(distance < before)) continue;
            best = {at, distance};
            point = there;
            break;
        }
        if (!(best.distance < before * (1 - 1e-12))) break;
    }
    return best;
}

}  // namespace SolidSubdiv::Geometry::Internal
