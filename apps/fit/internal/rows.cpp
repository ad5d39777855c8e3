// SPDX-License-Identifier: Apache-2.0
// Rows of pairs and of fairness.
#include <solidsubdiv/apps/fit/internal/rows.h>

#include <cmath>
#include <map>

namespace SolidSubdiv::Fit::Internal {

std::array<double, 3> LinearRow::Residuals(std::span<const double> control) const {
    std::array<double, 3> off{}, residuals{};
    for (std::size_t c = 0; c < 3; ++c) off[c] = -goal[c];
    for (const auto& w : weights) {
        for (std::size_t c = 0; c < 3; ++c) off[c] += w.second * control[3 * static_cast<std::size_t>(w.first) + c];
    }
    for (std::size_t r = 0; r < 3; ++r) {
        for (std::size_t c = 0; c < 3; ++c) residuals[r] += matrix[3 * r + c] * off[c];
    }
    return residuals;
}

LinearRow RowOf(const Pair& pair, const MovingSurface& surface, double across) {
    std::map<Index, double> weights;
    for (std::size_t k = 0; k < 3; ++k) {
        if (pair.weights[k] == 0) continue;
        const auto indices = surface.rows.Indices(pair.vertices[k]);
        const auto row = surface.rows.Weights(pair.vertices[k]);
        for (std::size_t i = 0; i < indices.size(); ++i) weights[indices[i]] += pair.weights[k] * row[i];
    }
    LinearRow row{.weights = {weights.begin(), weights.end()},
                  .goal = {pair.partner.x, pair.partner.y, pair.partner.z}};
    const Vec3& n = pair.normal;
    const bool has_normal = Dot(n, n) > 0;
    const double root = std::sqrt(has_normal ? across : 1.0);
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            row.matrix[3 * i + j] = std::sqrt(pair.weight) * ((i == j ? root : 0.0) + (1 - root) * n[i] * n[j]);
        }
    }
    return row;
}

LinearRow FairRowOf(const Far::StencilRows<double>& fair_rows, Index point, double fairness) {
    const auto indices = fair_rows.Indices(point);
    const auto weights = fair_rows.Weights(point);
    if (indices.empty()) return {};
    const double root = std::sqrt(fairness / fair_rows.n_rows());
    LinearRow row{.weights = {{point, 1.0}}, .matrix = {root, 0, 0, 0, root, 0, 0, 0, root}};
    for (std::size_t k = 0; k < indices.size(); ++k) row.weights.emplace_back(indices[k], -weights[k]);
    return row;
}

}  // namespace SolidSubdiv::Fit::Internal
