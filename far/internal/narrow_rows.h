// SPDX-License-Identifier: Apache-2.0
// Rows that look no further than the faces and octahedra at an edge and the edges and octahedra at a vertex.
//
// How many neighbours a row has is counted before they are visited, so that each comes with its weight: then a row can
// be summed as it is visited, and is written only where somebody keeps it.
#pragma once

#include <algorithm>
#include <array>
#include <type_traits>

#include <solidsubdiv/sdc/masks.h>
#include <solidsubdiv/vtr/level.h>

namespace SolidSubdiv::Far::Internal {

using Vtr::Level;
using Vtr::Rule;
using Vtr::Tag;

/// Whether a scheme's solid rules look at two-neighbours.
template <class Scheme>
constexpr bool UsesTwoNeighbors() {
    if constexpr (requires { Scheme::kTwoNeighbors; }) return Scheme::kTwoNeighbors;
    return false;
}

/// Whether a scheme's rule at a vertex inside a solid goes by the cells there.
template <class Scheme>
constexpr bool kWeighsByCells = requires(const Scheme& s) {
    s.Vertex(Sdc::VertexCells{});
};

template <class Scheme>
class NarrowRows {
  public:
    using Surface = decltype(std::declval<const Scheme&>().surface());
    using Curve = decltype(std::declval<const Scheme&>().curve());

    NarrowRows(const Level& level, const Scheme& scheme)
        : level_(level), scheme_(scheme), surface_(scheme.surface()), curve_(scheme.curve()) {
        if constexpr (Scheme::kSolids) footprint_ = scheme.footprint();
        if constexpr (!Surface::kVerticesStay) {
            for (int n = 1; n < kFew; ++n) few_neighbors_[n] = surface_.Vertex(n);
        }
    }

    /// How many neighbours a row has.
    struct VertexCounts {
        int edges = 0, octs = 0;
    };
    struct EdgeCounts {
        int faces = 0, octs = 0, oct_vertices = 0;
    };
    VertexCounts CountAtVertex(Index v) const {
        const Tag tag = level_.vertex_tags[v];
        if (tag.rule() == Rule::Solid && !tag.non_manifold()) {
            if constexpr (!Scheme::kSolids) return {};
            return footprint_.vertex_ring ? VertexCounts{level_.vertex_edges.Count(v), CountOctsAtVertex(v)}
                                          : VertexCounts{};
        }
        if (IsDisc(tag)) return {Surface::kVerticesStay ? 0 : level_.vertex_edges.Count(v)};
        VertexCounts n;
        ForVertexNeighbors(
            v, [&](Index) { ++n.edges; }, [&](Index) { ++n.octs; });
        return n;
    }
    EdgeCounts CountAtEdge(Index e) const {
        EdgeCounts n;
        if (level_.edge_tags[e].rule() != Rule::Solid) {
            ForEdgeFaces(e, [&](Index) { ++n.faces; });
        } else if constexpr (Scheme::kSolids) {
            if (!footprint_.edge_ring) return n;
            if (TakesAllFaces(e)) {
                n.faces = level_.edge_faces.Count(e);
            } else {
                ForEdgeFaces(e, [&](Index) { ++n.faces; });
            }
            if (footprint_.octs == Sdc::OctNeighbors::All) {
                n.octs = level_.edge_octs.Count(e);
                n.oct_vertices = 2 * n.octs;
            } else if (footprint_.octs == Sdc::OctNeighbors::MajorDiagonal) {
                const auto locals = level_.edge_octs.Locals(e);
                for (Sdc::Local local : locals) n.octs += local < Sdc::Oct::kDiagonalEdges;
                n.oct_vertices = n.octs;
            }
        }
        return n;
    }

    /// Calls add(vertex, weight) for the row of the point at vertex v: v first, then its neighbours.
    template <class Real, class Add>
    void VisitVertex(Index v, Add&& add) const {
        if constexpr (kWeighsByCells<Scheme>) {
            if (level_.vertex_tags[v].rule() == Rule::Solid) return VisitVertexByCells<Real>(v, add);
        }
        const VertexCounts n = CountAtVertex(v);
        double self = 1, edge = 0, oct = 0;
        if (n.edges + n.octs > 0) {
            switch (level_.vertex_tags[v].rule()) {
                case Rule::Solid:
                    if constexpr (Scheme::kSolids && !kWeighsByCells<Scheme>) {
                        const Sdc::VertexWeights w = scheme_.Vertex({n.edges, n.octs});
                        self = w.self, edge = w.edge, oct = w.oct;
                    }
                    break;
                case Rule::Surface:
                    if constexpr (!Surface::kVerticesStay) {
                        const Sdc::RingWeights w = n.edges < kFew ? few_neighbors_[n.edges] : surface_.Vertex(n.edges);
                        self = w.self, edge = w.neighbor;
                    }
                    break;
                default:
                    if constexpr (!Curve::kVerticesStay) {
                        const Sdc::RingWeights w = curve_.Vertex();
                        self = w.self, edge = w.neighbor;
                    }
            }
        }
        const Real edge_weight = static_cast<Real>(edge), oct_weight = static_cast<Real>(oct);
        add(v, static_cast<Real>(self));
        ForVertexNeighbors(
            v, [&](Index neighbor) { add(neighbor, edge_weight); }, [&](Index far) { add(far, oct_weight); });
    }

    /// The same at a vertex inside a solid. An edge's end lies in as many cells as the edge, which are as many as its
    /// faces; a tet has three edges at each vertex.
    template <class Real, class Add>
    void VisitVertexByCells(Index v, Add&& add) const {
        const int n_octs = level_.vertex_octs.Count(v);
        int n_tet_edges = 0;
        ForVertexEdges(v, [&](Index e) { n_tet_edges += CountTetsAtEdge(e); });
        const Sdc::CellVertexWeights w = scheme_.Vertex(Sdc::VertexCells{n_tet_edges / 3, n_octs});
        add(v, static_cast<Real>(w.self));
        ForVertexEdges(v, [&](Index e) {
            add(OtherEnd(e, v), static_cast<Real>(w.tet * CountTetsAtEdge(e) + w.oct * level_.edge_octs.Count(e)));
        });
        ForOctVerticesAtVertex(v, [&](Index far) { add(far, static_cast<Real>(w.opposite)); });
    }

    /// The same for a new point on edge e: the ends first, then third vertices of faces, then vertices of octahedra.
    template <class Real, class Add>
    void VisitEdge(Index e, Add&& add) const {
        double end = 0.5, face = 0, oct = 0;
        const Rule rule = level_.edge_tags[e].rule();
        if (rule == Rule::Solid) {
            if constexpr (Scheme::kSolids && !UsesTwoNeighbors<Scheme>()) {
                const EdgeCounts n = CountAtEdge(e);
                const Sdc::EdgeWeights w = scheme_.Edge({n.faces, n.octs, n.oct_vertices});
                end = w.end, face = w.face, oct = w.oct;
            }
        } else if (rule == Rule::Surface) {
            if constexpr (!Surface::kVerticesStay) {
                const Sdc::EdgePairWeights w = surface_.Edge();
                end = w.end, face = w.opposite;
            }
        } else if constexpr (!Curve::kIsWide) {
            end = curve_.EdgeEnd();
        }
        const Real face_weight = static_cast<Real>(face), oct_weight = static_cast<Real>(oct);
        for (Index v : level_.EdgeVertices(e)) add(v, static_cast<Real>(end));
        ForEdgeNeighbors(
            e, [&](Index third) { add(third, face_weight); }, [&](Index far) { add(far, oct_weight); });
    }

    /// Calls on_face and on_oct for what stands in the row of an edge beside its ends, in this order.
    template <class OnFace, class OnOct>
    void ForEdgeNeighbors(Index e, OnFace&& on_face, OnOct&& on_oct) const {
        ForEdgeFaces(e, [&](Index f) { on_face(level_.ThirdVertex(f, e)); });
        if constexpr (Scheme::kSolids) {
            if (level_.edge_tags[e].rule() == Rule::Solid && footprint_.edge_ring) ForOctVerticesAtEdge(e, on_oct);
        }
    }

  private:
    static constexpr int kFew = 16;

    Index OtherEnd(Index e, Index v) const {
        const auto ends = level_.EdgeVertices(e);
        return ends[0] + ends[1] - v;
    }
    /// The surface at v is all there is, and is a disc.
    static bool IsDisc(Tag vertex) {
        return vertex.rule() == Rule::Surface && !vertex.in_cell() && !vertex.non_manifold();
    }

    template <class OnEdge, class OnOct>
    void ForVertexNeighbors(Index v, OnEdge&& on_edge, OnOct&& on_oct) const {
        const Tag tag = level_.vertex_tags[v];
        switch (tag.rule()) {
            case Rule::Solid:
                if constexpr (Scheme::kSolids) {
                    if (!footprint_.vertex_ring) return;
                    ForVertexEdges(v, [&](Index e) { on_edge(OtherEnd(e, v)); });
                    ForOctVerticesAtVertex(v, on_oct);
                }
                return;
            case Rule::Surface:
                if (Surface::kVerticesStay) return;
                if (IsDisc(tag)) {
                    for (Index e : level_.vertex_edges[v]) on_edge(OtherEnd(e, v));
                    return;
                }
                for (Index e : level_.vertex_edges[v]) {
                    const Tag edge = level_.edge_tags[e];
                    const bool on_surface =
                        tag.in_cell() ? edge.in_cell() && edge.rule() != Rule::Solid : edge.in_face();
                    if (on_surface) on_edge(OtherEnd(e, v));
                }
                return;
            case Rule::Curve:
                if (Curve::kVerticesStay) return;
                for (Index e : level_.vertex_edges[v]) {
                    const Tag edge = level_.edge_tags[e];
                    const bool in_part = (!tag.in_cell() || edge.in_cell()) && (!tag.in_face() || edge.in_face());
                    if (in_part && edge.rule() == Rule::Curve) on_edge(OtherEnd(e, v));
                }
                return;
            case Rule::Corner:
                return;
        }
    }

    /// Edges of the solid at a vertex inside it: sheets and curves may end there.
    template <class OnEdge>
    void ForVertexEdges(Index v, OnEdge&& on_edge) const {
        const bool all = !level_.vertex_tags[v].non_manifold();
        for (Index e : level_.vertex_edges[v]) {
            if (all || level_.edge_tags[e].in_cell()) on_edge(e);
        }
    }
    /// At an edge inside a solid.
    int CountTetsAtEdge(Index e) const {
        int n_cells = level_.edge_faces.Count(e);
        if (level_.edge_tags[e].non_manifold()) {
            const auto faces = level_.edge_faces[e];
            n_cells = static_cast<int>(
                std::count_if(faces.begin(), faces.end(), [&](Index f) { return IsInRing(level_.face_tags[f]); }));
        }
        return n_cells - level_.edge_octs.Count(e);
    }

    int CountOctsAtVertex(Index v) const {
        if (footprint_.octs == Sdc::OctNeighbors::None) return 0;
        if (footprint_.octs == Sdc::OctNeighbors::All) return level_.vertex_octs.Count(v);
        const auto locals = level_.vertex_octs.Locals(v);
        return static_cast<int>(std::count_if(locals.begin(), locals.end(), [](Sdc::Local i) { return i <= 1; }));
    }
    template <class OnOct>
    void ForOctVerticesAtVertex(Index v, OnOct&& on_oct) const {
        if (footprint_.octs == Sdc::OctNeighbors::None) return;
        const auto octs = level_.vertex_octs[v];
        const auto locals = level_.vertex_octs.Locals(v);
        for (std::size_t i = 0; i < octs.size(); ++i) {
            if (footprint_.octs == Sdc::OctNeighbors::MajorDiagonal && locals[i] > 1) continue;
            on_oct(level_.OctVertices(octs[i])[Sdc::Oct::Opposite(locals[i])]);
        }
    }

    /// Whether all faces at an edge of the solid rule count.
    bool TakesAllFaces(Index e) const { return !level_.edge_tags[e].non_manifold() && !footprint_.tet_faces_only; }

    template <class OnFace>
    void ForEdgeFaces(Index e, OnFace&& on_face) const {
        const Rule rule = level_.edge_tags[e].rule();
        if (rule == Rule::Solid) {
            if constexpr (Scheme::kSolids) {
                if (!footprint_.edge_ring) return;
                const bool all = TakesAllFaces(e);
                for (Index f : level_.edge_faces[e]) {
                    if (all || IsInRing(level_.face_tags[f])) on_face(f);
                }
            }
        } else if (rule == Rule::Surface) {
            if (Surface::kVerticesStay) return;
            const auto faces = level_.edge_faces[e];
            for (Index f : faces) {
                if (faces.size() == 2 || level_.face_tags[f].is_boundary()) on_face(f);  // two: they are the surface's
            }
        }
    }
    bool IsInRing(Vtr::FaceTag face) const {
        return footprint_.tet_faces_only ? face.n_tets() > 0 : face.n_cells() > 0;
    }

    template <class OnOct>
    void ForOctVerticesAtEdge(Index e, OnOct&& on_oct) const {
        if (footprint_.octs == Sdc::OctNeighbors::None) return;
        const bool all = footprint_.octs == Sdc::OctNeighbors::All;
        const auto octs = level_.edge_octs[e];
        const auto locals = level_.edge_octs.Locals(e);
        for (std::size_t i = 0; i < octs.size(); ++i) {
            if (!all && locals[i] >= Sdc::Oct::kDiagonalEdges) continue;
            const auto v = level_.OctVertices(octs[i]);
            const auto& ends = Sdc::Oct::edges[locals[i]];  // the first of a diagonal edge is on the major diagonal
            on_oct(v[Sdc::Oct::Opposite(ends[0])]);
            if (all) on_oct(v[Sdc::Oct::Opposite(ends[1])]);
        }
    }

    const Level& level_;
    const Scheme& scheme_;
    Surface surface_;
    Curve curve_;
    Sdc::Footprint footprint_{};
    std::array<Sdc::RingWeights, kFew> few_neighbors_{};  // what the surface rule says of vertices
};

}  // namespace SolidSubdiv::Far::Internal
