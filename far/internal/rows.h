// SPDX-License-Identifier: Apache-2.0
// The rows of one refinement under one scheme: for each child vertex, which parent vertices with which weights.
//
// This is where a scheme's weights meet the neighbourhoods that Vtr knows. Everything that refines values (stencil
// tables, PrimvarRefiner, limits) asks here, so a rule stands once.
#pragma once

#include <array>
#include <cassert>
#include <span>
#include <type_traits>
#include <vector>

#include <solidsubdiv/far/internal/butterfly_rows.h>
#include <solidsubdiv/far/internal/four_point_row.h>
#include <solidsubdiv/far/internal/row_entries.h>
#include <solidsubdiv/far/internal/sharp_rows.h>
#include <solidsubdiv/far/internal/surface_rows.h>
#include <solidsubdiv/far/internal/two_neighbors.h>
#include <solidsubdiv/sdc/masks.h>
#include <solidsubdiv/vtr/level.h>

namespace SolidSubdiv::Far::Internal {

/// Whether a scheme's solid rules look at two-neighbours.
template <class Scheme>
constexpr bool UsesTwoNeighbors() {
    if constexpr (requires { Scheme::kTwoNeighbors; }) return Scheme::kTwoNeighbors;
    return false;
}

template <class Scheme>
class Rows {
    using Surface = decltype(std::declval<const Scheme&>().surface());
    using Curve = decltype(std::declval<const Scheme&>().curve());

  public:
    /// @param sharpness the parent's
    Rows(const Level& parent, const Sharpness& sharpness, const Scheme& scheme)
        : level_(parent),
          sharpness_(sharpness),
          sharp_(parent, sharpness, CreaseOptionsOf(scheme).method),
          scheme_(scheme),
          surface_(scheme.surface()),
          curve_(scheme.curve()),
          two_neighbors_(parent),
          butterfly_(parent, sharp_, surface_) {
        assert(parent.is_full);
        if constexpr (Scheme::kSolids) footprint_ = scheme.footprint();
        if constexpr (!Surface::kVerticesStay) {
            for (int n = 1; n < kFew; ++n) few_neighbors_[n] = surface_.Vertex(n);
        }
    }

    /// Rows whose lengths follow from counts: VertexLength, EdgeLength and OctLength are quick and exact.
    static constexpr bool kHasLengths = !(UsesTwoNeighbors<Scheme>() || Surface::kIsWide || Curve::kIsWide);

    /// Every child of a vertex is where its parent is.
    static constexpr bool kVerticesStay = [] {
        if constexpr (requires { Scheme::kVerticesStay; }) return Scheme::kVerticesStay;
        return !Scheme::kSolids && Surface::kVerticesStay && Curve::kVerticesStay;
    }();

    /// Rows by child vertex, in the child's numbering (vtr/refinement.h).
    Index n_children() const { return level_.n_vertices + level_.n_edges + level_.n_octs; }
    Index ChildOfVertex(Index v) const { return v; }
    Index ChildOfEdge(Index e) const { return level_.n_vertices + e; }
    Index ChildOfOct(Index o) const { return level_.n_vertices + level_.n_edges + o; }

    /// Whether sharp edges or its own sharpness change a vertex's rule, and whether that will fade.
    bool IsSharp(Index v) const { return sharp_.ChangesVertex(v); }
    bool IsFading(Index v) const { return sharp_.IsFading(v); }

    /// At least the number of entries of a row; quick.
    std::size_t MaxVertexLength(Index v) const {
        return static_cast<std::size_t>(1 + level_.vertex_edges.Count(v) + level_.vertex_octs.Count(v));
    }
    std::size_t MaxEdgeLength(Index e) const {
        if constexpr (Surface::kIsWide) {
            const Rule rule = level_.edge_tags[e].rule();
            if (rule == Rule::Surface) return butterfly_.MaxLength(e);
            if (rule == Rule::Curve) return kFourPointLength;
        }
        std::size_t n = static_cast<std::size_t>(2 + level_.edge_faces.Count(e) + 2 * level_.edge_octs.Count(e));
        if constexpr (UsesTwoNeighbors<Scheme>()) n += two_neighbors_.MaxEdgeCount(e);
        return n;
    }
    static constexpr std::size_t MaxOctLength() {
        return UsesTwoNeighbors<Scheme>() ? kOctLength + TwoNeighbors::kMaxOctCount : kOctLength;
    }
    std::size_t MaxLength(Index child) const {
        const auto [kind, i] = Locate(child);
        return kind == Kind::Vertex ? MaxVertexLength(i) : kind == Kind::Edge ? MaxEdgeLength(i) : MaxOctLength();
    }
    /// Fills the row and returns its length. Room for MaxLength(child) entries is needed.
    template <class Real>
    std::size_t Fill(Index child, Index* indices, Real* weights) const {
        const auto [kind, i] = Locate(child);
        switch (kind) {
            case Kind::Vertex:
                return static_cast<std::size_t>(FillVertex(i, indices, weights));
            case Kind::Edge:
                return static_cast<std::size_t>(FillEdge(i, indices, weights));
            default:
                return static_cast<std::size_t>(FillOct(i, indices, weights));
        }
    }

    /// Number of entries of the row of the point at vertex v, on edge e, in an octahedron, if kHasLengths.
    int VertexLength(Index v) const {
        if (sharp_.ChangesVertex(v)) return LengthOf(ChildOfVertex(v));
        int n = 1;
        VisitVertex(
            v, [&](Index) { ++n; }, [&](Index) { ++n; });
        return n;
    }
    int EdgeLength(Index e) const {
        if (sharp_.ChangesEdge(e)) return LengthOf(ChildOfEdge(e));
        int n = 2;
        VisitEdge(
            e, [&](Index) { ++n; }, [&](Index) { ++n; }, [](int) {});
        return n;
    }
    static constexpr int OctLength() { return kOctLength; }

    /// Fill rows and return their lengths: the parent vertex or vertices first, then neighbours.
    template <class Real>
    int FillVertex(Index v, Index* indices, Real* weights) const {
        if (sharp_.ChangesVertex(v)) {
            RowEntries<Real> row(indices, weights);
            FillSharpVertex(level_, sharpness_, sharp_, surface_, curve_, v, row);
            return row.size();
        }
        int n = 1, n_edges = 0;
        VisitVertex(
            v,
            [&](Index neighbor) {
                indices[n++] = neighbor;
                ++n_edges;
            },
            [&](Index opposite) { indices[n++] = opposite; });
        const int n_octs = n - 1 - n_edges;
        indices[0] = v;
        double self = 1, edge = 0, oct = 0;
        if (n > 1) {
            switch (level_.vertex_tags[v].rule()) {
                case Rule::Solid:
                    if constexpr (Scheme::kSolids) {
                        const Sdc::VertexWeights w = scheme_.Vertex({n_edges, n_octs});
                        self = w.self, edge = w.edge, oct = w.oct;
                    }
                    break;
                case Rule::Surface:
                    if constexpr (!Surface::kVerticesStay) {
                        const Sdc::RingWeights w = n_edges < kFew ? few_neighbors_[n_edges] : surface_.Vertex(n_edges);
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
        weights[0] = static_cast<Real>(self);
        for (int i = 1; i <= n_edges; ++i) weights[i] = static_cast<Real>(edge);
        for (int i = n_edges + 1; i < n; ++i) weights[i] = static_cast<Real>(oct);
        return n;
    }

    template <class Real>
    int FillEdge(Index e, Index* indices, Real* weights) const {
        const bool is_sharp = sharp_.ChangesEdge(e);
        const Rule rule = is_sharp ? Rule::Curve : level_.edge_tags[e].rule();
        if constexpr (UsesTwoNeighbors<Scheme>()) {
            if (rule == Rule::Solid) return FillTwoNeighborEdge(e, indices, weights);
        }
        if constexpr (Surface::kIsWide) {
            if (rule == Rule::Surface) {
                return butterfly_.Fill(e, indices, weights);
            }
        }
        if constexpr (Curve::kIsWide) {
            if (rule == Rule::Curve) {
                RowEntries<Real> row(indices, weights);
                FillFourPointRow(level_, sharp_, curve_, e, row);
                return row.size();
            }
        }
        if constexpr (!Surface::kVerticesStay) {  // a linear surface is as sharp as can be
            RowEntries<Real> row(indices, weights);
            if (is_sharp) {
                FillSharpEdge(level_, sharp_, surface_, curve_, e, row);
                return row.size();
            }
            if (rule == Rule::Surface) return FillSurfaceEdge(level_, surface_, e, indices, weights);
        }
        return FillNarrowEdge(e, indices, weights);
    }

    template <class Real>
    int FillOct(Index o, Index* indices, Real* weights) const {
        if constexpr (Scheme::kSolids) {
            const auto v = level_.OctVertices(o);
            std::copy(v.begin(), v.end(), indices);
            if constexpr (UsesTwoNeighbors<Scheme>()) {
                const int n_two = two_neighbors_.OfMajorDiagonal(o, indices + kOctLength);
                return WeighTwoNeighbors(scheme_, indices, weights, kOctLength, n_two);
            } else {
                const Sdc::OctWeights w = scheme_.Centre();
                for (int i = 0; i < kOctLength; ++i) weights[i] = static_cast<Real>(i < 2 ? w.diagonal : w.equator);
            }
        }
        return kOctLength;
    }

  private:
    struct Nothing {
        template <class... Arguments>
        explicit Nothing(const Arguments&...) {}
    };

    static constexpr int kOctLength = 6, kFew = 16;
    enum class Kind { Vertex, Edge, Oct };
    struct Place {
        Kind kind;
        Index i;  ///< among the parent's components of that kind
    };
    Place Locate(Index child) const {
        if (child < level_.n_vertices) return {Kind::Vertex, child};
        child -= level_.n_vertices;
        if (child < level_.n_edges) return {Kind::Edge, child};
        return {Kind::Oct, child - level_.n_edges};
    }

    template <class Real>
    int FillTwoNeighborEdge(Index e, Index* indices, Real* weights) const {
        const auto ends = level_.EdgeVertices(e);
        indices[0] = ends[0];
        indices[1] = ends[1];
        int n = 2;
        const auto add = [&](Index v) { indices[n++] = v; };
        VisitEdge(e, add, add, [](int) {});
        return WeighTwoNeighbors(scheme_, indices, weights, n, two_neighbors_.OfEdge(e, indices + n));
    }

    /// Length of a row that must be made to be counted.
    int LengthOf(Index child) const {
        std::vector<Index> indices(MaxLength(child));
        std::vector<double> weights(indices.size());
        return static_cast<int>(Fill(child, indices.data(), weights.data()));
    }

    template <class Real>
    int FillNarrowEdge(Index e, Index* indices, Real* weights) const {
        int n = 2, n_faces = 0, n_octs = 0;
        VisitEdge(
            e,
            [&](Index third) {
                indices[n++] = third;
                ++n_faces;
            },
            [&](Index far_vertex) { indices[n++] = far_vertex; }, [&](int octs) { n_octs = octs; });
        const auto ends = level_.EdgeVertices(e);
        indices[0] = ends[0];
        indices[1] = ends[1];
        double end = 0.5, face = 0, oct = 0;
        if (level_.edge_tags[e].rule() == Rule::Solid) {
            if constexpr (Scheme::kSolids && !UsesTwoNeighbors<Scheme>()) {
                const Sdc::EdgeWeights w = scheme_.Edge({n_faces, n_octs, n - 2 - n_faces});
                end = w.end, face = w.face, oct = w.oct;
            }
        } else if constexpr (!Curve::kIsWide) {
            end = curve_.EdgeEnd();
        }
        weights[0] = weights[1] = static_cast<Real>(end);
        for (int i = 2; i < 2 + n_faces; ++i) weights[i] = static_cast<Real>(face);
        for (int i = 2 + n_faces; i < n; ++i) weights[i] = static_cast<Real>(oct);
        return n;
    }

    Index OtherEnd(Index e, Index v) const {
        const auto ends = level_.EdgeVertices(e);
        return ends[0] + ends[1] - v;
    }

    /// Calls on_edge for each neighbour of v that counts under v's rule, then on_oct for each opposite vertex in an
    /// oct.
    template <class OnEdge, class OnOct>
    void VisitVertex(Index v, OnEdge&& on_edge, OnOct&& on_oct) const {
        const Tag tag = level_.vertex_tags[v];
        switch (tag.rule()) {
            case Rule::Solid:
                if constexpr (Scheme::kSolids) {
                    if (!footprint_.vertex_ring) return;
                    for (Index e : level_.vertex_edges[v]) {
                        if (!tag.non_manifold() || level_.edge_tags[e].in_cell()) on_edge(OtherEnd(e, v));
                    }
                    VisitOctsAtVertex(v, on_oct);
                }
                return;
            case Rule::Surface:
                if (Surface::kVerticesStay) return;
                if (!tag.in_cell() && !tag.non_manifold()) {  // a disc alone
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

    template <class OnOct>
    void VisitOctsAtVertex(Index v, OnOct&& on_oct) const {
        if (footprint_.octs == Sdc::OctNeighbors::None) return;
        const auto octs = level_.vertex_octs[v];
        const auto locals = level_.vertex_octs.Locals(v);
        for (std::size_t i = 0; i < octs.size(); ++i) {
            if (footprint_.octs == Sdc::OctNeighbors::MajorDiagonal && locals[i] > 1) continue;
            on_oct(level_.OctVertices(octs[i])[Sdc::Oct::Opposite(locals[i])]);
        }
    }

    /// Calls on_face for each third vertex and on_oct for each vertex that octs contribute; n_octs gets how many octs.
    template <class OnFace, class OnOct, class NOcts>
    void VisitEdge(Index e, OnFace&& on_face, OnOct&& on_oct, NOcts&& n_octs) const {
        const Tag tag = level_.edge_tags[e];
        if (tag.rule() == Rule::Solid) {
            if constexpr (Scheme::kSolids) {
                if (!footprint_.edge_ring) return;
                const bool all_faces = !tag.non_manifold() && !footprint_.tet_faces_only;
                for (Index f : level_.edge_faces[e]) {
                    if (all_faces || IsInRing(level_.face_tags[f])) on_face(level_.ThirdVertex(f, e));
                }
                VisitOctsAtEdge(e, on_oct, n_octs);
            }
        } else if (tag.rule() == Rule::Surface) {
            if (Surface::kVerticesStay) return;
            const auto faces = level_.edge_faces[e];
            for (Index f : faces) {
                if (faces.size() == 2 || level_.face_tags[f].is_boundary()) on_face(level_.ThirdVertex(f, e));
            }
        }
    }

    bool IsInRing(Vtr::FaceTag face) const {
        return footprint_.tet_faces_only ? face.n_tets() > 0 : face.n_cells() > 0;
    }

    template <class OnOct, class NOcts>
    void VisitOctsAtEdge(Index e, OnOct&& on_oct, NOcts&& n_octs) const {
        if (footprint_.octs == Sdc::OctNeighbors::None) return;
        const bool all = footprint_.octs == Sdc::OctNeighbors::All;
        const auto octs = level_.edge_octs[e];
        const auto locals = level_.edge_octs.Locals(e);
        int n = 0;
        for (std::size_t i = 0; i < octs.size(); ++i) {
            if (!all && locals[i] >= Sdc::Oct::kDiagonalEdges) continue;
            const auto v = level_.OctVertices(octs[i]);
            const auto& ends = Sdc::Oct::edges[locals[i]];  // the first of a diagonal edge is on the major diagonal
            on_oct(v[Sdc::Oct::Opposite(ends[0])]);
            if (all) on_oct(v[Sdc::Oct::Opposite(ends[1])]);
            ++n;
        }
        n_octs(n);
    }

    const Level& level_;
    const Sharpness& sharpness_;
    const SharpRules sharp_;
    const Scheme& scheme_;
    Surface surface_;
    Curve curve_;
    Sdc::Footprint footprint_{};
    std::array<Sdc::RingWeights, kFew> few_neighbors_{};  // what the surface rule says of vertices
    std::conditional_t<UsesTwoNeighbors<Scheme>(), TwoNeighbors, Nothing> two_neighbors_;
    std::conditional_t<Surface::kIsWide, ButterflyRows, Nothing> butterfly_;
};

}  // namespace SolidSubdiv::Far::Internal
