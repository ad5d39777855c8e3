// SPDX-License-Identifier: Apache-2.0
// Cells around an edge are fans between boundary faces; cells at a vertex hang together by the edges that they have
// there.
#include <solidsubdiv/kit/geometry/touching_cells.h>

#include <algorithm>
#include <cassert>
#include <optional>

#include <solidsubdiv/kit/geometry/face_cells.h>
#include <solidsubdiv/sdc/disjoint_sets.h>

namespace SolidSubdiv::Geometry {

namespace {

/// The place of an edge's end at v.
template <class AnyLevel>
std::size_t EndAt(const AnyLevel& level, Index edge, Index v) {
    return 2 * static_cast<std::size_t>(edge) + (level.EdgeVertices(edge)[0] == v ? 0 : 1);
}

template <class AnyLevel>
Index CommonVertex(const AnyLevel& level, Index a, Index b) {
    const auto p = level.EdgeVertices(a), q = level.EdgeVertices(b);
    return p[0] == q[0] || p[0] == q[1] ? p[0] : p[1];
}

template <class AnyLevel>
TouchingCells Find(const AnyLevel& level) {
    assert(level.is_full);
    TouchingCells found;
    for (Index e = 0; e < level.n_edges; ++e) {
        const auto faces = level.edge_faces[e];
        const auto bounds_one = [&](Index f) { return CellsOfFace(level, f) == 1; };
        if (std::count_if(faces.begin(), faces.end(), bounds_one) > 2) found.edges.push_back(e);
    }

    // A face of a cell joins the ends of its edges at each of its corners.
    Sdc::DisjointSets ends(2 * static_cast<std::size_t>(level.n_edges));
    for (Index f = 0; f < level.n_faces; ++f) {
        if (CellsOfFace(level, f) == 0) continue;
        const auto edges = level.FaceEdges(f);
        for (std::size_t k = 0; k < edges.size(); ++k) {
            const Index a = edges[k], b = edges[(k + 1) % edges.size()];
            const Index v = CommonVertex(level, a, b);
            ends.Unite(EndAt(level, a, v), EndAt(level, b, v));
        }
    }
    for (Index v = 0; v < level.n_vertices; ++v) {
        std::optional<std::size_t> first;
        for (Index e : level.vertex_edges[v]) {
            if (!level.edge_tags[e].in_cell()) continue;
            const std::size_t group = ends.Find(EndAt(level, e, v));
            if (!first) first = group;
            if (group == *first) continue;
            found.vertices.push_back(v);
            break;
        }
    }
    return found;
}

}  // namespace

TouchingCells FindTouchingCells(const Vtr::Level& level) { return Find(level); }
TouchingCells FindTouchingCells(const Vtr::PolyhedralLevel& level) { return Find(level); }

}  // namespace SolidSubdiv::Geometry
