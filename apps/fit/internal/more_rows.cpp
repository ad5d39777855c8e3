// SPDX-License-Identifier: Apache-2.0
// Directions and springs as rows.
#include <solidsubdiv/apps/fit/internal/more_rows.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace SolidSubdiv::Fit::Internal {

namespace {

Vec3 ValueOf(const Far::StencilRows<double>& rows, Index row, std::span<const double> control) {
    Vec3 sum;
    const auto indices = rows.Indices(row);
    const auto weights = rows.Weights(row);
    for (std::size_t k = 0; k < indices.size(); ++k) sum = sum + weights[k] * PointAt(control, indices[k]);
    return sum;
}

/// root * (n . (sum of weight * position)) along n.
LinearRow RowAlong(const Vec3& n, double root, std::vector<std::pair<Index, double>> weights) {
    LinearRow row{.weights = std::move(weights)};
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) row.matrix[3 * i + j] = root * n[i] * n[j];
    }
    return row;
}

}  // namespace

void AddTangentRows(const MovingSurface& surface, std::span<const Pair> pairs, std::span<const double> control,
                    double normals, std::vector<LinearRow>& rows) {
    std::vector<const Pair*> pair_of(static_cast<std::size_t>(surface.rows.n_rows()));
    for (const Pair& pair : pairs) pair_of[static_cast<std::size_t>(pair.vertices[0])] = &pair;
    std::vector<int> n_tangents(pair_of.size());
    for (Index v : surface.tangent_vertices) ++n_tangents[static_cast<std::size_t>(v)];
    for (std::size_t r = 0; r < surface.tangent_vertices.size(); ++r) {
        const auto v = static_cast<std::size_t>(surface.tangent_vertices[r]);
        if (pair_of[v] == nullptr) continue;
        const Pair& pair = *pair_of[v];
        const std::array<Vec3, 2> tangents{ValueOf(surface.tangents[0], static_cast<Index>(r), control),
                                           ValueOf(surface.tangents[1], static_cast<Index>(r), control)};
        constexpr double kLeastCosine = 0.5;
        if (!(std::abs(Dot(Unit(Cross(tangents[0], tangents[1])), pair.normal)) >= kLeastCosine)) continue;
        for (std::size_t k = 0; k < 2; ++k) {
            const auto indices = surface.tangents[k].Indices(static_cast<Index>(r));
            const auto weights = surface.tangents[k].Weights(static_cast<Index>(r));
            std::vector<std::pair<Index, double>> along;
            for (std::size_t i = 0; i < indices.size(); ++i) along.emplace_back(indices[i], weights[i]);
            const double root = std::sqrt(normals * pair.weight / n_tangents[v]) / Length(tangents[k]);
            rows.push_back(RowAlong(pair.normal, root, std::move(along)));
        }
    }
}

void AddSpringRows(std::span<const std::vector<Index>> neighbors, double spring, std::vector<LinearRow>& rows) {
    std::set<std::pair<Index, Index>> springs;
    for (std::size_t p = 0; p < neighbors.size(); ++p) {
        for (Index q : neighbors[p]) springs.insert(std::minmax(static_cast<Index>(p), q));
    }
    const double root = std::sqrt(spring / static_cast<double>(springs.size()));
    for (const auto& [p, q] : springs) {
        rows.push_back({.weights = {{p, 1.0}, {q, -1.0}}, .matrix = {root, 0, 0, 0, root, 0, 0, 0, root}});
    }
}

}  // namespace SolidSubdiv::Fit::Internal
