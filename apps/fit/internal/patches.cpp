// SPDX-License-Identifier: Apache-2.0
// Patches by flooding, curves between them by their sharp edges.
#include <solidsubdiv/apps/fit/internal/patches.h>

#include <algorithm>
#include <array>

#include <solidsubdiv/apps/fit/creases.h>

namespace SolidSubdiv::Fit::Internal {

namespace {

/// Points of two segments that are nearest to each other, as parts of them.
std::array<double, 2> NearestParts(const Vec3& p, const Vec3& pe, const Vec3& q, const Vec3& qe) {
    const Vec3 d = pe - p, e = qe - q, r = p - q;
    const double dd = Dot(d, d), ee = Dot(e, e), de = Dot(d, e), dr = Dot(d, r), er = Dot(e, r);
    const double det = dd * ee - de * de;
    double s = det > 1e-12 * dd * ee ? std::clamp((de * er - dr * ee) / det, 0.0, 1.0) : 0;
    const double t = ee > 0 ? std::clamp((de * s + er) / ee, 0.0, 1.0) : 0;
    if (dd > 0) s = std::clamp((de * t - dr) / dd, 0.0, 1.0);
    return {s, t};
}

}  // namespace

Patches::Patches(const TargetSurface& target, double degrees)
    : patch_of(target.triangles.size() / 3, kNoIndex), target_(target), surface_(target.positions, target.triangles) {
    const std::vector<Index> list = SharpEdges(target, degrees);
    std::set<std::pair<Index, Index>> sharp;
    for (std::size_t i = 0; i < list.size(); i += 2) sharp.insert(std::minmax({list[i], list[i + 1]}));
    std::map<std::pair<Index, Index>, std::vector<Index>> triangles_at;
    const auto edge = [&](std::size_t t, std::size_t k) {
        return std::minmax({target.triangles[3 * t + k], target.triangles[3 * t + (k + 1) % 3]});
    };
    for (std::size_t t = 0; t < patch_of.size(); ++t) {
        for (std::size_t k = 0; k < 3; ++k) triangles_at[edge(t, k)].push_back(static_cast<Index>(t));
    }
    std::vector<std::size_t> stack;
    for (std::size_t first = 0; first < patch_of.size(); ++first) {
        if (patch_of[first] != kNoIndex) continue;
        patch_of[first] = n_patches;
        stack.push_back(first);
        while (!stack.empty()) {
            const std::size_t t = stack.back();
            stack.pop_back();
            for (std::size_t k = 0; k < 3; ++k) {
                if (sharp.count(edge(t, k)) > 0) continue;
                for (Index other : triangles_at[edge(t, k)]) {
                    if (patch_of[static_cast<std::size_t>(other)] != kNoIndex) continue;
                    patch_of[static_cast<std::size_t>(other)] = n_patches;
                    stack.push_back(static_cast<std::size_t>(other));
                }
            }
        }
        ++n_patches;
    }
    for (const auto& [a, b] : sharp) {
        const auto& at = triangles_at[{a, b}];
        const auto between =
            std::minmax({patch_of[static_cast<std::size_t>(at[0])], patch_of[static_cast<std::size_t>(at[1])]});
        if (between.first == between.second) continue;
        curves_[between].push_back({PointAt(target.positions, a), PointAt(target.positions, b)});
    }
    std::map<Index, PatchSet> at_vertices;
    for (std::size_t t = 0; t < patch_of.size(); ++t) {
        for (std::size_t k = 0; k < 3; ++k) at_vertices[target.triangles[3 * t + k]].insert(patch_of[t]);
    }
    for (const auto& [v, set] : at_vertices) {
        if (set.size() > 2) corners.push_back({PointAt(target.positions, v), set});
    }
}

std::vector<Index> Patches::NearestTo(std::span<const double> points) const {
    std::vector<Index> nearest;
    for (const auto& p : surface_.Find(points)) nearest.push_back(patch_of[static_cast<std::size_t>(p.element)]);
    return nearest;
}

Index Patches::NearestOf(const PatchSet& which, const std::array<Vec3, 3>& triangle) const {
    const auto middle_of = [](const Vec3& p, const Vec3& q, const Vec3& r) { return 1.0 / 3 * (p + q + r); };
    const auto normal_of = [](const Vec3& p, const Vec3& q, const Vec3& r) { return Unit(Cross(q - p, r - p)); };
    const auto& [a, b, c] = triangle;
    const Vec3 middle = middle_of(a, b, c), normal = normal_of(a, b, c);
    const double size = Length(b - a) + Length(c - a);
    Index best = *which.begin();
    double least = HUGE_VAL;
    for (std::size_t t = 0; t < patch_of.size(); ++t) {
        if (which.count(patch_of[t]) == 0) continue;
        const auto corner = [&](std::size_t k) { return PointAt(target_.positions, target_.triangles[3 * t + k]); };
        const Vec3 p = corner(0), q = corner(1), r = corner(2);
        constexpr double kDirection = 4;  // as much as so many sizes: the corners lie on all of the patches
        const double off = Length(middle_of(p, q, r) - middle) / size - kDirection * Dot(normal, normal_of(p, q, r));
        if (off >= least) continue;
        least = off;
        best = patch_of[t];
    }
    return best;
}

std::optional<Patches::OnCurve> Patches::NearestOnCurve(Index a, Index b, const Vec3& start, const Vec3& end) const {
    const auto found = curves_.find(std::minmax({a, b}));
    if (found == curves_.end()) return {};
    std::optional<OnCurve> nearest;
    for (const auto& [from, to] : found->second) {
        const auto [s, t] = NearestParts(start, end, from, to);
        const Vec3 on_edge = start + s * (end - start), on_curve = from + t * (to - from);
        const double d = Length(on_curve - on_edge);
        if (!nearest || d < nearest->distance) nearest = OnCurve{on_curve, d};
    }
    return nearest;
}

}  // namespace SolidSubdiv::Fit::Internal
