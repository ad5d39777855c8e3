// SPDX-License-Identifier: Apache-2.0
// Two-neighbours of edges and of octahedra's major diagonals: what lies across the faces of the cells around them.
//
// Octahedra count as four tets around their major diagonals. A tet around the edge a b has two faces without one of the
// ends; the vertices across those are the edge's two-neighbours, each once. Source: rules.md section 3.
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>

#include <solidsubdiv/far/internal/row_entries.h>
#include <solidsubdiv/sdc/parallel.h>
#include <solidsubdiv/sdc/schemes/interpolatory.h>
#include <solidsubdiv/vtr/grouping.h>
#include <solidsubdiv/vtr/level.h>

namespace SolidSubdiv::Far::Internal {

using Vtr::Level;

class TwoNeighbors {
  public:
    explicit TwoNeighbors(const Level& level) : level_(level) {
        // Of each face: its cells' vertices across it, each with 1 more, summed. Less the one cell's it is the other's,
        // and nothing where there is no other. Sums of whole numbers are the same in any order.
        Array<std::uint32_t> sums(static_cast<std::size_t>(level.n_faces), 0);
        const bool is_alone = Sdc::ThreadCount() == 1;
        const auto add_to_sum = [&](Index face, Index apex) {
            if (is_alone) {
                sums[face] += static_cast<std::uint32_t>(apex) + 1;
            } else {
                std::atomic_ref(sums[face]).fetch_add(static_cast<std::uint32_t>(apex) + 1, std::memory_order_relaxed);
            }
        };
        Sdc::ParallelFor(level.n_tets, kGrain, [&](Offset begin, Offset end) {
            for (Index t = static_cast<Index>(begin); t < end; ++t) {
                for (int i = 0; i < Sdc::Tet::kFaces; ++i) add_to_sum(level.TetFaces(t)[i], level.TetVertices(t)[i]);
            }
        });
        Sdc::ParallelFor(level.n_octs, kGrain, [&](Offset begin, Offset end) {
            for (Index o = static_cast<Index>(begin); o < end; ++o) {
                for (int i = 0; i < Sdc::Oct::kFaces; ++i) add_to_sum(level.OctFaces(o)[i], OctApex(o, i));
            }
        });
        const auto across = [&](Index face, Index apex) {
            static_assert(kNoIndex == -1);
            return static_cast<Index>(sums[face] - static_cast<std::uint32_t>(apex) - 2);
        };
        around_octs_.resize(static_cast<std::size_t>(OctPlace(level.n_octs)));
        Sdc::ParallelFor(level.n_octs, kGrain, [&](Offset begin, Offset end) {
            for (Index o = static_cast<Index>(begin); o < end; ++o) {
                Index* const out = around_octs_.data() + OctPlace(o);
                for (int i = 0; i < Sdc::Oct::kFaces; ++i) out[i] = across(level.OctFaces(o)[i], OctApex(o, i));
                std::copy_n(level.OctVertices(o).begin(), Sdc::Oct::kVertices, out + Sdc::Oct::kFaces);
            }
        });

        // What lies across the two faces without an end, found once a tet and put beside its edges inside.
        tet_offsets_.resize(static_cast<std::size_t>(level.n_edges) + 1);
        Sdc::ParallelFor(level.n_edges, kGrain, [&](Offset begin, Offset end) {
            for (Offset e = begin; e < end; ++e) tet_offsets_[e] = CountTets(static_cast<Index>(e));
        });
        across_tets_.resize(static_cast<std::size_t>(Sdc::ScanLengths(tet_offsets_)));
        const auto visit = [&](auto&& add) {
            for (Index t = 0; t < level.n_tets; ++t) {
                const auto vertices = level.TetVertices(t);
                const auto faces = level.TetFaces(t);
                const auto edges = level.TetEdges(t);
                std::array<Index, Sdc::Tet::kFaces> others;
                for (int i = 0; i < Sdc::Tet::kFaces; ++i) others[i] = across(faces[i], vertices[i]);
                for (int k = 0; k < Sdc::Tet::kEdges; ++k) {
                    const auto [i, j] = Sdc::Tet::edges[k];
                    if (level.edge_tags[edges[k]].rule() != Vtr::Rule::Solid) continue;
                    add(edges[k], std::array<Index, 2>{others[i], others[j]});
                }
            }
        };
        Vtr::FillRows(tet_offsets_, visit, [&](Offset place, const auto& others) { across_tets_[place] = others; });
    }

    std::size_t MaxEdgeCount(Index e) const {
        return static_cast<std::size_t>(2 * (tet_offsets_[e + 1] - tet_offsets_[e]) + 3 * level_.edge_octs.Count(e));
    }
    static constexpr std::size_t kMaxOctCount = Sdc::Oct::kFaces;

    /// Calls add(vertex, faces) for the two-neighbours of an edge of the solid rule, which may repeat, each with the
    /// number of faces of tets that this one lies across (0 for a repetition that is there for nothing else); false
    /// where some face that they would lie across is a boundary face. Inline, so that what add counts stays in
    /// registers.
    template <class Add>
    [[gnu::always_inline]] bool VisitEdge(Index e, Add&& add) const {
        for (Offset i = tet_offsets_[e]; i < tet_offsets_[e + 1]; ++i) {
            for (Index v : across_tets_[i]) {
                if (v == kNoIndex) return false;
                add(v, 1);
            }
        }
        const auto octs = level_.edge_octs[e];
        const auto oct_locals = level_.edge_octs.Locals(e);
        for (std::size_t k = 0; k < octs.size(); ++k) {
            const auto& faces = kFacesInOct[oct_locals[k] < Sdc::Oct::kDiagonalEdges ? 0 : 1];
            for (std::size_t i = 0; i < faces.size(); ++i) {
                const Index v = around_octs_[OctPlace(octs[k]) + kAroundOctEdges[oct_locals[k]][i]];
                if (v == kNoIndex) return false;
                add(v, faces[i]);
            }
        }
        return true;
    }

    /// The same for the major diagonal of an octahedron.
    template <class Add>
    bool VisitMajorDiagonal(Index o, Add&& add) const {
        for (int i = 0; i < Sdc::Oct::kFaces; ++i) {
            const Index other = around_octs_[OctPlace(o) + i];
            if (other == kNoIndex) return false;
            add(other, 1);
        }
        return true;
    }

  private:
    static constexpr Offset kGrain = 4096;

    /// Where in around_octs_ the two-neighbours of the edges of an octahedron are. Of an edge from an end i of the
    /// major diagonal to j: across the faces at the diagonal, and across the two at the diagonal's other end and j. Of
    /// another edge i j: opposite both, the one twice, so that all edges have three.
    static constexpr std::array<std::array<Sdc::Local, 3>, Sdc::Oct::kEdges> kAroundOctEdges = [] {
        std::array<std::array<Sdc::Local, 3>, Sdc::Oct::kEdges> table{};
        for (int edge = 0; edge < Sdc::Oct::kEdges; ++edge) {
            const int i = Sdc::Oct::edges[edge][0], j = Sdc::Oct::edges[edge][1];
            const auto opposite = [](int v) {
                return static_cast<Sdc::Local>(Sdc::Oct::kFaces + Sdc::Oct::Opposite(static_cast<Sdc::Local>(v)));
            };
            table[edge] = {opposite(j), opposite(i), opposite(i)};
            if (edge >= Sdc::Oct::kDiagonalEdges) continue;
            for (int d = 0; d < 2; ++d) {
                const int b = j < 4 ? j - 2 : d, c = j < 4 ? d : j - 4;
                table[edge][1 + d] =
                    static_cast<Sdc::Local>(4 * Sdc::Oct::Opposite(static_cast<Sdc::Local>(i)) + 2 * b + c);
            }
        }
        return table;
    }();

    /// Faces that these lie across: of edges at the major diagonal, of the others.
    static constexpr std::array<std::array<int, 3>, 2> kFacesInOct{{{2, 1, 1}, {1, 1, 0}}};

    static Offset OctPlace(Index o) { return (Sdc::Oct::kFaces + Sdc::Oct::kVertices) * static_cast<Offset>(o); }
    /// The vertex across face i of the tet at that face, of those that the major diagonal cuts an octahedron into.
    Index OctApex(Index o, int i) const { return level_.OctVertices(o)[i < Sdc::Oct::kFaces / 2 ? 1 : 0]; }

    /// Of an edge of the solid rule; others have no rows. There are as many cells as faces with cells.
    int CountTets(Index e) const {
        const Vtr::Tag tag = level_.edge_tags[e];
        if (tag.rule() != Vtr::Rule::Solid) return 0;
        const auto faces = level_.edge_faces[e];
        const auto n_cells =
            tag.non_manifold()
                ? std::count_if(faces.begin(), faces.end(), [&](Index f) { return level_.face_tags[f].n_cells() > 0; })
                : static_cast<std::ptrdiff_t>(faces.size());
        return static_cast<int>(n_cells) - level_.edge_octs.Count(e);
    }

    const Level& level_;
    Array<Offset> tet_offsets_;                // by edge, if it is of the solid rule, of each tet around it:
    Array<std::array<Index, 2>> across_tets_;  // the vertices across the faces without an end, or kNoIndex
    Array<Index> around_octs_;                 // of each octahedron: the vertices across its faces, then its own
};

/// Finishes a row that starts with two ends and their one-neighbours, n in all, by the two-neighbours that visit(add)
/// adds: one that is there already is no new entry. Returns the row's length; 2, in the middle, where visit returns
/// false.
template <class Scheme, class Real, class Visit>
int FillTwoNeighbors(const Scheme& scheme, Index* indices, Real* weights, int n, RowScratch& scratch, Visit&& visit) {
    // Of each vertex: twice its place in a row, and 1 more for a two-neighbour. What was noted for other rows shows as
    // such, since another vertex is in that place. (The branch is hard to guess, but what does without is a chain of
    // loads that takes longer.)
    std::uint32_t* const notes = scratch.notes.data();
    for (int i = 0; i < n; ++i) notes[indices[i]] = 2 * static_cast<std::uint32_t>(i);
    std::uint32_t length = static_cast<std::uint32_t>(n);
    int n_two = 0;
    const bool is_complete = visit([&](Index v, int) {
        const std::uint32_t note = notes[v];
        if (note / 2 < length && indices[note / 2] == v) {
            n_two += (note & 1) == 0;
            notes[v] = note | 1;
        } else {
            ++n_two;
            notes[v] = 2 * length + 1;
            indices[length++] = v;
        }
    });
    if (!is_complete) {
        weights[0] = weights[1] = static_cast<Real>(0.5);
        return 2;
    }
    const Sdc::TwoNeighborWeights w = scheme.Edge(n - 2, n_two);
    const Real end = static_cast<Real>(w.end), one = static_cast<Real>(w.one), two = static_cast<Real>(w.two);
    for (int i = 0; i < n; ++i) weights[i] = (i < 2 ? end : one) + ((notes[indices[i]] & 1) != 0 ? two : Real{0});
    std::fill(weights + n, weights + length, two);
    return static_cast<int>(length);
}

/// The same where two-neighbours count by faces.
template <class Scheme, class Real, class Visit>
int FillTwoNeighborsByFaces(const Scheme& scheme, Index* indices, Real* weights, int n, RowScratch& scratch,
                            Visit&& visit) {
    std::uint32_t* const notes = scratch.notes.data();
    const Sdc::TwoNeighborWeights w = scheme.EdgeByFaces(n - 2);
    std::uint32_t length = static_cast<std::uint32_t>(n);
    for (int i = 0; i < n; ++i) {
        notes[indices[i]] = 2 * static_cast<std::uint32_t>(i);
        weights[i] = static_cast<Real>(i < 2 ? w.end : w.one);
    }
    const bool is_complete = visit([&](Index v, int n_faces) {
        std::uint32_t place = notes[v] / 2;
        if (place >= length || indices[place] != v) {
            if (n_faces == 0) return;
            place = length++;
            notes[v] = 2 * place;
            indices[place] = v;
            weights[place] = 0;
        }
        weights[place] += static_cast<Real>(n_faces * w.two);
    });
    if (is_complete) return static_cast<int>(length);
    weights[0] = weights[1] = static_cast<Real>(0.5);
    return 2;
}

}  // namespace SolidSubdiv::Far::Internal
