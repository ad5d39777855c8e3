// SPDX-License-Identifier: Apache-2.0
// Two-neighbours of edges and of octahedra's major diagonals: what lies across the faces of the cells around them.
//
// Octahedra count as four tets around their major diagonals. A tet around the edge a b has two faces without one of the
// ends; the vertices across those are the edge's two-neighbours, each once. Source: rules.md section 3.
#pragma once

#include <algorithm>
#include <array>
#include <atomic>

#include <solidsubdiv/sdc/parallel.h>
#include <solidsubdiv/sdc/schemes/interpolatory.h>
#include <solidsubdiv/vtr/level.h>

namespace SolidSubdiv::Far::Internal {

using Vtr::Level;

class TwoNeighbors {
  public:
    explicit TwoNeighbors(const Level& level)
        : level_(level), edge_tets_(Vtr::Invert(level.tet_edges, Sdc::Tet::kEdges, level.n_edges, true)) {
        // Of each face: its cells' vertices across it, summed. Sums of whole numbers are the same in any order.
        std::vector<std::uint32_t> sums(static_cast<std::size_t>(level.n_faces));
        const bool is_alone = Sdc::ThreadCount() == 1;
        ForCells([&](Index face, Index apex, Offset) {
            if (is_alone) {
                sums[face] += static_cast<std::uint32_t>(apex);
            } else {
                std::atomic_ref(sums[face]).fetch_add(static_cast<std::uint32_t>(apex), std::memory_order_relaxed);
            }
        });
        // Every edge of a cell asks what is across its faces: found once a cell.
        across_.resize(static_cast<std::size_t>(OctPlace(level.n_octs)));
        ForCells([&](Index face, Index apex, Offset place) {
            across_[place] = level.face_tags[face].n_cells() < 2
                                 ? kNoIndex
                                 : static_cast<Index>(sums[face] - static_cast<std::uint32_t>(apex));
        });
    }

    std::size_t MaxEdgeCount(Index e) const {
        return static_cast<std::size_t>(2 * edge_tets_.Count(e) + 3 * level_.edge_octs.Count(e));
    }
    static constexpr std::size_t kMaxOctCount = Sdc::Oct::kFaces;

    /// Writes the distinct two-neighbours of an edge and returns their number, or -1 where some face that they would
    /// lie across is a boundary face.
    int OfEdge(Index e, Index* out) const {
        int n = 0;
        const auto tets = edge_tets_[e];
        const auto tet_locals = edge_tets_.Locals(e);
        for (std::size_t k = 0; k < tets.size(); ++k) {
            const Index* const across = across_.data() + TetPlace(tets[k]);
            for (Sdc::Local end : Sdc::Tet::edges[tet_locals[k]]) {
                if (!AddDistinct(across[end], out, n)) return -1;
            }
        }
        const auto octs = level_.edge_octs[e];
        const auto oct_locals = level_.edge_octs.Locals(e);
        for (std::size_t k = 0; k < octs.size(); ++k) {
            const auto v = level_.OctVertices(octs[k]);
            const auto [i, j] = Sdc::Oct::edges[oct_locals[k]];
            AddDistinct(v[Sdc::Oct::Opposite(j)], out, n);  // across the faces at the major diagonal
            if (oct_locals[k] >= Sdc::Oct::kDiagonalEdges) {
                AddDistinct(v[Sdc::Oct::Opposite(i)], out, n);
                continue;
            }
            // i is on the major diagonal: across the two faces at its other end and j.
            for (int d = 0; d < 2; ++d) {
                const int b = j < 4 ? j - 2 : d, c = j < 4 ? d : j - 4;
                const int face = 4 * Sdc::Oct::Opposite(i) + 2 * b + c;
                if (!AddDistinct(across_[OctPlace(octs[k]) + face], out, n)) return -1;
            }
        }
        return n;
    }

    /// The same for the major diagonal of an octahedron.
    int OfMajorDiagonal(Index o, Index* out) const {
        int n = 0;
        for (int i = 0; i < Sdc::Oct::kFaces; ++i) {
            if (!AddDistinct(across_[OctPlace(o) + i], out, n)) return -1;
        }
        return n;
    }

  private:
    /// Where a cell's vertices across its faces start.
    Offset TetPlace(Index t) const { return Sdc::Tet::kFaces * static_cast<Offset>(t); }
    Offset OctPlace(Index o) const { return TetPlace(level_.n_tets) + Sdc::Oct::kFaces * static_cast<Offset>(o); }

    /// Calls body(face, apex, place) for each face of each tet and, cut along its major diagonal, of each octahedron:
    /// the apex is the cell's own vertex across the face.
    template <class Body>
    void ForCells(Body&& body) const {
        constexpr Offset kGrain = 4096;
        Sdc::ParallelFor(level_.n_tets, kGrain, [&](Offset begin, Offset end) {
            for (Index t = static_cast<Index>(begin); t < end; ++t) {
                const auto f = level_.TetFaces(t);
                const auto v = level_.TetVertices(t);
                for (int i = 0; i < Sdc::Tet::kFaces; ++i) body(f[i], v[i], TetPlace(t) + i);
            }
        });
        Sdc::ParallelFor(level_.n_octs, kGrain, [&](Offset begin, Offset end) {
            for (Index o = static_cast<Index>(begin); o < end; ++o) {
                const auto f = level_.OctFaces(o);
                const auto v = level_.OctVertices(o);
                for (int i = 0; i < Sdc::Oct::kFaces; ++i) {
                    body(f[i], v[i < Sdc::Oct::kFaces / 2 ? 1 : 0], OctPlace(o) + i);
                }
            }
        });
    }

    /// False if there is no vertex.
    static bool AddDistinct(Index v, Index* out, int& n) {
        if (v == kNoIndex) return false;
        int i = 0;  // the lists are short: std::find takes longer to start
        while (i < n && out[i] != v) ++i;
        out[n] = v;
        n += i == n;
        return true;
    }

    const Level& level_;
    Vtr::Relation edge_tets_;  // with locals: which edge of the tet
    Array<Index> across_;      // of each face of each cell: the vertex across it, or kNoIndex
};

/// Weighs a row of the two ends, the one-neighbours up to n and n_two two-neighbours after them (-1: incomplete,
/// the middle of the ends). A two-neighbour that is a one-neighbour too is one entry. Returns the row's length.
template <class Scheme, class Real>
int WeighTwoNeighbors(const Scheme& scheme, Index* indices, Real* weights, int n, int n_two) {
    weights[0] = weights[1] = static_cast<Real>(0.5);
    if (n_two < 0) return 2;
    const Sdc::TwoNeighborWeights w = scheme.Edge(n - 2, n_two);
    weights[0] = weights[1] = static_cast<Real>(w.end);
    std::fill(weights + 2, weights + n, static_cast<Real>(w.one));
    int length = n;
    for (int i = n; i < n + n_two; ++i) {
        int at = 0;
        while (at < n && indices[at] != indices[i]) ++at;
        if (at < n) {
            weights[at] += static_cast<Real>(w.two);
        } else {
            indices[length] = indices[i];
            weights[length++] = static_cast<Real>(w.two);
        }
    }
    return length;
}

}  // namespace SolidSubdiv::Far::Internal
