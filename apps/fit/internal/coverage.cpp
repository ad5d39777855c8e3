// SPDX-License-Identifier: Apache-2.0
// Borders of surfaces, and how far points of a cloud speak for what lies beside them.
#include <solidsubdiv/apps/fit/internal/coverage.h>

#include <algorithm>
#include <map>
#include <utility>

#include <solidsubdiv/apps/fit/internal/neighbors.h>

namespace SolidSubdiv::Fit::Internal {

Vec3 NormalOf(const TargetSurface& target, Index element) {
    if (target.triangles.empty()) return target.normals.empty() ? Vec3{} : Unit(PointAt(target.normals, element));
    const Index* const t = &target.triangles[3 * static_cast<std::size_t>(element)];
    const Vec3 a = PointAt(target.positions, t[0]);
    return Unit(Cross(PointAt(target.positions, t[1]) - a, PointAt(target.positions, t[2]) - a));
}

Coverage::Coverage(const TargetSurface& target) : target_(target) {
    const auto& triangles = target.triangles;
    if (triangles.empty()) {
        constexpr double kSpacings = 3;  // further across no point is missing by chance
        reach_ = kSpacings * SpacingOf(target.positions, NeighborTree(target.positions));
    }
    std::map<std::pair<Index, Index>, int> counts;
    const auto key = [&](std::size_t t, std::size_t k) {
        return std::minmax({triangles[t + k], triangles[t + (k + 1) % 3]});
    };
    for (std::size_t t = 0; t < triangles.size(); t += 3) {
        for (std::size_t k = 0; k < 3; ++k) ++counts[key(t, k)];
    }
    const bool is_closed = std::none_of(counts.begin(), counts.end(), [](const auto& c) { return c.second == 1; });
    for (std::size_t t = 0; t < triangles.size() && !is_closed; t += 3) {
        is_border_.push_back({counts[key(t, 0)] == 1, counts[key(t, 1)] == 1, counts[key(t, 2)] == 1});
    }
}

bool Coverage::Covers(const Geometry::ClosestPoint& nearest, const Vec3& point, const Vec3& normal) const {
    if (target_.triangles.empty()) {
        const Vec3 n = NormalOf(target_, nearest.element);
        if (Length(n) == 0) return true;
        const Vec3 way{nearest.position[0] - point.x, nearest.position[1] - point.y, nearest.position[2] - point.z};
        return Length(way - Dot(way, n) * n) <= reach_;
    }
    if (is_border_.empty()) return true;
    constexpr double kLeastCosine = 0.5;
    if (Dot(NormalOf(target_, nearest.element), Unit(normal)) < kLeastCosine) return false;
    for (std::size_t k = 0; k < 3; ++k) {
        // On the edge from corner k on the third corner has no weight.
        if (is_border_[static_cast<std::size_t>(nearest.element)][k] && nearest.weights[(k + 2) % 3] == 0) return false;
    }
    return true;
}

}  // namespace SolidSubdiv::Fit::Internal
