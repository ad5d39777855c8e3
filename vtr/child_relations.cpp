// SPDX-License-Identifier: Apache-2.0
// A child's row is as long as its parent's rows say, so each row's place is a sum of places in the parent's relations.
#include <solidsubdiv/vtr/internal/child_relations.h>

#include <cassert>

#include <solidsubdiv/sdc/parallel.h>
#include <solidsubdiv/vtr/internal/child_numbers.h>

namespace SolidSubdiv::Vtr::Internal {

namespace {

constexpr Offset kGrain = 4096;

/// Which edge of face f edge e is.
int LocalEdge(const Level& level, Index f, Index e) {
    const auto edges = level.FaceEdges(f);
    return edges[0] == e ? 0 : edges[1] == e ? 1 : 2;
}

}  // namespace

Relation ChildVertexEdges(const Level& parent) {
    constexpr int kFaceEdges = 2;  // that end at one edge point, in each face
    constexpr int kOctEdges = Sdc::Oct::kEdges;
    const ChildNumbers first(parent);
    const Relation &edges = parent.vertex_edges, &faces = parent.edge_faces, &octs = parent.edge_octs;
    const Offset at_edges = edges.n_items();
    const Offset at_centres = at_edges + 2 * Offset{parent.n_edges} + kFaceEdges * faces.n_items() + octs.n_items();

    Relation r;
    r.offsets.resize(static_cast<std::size_t>(first.centre) + parent.n_octs + 1);
    r.items.resize(static_cast<std::size_t>(at_centres + Offset{kOctEdges} * parent.n_octs));
    r.offsets.back() = r.n_items();
    // A vertex keeps its edges: the halves at it.
    Sdc::ParallelFor(parent.n_vertices, kGrain, [&](Offset begin, Offset end) {
        for (Offset v = begin; v < end; ++v) {
            Index* item = r.items.data() + (r.offsets[v] = edges.Start(static_cast<Index>(v)));
            for (Index e : edges[static_cast<Index>(v)]) *item++ = 2 * e + (parent.EdgeVertices(e)[1] == v);
        }
    });
    // Two halves meet in the point on an edge, and what faces and octs around it put there.
    Sdc::ParallelFor(parent.n_edges, kGrain, [&](Offset begin, Offset end) {
        for (Offset i = begin; i < end; ++i) {
            const Index e = static_cast<Index>(i);
            const Offset start = at_edges + 2 * i + kFaceEdges * faces.Start(e) + octs.Start(e);
            Index* item = r.items.data() + (r.offsets[first.edge_point + i] = start);
            *item++ = 2 * e;
            *item++ = 2 * e + 1;
            for (Index f : faces[e]) {
                const int local = LocalEdge(parent, f, e);
                *item++ = first.face_edge + 3 * f + (local == 0 ? 1 : 0);
                *item++ = first.face_edge + 3 * f + (local == 2 ? 1 : 2);
            }
            const auto around = octs[e];
            const auto locals = octs.Locals(e);
            for (std::size_t k = 0; k < around.size(); ++k)
                *item++ = first.oct_edge + kOctEdges * around[k] + locals[k];
        }
    });
    Sdc::ParallelFor(parent.n_octs, kGrain, [&](Offset begin, Offset end) {
        for (Offset o = begin; o < end; ++o) {
            const Offset start = at_centres + kOctEdges * o;
            r.offsets[first.centre + o] = start;
            for (int k = 0; k < kOctEdges; ++k) {
                r.items[start + k] = static_cast<Index>(first.oct_edge + kOctEdges * o + k);
            }
        }
    });
    return r;
}

Relation ChildEdgeFaces(const Level& parent) {
    assert(parent.n_cells() == 0);
    if (parent.n_faces == 0) return {};
    const ChildNumbers first(parent);
    const Relation& faces = parent.edge_faces;
    const Offset on_faces = 2 * faces.n_items();

    Relation r;
    r.offsets.resize(static_cast<std::size_t>(first.oct_edge) + 1);
    r.items.resize(static_cast<std::size_t>(on_faces + 6 * Offset{parent.n_faces}));
    r.offsets.back() = r.n_items();
    // Both halves of an edge bound children of its faces: at the half's corner.
    Sdc::ParallelFor(parent.n_edges, kGrain, [&](Offset begin, Offset end) {
        for (Offset i = begin; i < end; ++i) {
            const Index e = static_cast<Index>(i);
            const int n = faces.Count(e);
            r.offsets[2 * i] = 2 * faces.Start(e);
            r.offsets[2 * i + 1] = 2 * faces.Start(e) + n;
            Index* item = r.items.data() + r.offsets[2 * i];
            for (Index f : faces[e]) {
                const int local = LocalEdge(parent, f, e);
                item[0] = 4 * f + (local == 0 ? 1 : 0);
                item[n] = 4 * f + (local == 2 ? 1 : 2);
                ++item;
            }
        }
    });
    // An edge on a face cuts one corner from its middle.
    Sdc::ParallelFor(parent.n_faces, kGrain, [&](Offset begin, Offset end) {
        for (Offset f = begin; f < end; ++f) {
            for (int k = 0; k < 3; ++k) {
                const Offset row = 3 * f + k, start = on_faces + 2 * row;
                r.offsets[first.face_edge + row] = start;
                r.items[start] = static_cast<Index>(4 * f + k);
                r.items[start + 1] = static_cast<Index>(4 * f + 3);
            }
        }
    });
    return r;
}

}  // namespace SolidSubdiv::Vtr::Internal
