// SPDX-License-Identifier: Apache-2.0
// Counting cells at edges and vertices.
#include "sharp_features.h"

#include <algorithm>
#include <map>
#include <set>

namespace SolidSubdiv::Validation {

SurfaceTags SharpFeaturesOf(const std::vector<std::vector<std::array<int, 2>>>& edges_of_cells) {
    std::map<std::array<int, 2>, int> cells_of_edge;
    std::map<int, int> cells_of_vertex;
    for (const auto& edges : edges_of_cells) {
        std::set<int> vertices;
        for (const auto& [a, b] : edges) {
            ++cells_of_edge[{std::min(a, b), std::max(a, b)}];
            vertices.insert({a, b});
        }
        for (int v : vertices) ++cells_of_vertex[v];
    }
    SurfaceTags tags;
    for (const auto& [edge, n] : cells_of_edge) {
        if (n == 1) tags.creases.push_back(edge);
    }
    for (const auto& [v, n] : cells_of_vertex) {
        if (n == 1) tags.corners.push_back(v);
    }
    tags.crease_sharpness.assign(tags.creases.size(), 10.0f);
    tags.corner_sharpness.assign(tags.corners.size(), 10.0f);
    return tags;
}

SurfaceTags SharpFeaturesOf(const Complex& complex) {
    std::vector<std::vector<std::array<int, 2>>> edges_of_cells;
    for (const auto& [a, b, c, d] : complex.tets) {
        edges_of_cells.push_back({{a, b}, {a, c}, {a, d}, {b, c}, {b, d}, {c, d}});
    }
    for (const auto& oct : complex.octs) {
        auto& edges = edges_of_cells.emplace_back();
        for (std::size_t i = 0; i < 6; ++i) {
            for (std::size_t j = i + 1; j < 6; ++j) {
                if (i / 2 != j / 2) edges.push_back({oct[i], oct[j]});
            }
        }
    }
    return SharpFeaturesOf(edges_of_cells);
}

SurfaceTags Merged(SurfaceTags tags, const SurfaceTags& others) {
    const auto append = [](auto& to, const auto& from) { to.insert(to.end(), from.begin(), from.end()); };
    append(tags.creases, others.creases);
    append(tags.crease_sharpness, others.crease_sharpness);
    append(tags.corners, others.corners);
    append(tags.corner_sharpness, others.corner_sharpness);
    return tags;
}

}  // namespace SolidSubdiv::Validation
