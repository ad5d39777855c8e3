// SPDX-License-Identifier: Apache-2.0
// Connected pieces by union of vertices, fans by union of corners, border loops by union of border edges' ends.
#include <solidsubdiv/kit/geometry/surface_components.h>

#include <algorithm>
#include <tuple>

#include <solidsubdiv/sdc/disjoint_sets.h>

namespace SolidSubdiv::Geometry {

namespace {

using Sdc::DisjointSets;

/// A side of a face: the edge from corner `from` to corner `to` (places in the array of corners).
struct Side {
    Index low, high;  // the edge's vertices
    std::size_t from, to;
};

std::vector<Side> SortedSides(std::span<const Offset> offsets, std::span<const Index> corners) {
    std::vector<Side> sides;
    sides.reserve(corners.size());
    for (std::size_t f = 0; f + 1 < offsets.size(); ++f) {
        const auto first = static_cast<std::size_t>(offsets[f]), end = static_cast<std::size_t>(offsets[f + 1]);
        for (std::size_t from = first; from < end; ++from) {
            const std::size_t to = from + 1 < end ? from + 1 : first;
            const auto [low, high] = std::minmax({corners[from], corners[to]});
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

std::vector<SurfaceComponent> SurfaceComponents(std::span<const Offset> offsets, std::span<const Index> corners,
                                                Index n_vertices) {
    const std::vector<Side> sides = SortedSides(offsets, corners);
    DisjointSets pieces(static_cast<std::size_t>(n_vertices));
    for (const Side& side : sides) pieces.Unite(side.low, side.high);

    // Pieces in the order of their lowest vertex.
    std::vector<std::size_t> piece_of(static_cast<std::size_t>(n_vertices), 0);
    std::vector<char> is_used(static_cast<std::size_t>(n_vertices), 0);
    for (Index v : corners) is_used[v] = 1;
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
    for (std::size_t f = 0; f + 1 < offsets.size(); ++f) ++components[piece_of[corners[offsets[f]]]].n_faces;

    // Edges; corners at a vertex that an edge of two faces joins lie in one fan.
    DisjointSets fans(corners.size());
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
            const bool agree = corners[a.from] == corners[b.to];
            if (!agree) ++component.n_flipped_edges;
            fans.Unite(a.from, agree ? b.to : b.from);
            fans.Unite(a.to, agree ? b.from : b.to);
        }
    }

    // A vertex is manifold if its corners are one fan.
    std::vector<std::size_t> fan(static_cast<std::size_t>(n_vertices), corners.size());
    std::vector<char> is_bad(static_cast<std::size_t>(n_vertices), 0);
    for (std::size_t c = 0; c < corners.size(); ++c) {
        std::size_t& known = fan[corners[c]];
        const std::size_t found = fans.Find(c);
        if (known == corners.size()) known = found;
        if (known != found) is_bad[corners[c]] = 1;
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

    std::stable_sort(components.begin(), components.end(),
                     [](const SurfaceComponent& a, const SurfaceComponent& b) { return a.n_faces > b.n_faces; });
    return components;
}

std::vector<SurfaceComponent> SurfaceComponents(std::span<const Index> triangles, Index n_vertices) {
    std::vector<Offset> offsets(triangles.size() / 3 + 1);
    for (std::size_t t = 0; t < offsets.size(); ++t) offsets[t] = static_cast<Offset>(3 * t);
    return SurfaceComponents(offsets, triangles, n_vertices);
}

}  // namespace SolidSubdiv::Geometry
