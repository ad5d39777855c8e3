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
        apex_sums_.assign(static_cast<std::size_t>(level.n_faces), 0);
        // Sums of whole numbers are the same in any order.
        const bool is_alone = Sdc::ThreadCount() == 1;
        const auto add = [&](Index face, Index apex) {
            if (is_alone) {
                apex_sums_[face] += static_cast<std::uint32_t>(apex);
            } else {
                std::atomic_ref(apex_sums_[face])
                    .fetch_add(static_cast<std::uint32_t>(apex), std::memory_order_relaxed);
            }
        };
        constexpr Offset kGrain = 4096;
        Sdc::ParallelFor(level.n_tets, kGrain, [&](Offset begin, Offset end) {
            for (Offset t = begin; t < end; ++t) {
                const auto f = level.TetFaces(static_cast<Index>(t));
                const auto v = level.TetVertices(static_cast<Index>(t));
                for (int i = 0; i < Sdc::Tet::kFaces; ++i) add(f[i], v[i]);
            }
        });
        Sdc::ParallelFor(level.n_octs, kGrain, [&](Offset begin, Offset end) {
            for (Offset o = begin; o < end; ++o) {
                const auto f = level.OctFaces(static_cast<Index>(o));
                const auto v = level.OctVertices(static_cast<Index>(o));
                for (int i = 0; i < Sdc::Oct::kFaces; ++i) add(f[i], v[OwnApex(i)]);
            }
        });
        Sdc::ParallelFor(level.n_faces, kGrain, [&](Offset begin, Offset end) {
            for (Offset f = begin; f < end; ++f) {
                if (level.face_tags[f].n_cells() < 2) apex_sums_[f] = kNothing;
            }
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
            const auto v = level_.TetVertices(tets[k]);
            const auto f = level_.TetFaces(tets[k]);
            for (Sdc::Local end : Sdc::Tet::edges[tet_locals[k]]) {
                if (!AddAcross(f[end], v[end], out, n)) return -1;
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
                if (!AddAcross(level_.OctFaces(octs[k])[face], v[i], out, n)) return -1;
            }
        }
        return n;
    }

    /// The same for the major diagonal of an octahedron.
    int OfMajorDiagonal(Index o, Index* out) const {
        int n = 0;
        const auto v = level_.OctVertices(o);
        const auto f = level_.OctFaces(o);
        for (int i = 0; i < Sdc::Oct::kFaces; ++i) {
            if (!AddAcross(f[i], v[OwnApex(i)], out, n)) return -1;
        }
        return n;
    }

  private:
    /// The end of the major diagonal that face i of an octahedron does not have: the apex of the tet at that face.
    static constexpr int OwnApex(int i) { return i < Sdc::Oct::kFaces / 2 ? 1 : 0; }

    /// False if there is nothing across.
    bool AddAcross(Index face, Index own_apex, Index* out, int& n) const {
        const std::uint32_t sum = apex_sums_[face];
        if (sum == kNothing) return false;
        AddDistinct(static_cast<Index>(sum - static_cast<std::uint32_t>(own_apex)), out, n);
        return true;
    }
    static void AddDistinct(Index v, Index* out, int& n) {
        int i = 0;  // the lists are short: std::find takes longer to start
        while (i < n && out[i] != v) ++i;
        out[n] = v;
        n += i == n;
    }

    static constexpr std::uint32_t kNothing = ~std::uint32_t{0};  // no sum of two indices

    const Level& level_;
    Vtr::Relation edge_tets_;               // with locals: which edge of the tet
    std::vector<std::uint32_t> apex_sums_;  // of each face between cells: their vertices across it, summed
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
