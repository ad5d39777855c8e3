// SPDX-License-Identifier: Apache-2.0
// What may be wrong with a mesh whatever its cells are.
#include <solidsubdiv/far/internal/kind_check.h>

#include <set>

namespace SolidSubdiv::Far::Internal {

namespace {

std::array<Index, 2> Ascending(Index a, Index b) { return {std::min(a, b), std::max(a, b)}; }

std::set<std::array<Index, 2>> CreaseEdges(const TopologyDescriptor& d) {
    std::set<std::array<Index, 2>> edges;
    for (std::size_t i = 0; i < d.crease_sharpness.size(); ++i) {
        if (d.crease_sharpness[i] > 0) edges.insert(Ascending(d.crease_edges[2 * i], d.crease_edges[2 * i + 1]));
    }
    return edges;
}

void CheckSharpness(const char* name, std::span<const float> sharpness, std::size_t n, DefectList& defects) {
    if (sharpness.size() != n) {
        defects.Add(DefectCode::BadOffsets, kNoIndex, static_cast<double>(sharpness.size()),
                    std::to_string(n) + " " + name + "s have " + std::to_string(sharpness.size()) + " sharpnesses");
    }
    for (std::size_t i = 0; i < sharpness.size(); ++i) {
        if (sharpness[i] >= 0) continue;
        defects.Add(DefectCode::BadSharpness, static_cast<Offset>(i), sharpness[i],
                    Name(name, static_cast<Offset>(i)) + " has the sharpness " + std::to_string(sharpness[i]) +
                        "; it must be 0 or more");
    }
}

}  // namespace

void CheckCreases(const TopologyDescriptor& d, DefectList& defects) {
    KindCheck("crease", d.crease_edges, 2, d.n_vertices, defects).Indices();
    KindCheck("corner", d.corner_vertices, 1, d.n_vertices, defects).Indices();
    CheckSharpness("crease", d.crease_sharpness, d.crease_edges.size() / 2, defects);
    CheckSharpness("corner", d.corner_sharpness, d.corner_vertices.size(), defects);
}

void AddCoincidentEdges(const TopologyDescriptor& d, const std::vector<Index>& edges, DefectList& defects) {
    const std::set<std::array<Index, 2>> creases = CreaseEdges(d);
    for (Index e : edges) {
        if (creases.count(Ascending(d.edges[2 * e], d.edges[2 * e + 1])) > 0) continue;
        defects.Add(DefectCode::CoincidentElement, e, 1,
                    Name("edge", e) + " lies on an edge of a face: a tag, not a part");
    }
}

void AddManifoldDefects(const Vtr::EdgeGraph& graph, DefectList& defects) {
    for (Index e = 0; e < graph.n_edges; ++e) {
        if (!graph.edge_tags[e].non_manifold()) continue;
        defects.Add(DefectCode::NonManifoldEdge, e, static_cast<double>(graph.edge_faces.Count(e)),
                    "edge " + List(graph.EdgeVertices(e)) + " is not manifold");
    }
    for (Index v = 0; v < graph.n_vertices; ++v) {
        if (graph.vertex_edges.Count(v) == 0) {
            defects.Add(DefectCode::IsolatedVertex, v, 0, Name("vertex", v) + " is in no element");
        } else if (graph.vertex_tags[v].non_manifold()) {
            defects.Add(DefectCode::NonManifoldVertex, v, 0, Name("vertex", v) + " is not manifold");
        }
    }
}

}  // namespace SolidSubdiv::Far::Internal
