// SPDX-License-Identifier: Apache-2.0
// Connected pieces by union of vertices, fans by union of corners, border loops by union of border edges' ends.
#include <solidsubdiv/kit/geometry/surface_components.h>

#include <algorithm>
#include <tuple>

#include <solidsubdiv/sdc/disjoint_sets.h>

namespace SolidSubdiv::Geometry {

namespace {

using Sdc::DisjointSets;

/// A side of a triangle: the edge from corner `from` to corner `to` (places in the array of triangles).
struct Side {
    Index low, high;  // the edge's vertices
    std::size_t from, to;
};

std::vector<Side> SortedSides(std::span<const Index> triangles) {
    std::vector<Side> sides;
    sides.reserve(triangles.size());
    for (std::size_t t = 0; t < triangles.size(); t += 3) {
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t from = t + k, to = t + (k + 1) % 3;
            const auto [low, high] = std::minmax({triangles[from], triangles[to]});
            sides.push_back({low, high, from, to});
        }
    }
    std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
        return std::tie(a.low, a.high, a.from) < std::tie(b.low, b.high, b.from);
    });
    return sides;
}

}  // namespace

std::optional<Offset> SurfaceComponent::Genus() const {
    if (!IsManifold() || n_flipped_edges > 0) return std::nullopt;
    return (2 - EulerCharacteristic() - n_border_loops) / 2;
}

std::vector<SurfaceComponent> SurfaceComponents(std::span<const Index> triangles, Index n_vertices) {
    const std::vector<Side> sides = SortedSides(triangles);
    DisjointSets pieces(static_cast<std::size_t>(n_vertices));
    for (const Side& side : sides) pieces.Unite(side.low, side.high);

    // Pieces in the order of their lowest vertex.
    std::vector<std::size_t> piece_of(static_cast<std::size_t>(n_vertices), 0);
    std::vector<char> is_used(static_cast<std::size_t>(n_vertices), 0);
    for (Index v : triangles) is_used[v] = 1;
    std::vector<SurfaceComponent> components;
    for (std::size_t v = 0; v < piece_of.size(); ++v) {
        if (!is_used[v]) continue;
        const std::size_t root = pieces.Find(v);
        if (root == v) {
            piece_of[v] = components.size();
            components.emplace_back();
        }
        piece_of[v] = piece_of[root];
        ++components[piece_of[v]].n_vertices;
    }
    for (std::size_t t = 0; t < triangles.size(); t += 3) ++components[piece_of[triangles[t]]].n_triangles;

    // Edges; corners at a vertex that an edge of two triangles joins lie in one fan.
    DisjointSets corners(triangles.size());
    DisjointSets loops(static_cast<std::size_t>(n_vertices));
    std::vector<Index> border_vertices;
    for (std::size_t i = 0, next; i < sides.size(); i = next) {
        for (next = i + 1;
             next < sides.size() && sides[next].low == sides[i].low && sides[next].high == sides[i].high;) {
            ++next;
        }
        const Side &a = sides[i], &b = sides[next - 1];
        SurfaceComponent& component = components[piece_of[a.low]];
        ++component.n_edges;
        if (next - i == 1) {
            ++component.n_border_edges;
            loops.Unite(a.low, a.high);
            border_vertices.insert(border_vertices.end(), {a.low, a.high});
        } else if (next - i > 2) {
            ++component.n_non_manifold_edges;
        } else {
            const bool agree = triangles[a.from] == triangles[b.to];
            if (!agree) ++component.n_flipped_edges;
            corners.Unite(a.from, agree ? b.to : b.from);
            corners.Unite(a.to, agree ? b.from : b.to);
        }
    }

    // A vertex is manifold if its corners are one fan.
    std::vector<std::size_t> fan(static_cast<std::size_t>(n_vertices), triangles.size());
    std::vector<char> is_bad(static_cast<std::size_t>(n_vertices), 0);
    for (std::size_t c = 0; c < triangles.size(); ++c) {
        std::size_t& known = fan[triangles[c]];
        const std::size_t found = corners.Find(c);
        if (known == triangles.size()) known = found;
        if (known != found) is_bad[triangles[c]] = 1;
    }
    for (std::size_t v = 0; v < is_bad.size(); ++v) {
        if (is_bad[v]) ++components[piece_of[v]].n_non_manifold_vertices;
    }

    std::sort(border_vertices.begin(), border_vertices.end());
    border_vertices.erase(std::unique(border_vertices.begin(), border_vertices.end()), border_vertices.end());
    for (Index v : border_vertices) {
        SurfaceComponent& component = components[piece_of[v]];
        if (component.IsManifold() && loops.Find(v) == static_cast<std::size_t>(v)) ++component.n_border_loops;
    }

    std::stable_sort(components.begin(), components.end(), [](const SurfaceComponent& a, const SurfaceComponent& b) {
        return a.n_triangles > b.n_triangles;
    });
    return components;
}

}  // namespace SolidSubdiv::Geometry
