// SPDX-License-Identifier: Apache-2.0
// What is seen of meshes, and control lattices; see internal/picture_parts.h.
#include <solidsubdiv/kit/picture/internal/picture_parts.h>

#include <algorithm>
#include <array>
#include <iterator>

namespace SolidSubdiv::Picture::Internal {
namespace {

/// Edges, as pairs of ends, that are in both lists. @pre both come from ElementEdges, which orders them
std::vector<Index> CommonEdges(const std::vector<Index>& a, const std::vector<Index>& b) {
    using Pair = std::array<Index, 2>;
    const auto pairs = [](const std::vector<Index>& ends) {
        std::vector<Pair> result;
        for (std::size_t i = 0; i < ends.size(); i += 2) result.push_back({ends[i], ends[i + 1]});
        return result;
    };
    const auto first = pairs(a), second = pairs(b);
    std::vector<Pair> common;
    std::set_intersection(first.begin(), first.end(), second.begin(), second.end(), std::back_inserter(common));
    std::vector<Index> edges;
    for (const Pair& edge : common) edges.insert(edges.end(), edge.begin(), edge.end());
    return edges;
}

}  // namespace

std::vector<Index> VisibleTriangles(const Io::Mesh& mesh) {
    const Io::Topology& t = mesh.topology;
    if (t.n_cells() > 0) return SolidBoundary(mesh).triangles;
    std::vector<Index> triangles = t.triangles;
    const auto add = [&](std::span<const Index> face) {
        for (std::size_t i = 2; i < face.size(); ++i) {
            triangles.insert(triangles.end(), {face[0], face[i - 1], face[i]});
        }
    };
    for (std::size_t q = 0; q + 4 <= t.quads.size(); q += 4) add(std::span(t.quads).subspan(q, 4));
    for (std::size_t p = 0; p + 1 < t.polygon_offsets.size(); ++p) {
        const auto first = static_cast<std::size_t>(t.polygon_offsets[p]);
        const auto end = static_cast<std::size_t>(t.polygon_offsets[p + 1]);
        add(std::span(t.polygon_vertices).subspan(first, end - first));
    }
    return triangles;
}

std::vector<Index> VisibleEdges(const Io::Mesh& mesh, const std::vector<Index>& triangles) {
    if (mesh.topology.n_cells() == 0) return ElementEdges(mesh.topology);
    Io::Topology skin;
    skin.triangles = triangles;
    return CommonEdges(ElementEdges(skin), ElementEdges(mesh.topology));
}

void AddLattice(Scene& scene, const Io::Mesh& lattice, const std::vector<Index>& edges, const RenderOptions& render) {
    const double width = LineWidth(edges.size() / 2, render, 4);
    std::vector<Index> ends = edges;
    std::sort(ends.begin(), ends.end());
    ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
    std::vector<double> points;
    for (Index v : ends) {
        const double* p = &lattice.positions[3 * static_cast<std::size_t>(v)];
        points.insert(points.end(), {p[0], p[1], p[2]});
    }
    scene.Add(Lines{
        .positions = lattice.positions, .edges = edges, .color = Palette::kLattice, .width = width, .shaded = true});
    scene.Add(Points{.positions = points, .color = Palette::kLattice, .diameter = 2.7 * width});
}

}  // namespace SolidSubdiv::Picture::Internal
