// SPDX-License-Identifier: Apache-2.0
// The rows of one refinement under one scheme: for each child vertex, which parent vertices with which weights.
//
// This is where a scheme's weights meet the neighbourhoods that Vtr knows. Everything that refines values (stencil
// tables, PrimvarRefiner, limits) asks here, so a rule stands once.
#pragma once

#include <cassert>
#include <type_traits>
#include <vector>

#include <solidsubdiv/far/internal/butterfly_rows.h>
#include <solidsubdiv/far/internal/four_point_row.h>
#include <solidsubdiv/far/internal/narrow_rows.h>
#include <solidsubdiv/far/internal/row_entries.h>
#include <solidsubdiv/far/internal/sharp_rows.h>
#include <solidsubdiv/far/internal/two_neighbors.h>

namespace SolidSubdiv::Far::Internal {

template <class Scheme>
class Rows {
    using Surface = typename NarrowRows<Scheme>::Surface;
    using Curve = typename NarrowRows<Scheme>::Curve;

  public:
    /// @param sharpness the parent's
    Rows(const Level& parent, const Sharpness& sharpness, const Scheme& scheme)
        : level_(parent),
          sharpness_(sharpness),
          sharp_(Vtr::EdgeGraph(parent), sharpness, CreaseOptionsOf(scheme).method),
          scheme_(scheme),
          surface_(scheme.surface()),
          curve_(scheme.curve()),
          narrow_(parent, scheme),
          two_neighbors_(parent),
          butterfly_(parent, sharp_, surface_) {
        assert(parent.is_full);
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

    /// Number of entries of the row of the point at vertex v, on edge e, in an octahedron, if kHasLengths.
    int VertexLength(Index v) const {
        if (sharp_.ChangesVertex(v)) return LengthOf(ChildOfVertex(v));
        const auto n = narrow_.CountAtVertex(v);
        return 1 + n.edges + n.octs;
    }
    int EdgeLength(Index e) const {
        if (sharp_.ChangesEdge(e)) return LengthOf(ChildOfEdge(e));
        const auto n = narrow_.CountAtEdge(e);
        return 2 + n.faces + n.oct_vertices;
    }
    static constexpr int OctLength() { return kOctLength; }

    /// Call add(vertex, weight) for the entries of a row in the order in which they would be filled: the parent vertex
    /// or vertices first, then neighbours. False, and no call, if it is one of the rows that must be filled to be
    /// known.
    template <class Real, class Add>
    bool VisitVertex(Index v, Add&& add) const {
        if (sharp_.ChangesVertex(v)) return false;
        narrow_.template VisitVertex<Real>(v, add);
        return true;
    }
    template <class Real, class Add>
    bool VisitEdge(Index e, Add&& add) const {
        if (sharp_.ChangesEdge(e)) return false;
        const Rule rule = level_.edge_tags[e].rule();
        if (UsesTwoNeighbors<Scheme>() && rule == Rule::Solid) return false;
        if (Curve::kIsWide && rule == Rule::Curve) return false;
        if constexpr (Surface::kIsWide) {
            if (rule == Rule::Surface) return butterfly_.template Visit<Real>(e, add);
        }
        narrow_.template VisitEdge<Real>(e, add);
        return true;
    }
    template <class Real, class Add>
    bool VisitOct(Index o, Add&& add) const {
        if constexpr (!Scheme::kSolids || UsesTwoNeighbors<Scheme>()) {
            return false;
        } else {
            const Sdc::OctWeights w = scheme_.Centre();
            const auto v = level_.OctVertices(o);
            for (int i = 0; i < kOctLength; ++i) add(v[i], static_cast<Real>(i < 2 ? w.diagonal : w.equator));
            return true;
        }
    }

    /// Fill rows and return their lengths. Room for the greatest length is needed.
    template <class Real>
    int FillVertex(Index v, Index* indices, Real* weights) const {
        Writer<Real> writer{indices, weights};
        if (VisitVertex<Real>(v, writer)) return static_cast<int>(writer.index - indices);
        RowEntries<Real> row(indices, weights);
        FillSharpVertex(level_, sharpness_, sharp_, surface_, curve_, v, row);
        return row.size();
    }
    template <class Real>
    int FillEdge(Index e, Index* indices, Real* weights, RowScratch& scratch) const {
        Writer<Real> writer{indices, weights};
        if (VisitEdge<Real>(e, writer)) return static_cast<int>(writer.index - indices);
        const bool is_sharp = sharp_.ChangesEdge(e);
        const Rule rule = is_sharp ? Rule::Curve : level_.edge_tags[e].rule();
        if constexpr (UsesTwoNeighbors<Scheme>()) {
            if (rule == Rule::Solid) return FillTwoNeighborEdge(e, indices, weights, scratch);
        }
        if constexpr (Surface::kIsWide) {
            if (rule == Rule::Surface) return butterfly_.Fill(e, indices, weights);
        }
        RowEntries<Real> row(indices, weights);
        if constexpr (Curve::kIsWide) {
            FillFourPointRow(level_, sharp_, curve_, e, row);
        } else {
            FillSharpEdge(level_, sharp_, surface_, curve_, e, row);
        }
        return row.size();
    }
    template <class Real>
    int FillOct(Index o, Index* indices, Real* weights, [[maybe_unused]] RowScratch& scratch) const {
        Writer<Real> writer{indices, weights};
        if (VisitOct<Real>(o, writer)) return static_cast<int>(writer.index - indices);
        if constexpr (UsesTwoNeighbors<Scheme>()) {
            const auto v = level_.OctVertices(o);
            std::copy(v.begin(), v.end(), indices);
            scratch.MakeNotes(level_.n_vertices);
            return FillTwo(indices, weights, kOctLength, scratch,
                           [&](auto&& add) { return two_neighbors_.VisitMajorDiagonal(o, add); });
        }
        return 0;
    }
    /// The same for the row of a child vertex.
    template <class Real>
    std::size_t Fill(Index child, Index* indices, Real* weights, RowScratch& scratch) const {
        const auto [kind, i] = Locate(child);
        switch (kind) {
            case Kind::Vertex:
                return static_cast<std::size_t>(FillVertex(i, indices, weights));
            case Kind::Edge:
                return static_cast<std::size_t>(FillEdge(i, indices, weights, scratch));
            default:
                return static_cast<std::size_t>(FillOct(i, indices, weights, scratch));
        }
    }

  private:
    struct Nothing {
        template <class... Arguments>
        explicit Nothing(const Arguments&...) {}
    };

    static constexpr int kOctLength = 6;
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

    /// Writes a row as it is visited.
    template <class Real>
    struct Writer {
        Index* index;
        Real* weight;
        void operator()(Index v, Real w) {
            *index++ = v;
            *weight++ = w;
        }
    };

    template <class Real, class Visit>
    int FillTwo(Index* indices, Real* weights, int n, RowScratch& scratch, Visit&& visit) const {
        if (scheme_.two_neighbors == Sdc::TwoNeighborCount::ByFaces) {
            return FillTwoNeighborsByFaces(scheme_, indices, weights, n, scratch, visit);
        }
        return FillTwoNeighbors(scheme_, indices, weights, n, scratch, visit);
    }

    template <class Real>
    int FillTwoNeighborEdge(Index e, Index* indices, Real* weights, RowScratch& scratch) const {
        const auto ends = level_.EdgeVertices(e);
        std::copy(ends.begin(), ends.end(), indices);
        int n = 2;
        const auto add = [&](Index v) { indices[n++] = v; };
        narrow_.ForEdgeNeighbors(e, add, add);
        scratch.MakeNotes(level_.n_vertices);
        return FillTwo(indices, weights, n, scratch,
                       [&](auto&& add_two) { return two_neighbors_.VisitEdge(e, add_two); });
    }

    /// Length of a row that must be made to be counted.
    int LengthOf(Index child) const {
        std::vector<Index> indices(MaxLength(child));
        std::vector<double> weights(indices.size());
        RowScratch scratch;
        return static_cast<int>(Fill(child, indices.data(), weights.data(), scratch));
    }

    const Level& level_;
    const Sharpness& sharpness_;
    const SharpRules sharp_;
    const Scheme& scheme_;
    Surface surface_;
    Curve curve_;
    NarrowRows<Scheme> narrow_;
    std::conditional_t<UsesTwoNeighbors<Scheme>(), TwoNeighbors, Nothing> two_neighbors_;
    std::conditional_t<Surface::kIsWide, ButterflyRows, Nothing> butterfly_;
};

}  // namespace SolidSubdiv::Far::Internal
