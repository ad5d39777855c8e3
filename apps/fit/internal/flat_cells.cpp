// SPDX-License-Identifier: Apache-2.0
// What edges of the boundary lie on, and cells held to that corner by corner.
#include <solidsubdiv/apps/fit/internal/flat_cells.h>

#include <algorithm>
#include <map>
#include <optional>

namespace SolidSubdiv::Fit::Internal {

namespace {

/// Patches on both sides of the boundary's edges.
class BoundaryPatches {
  public:
    explicit BoundaryPatches(const std::vector<TetCutter::Face>& faces) {
        for (const auto& f : faces) {
            for (std::size_t k = 0; k < 3; ++k) {
                at_[std::minmax({f.vertices[k], f.vertices[(k + 1) % 3]})].push_back(f.patch);
            }
        }
        for (const auto& [edge, patches] : at_) {
            if (patches.front() == patches.back()) continue;
            ++n_creases_[edge.first];
            ++n_creases_[edge.second];
        }
    }

    bool HasEdge(Index u, Index v) const { return at_.count(std::minmax({u, v})) > 0; }
    /// Whether edges from b lie in the tangent plane of one patch.
    bool AreInPlane(Index b, const std::array<Index, 3>& ends) const {
        const auto first = at_.find(std::minmax({b, ends[0]}));
        return first != at_.end() && std::any_of(first->second.begin(), first->second.end(), [&](Index patch) {
                   return HasPatch(b, ends[1], patch) && HasPatch(b, ends[2], patch);
               });
    }
    /// Whether two edges from b are one crease.
    bool AreStraight(Index b, Index u, Index v) const {
        const auto n = n_creases_.find(b);
        return n != n_creases_.end() && n->second == 2 && IsCrease(b, u) && IsCrease(b, v);
    }

  private:
    bool HasPatch(Index u, Index v, Index patch) const {
        const auto found = at_.find(std::minmax({u, v}));
        return found != at_.end() &&
               std::find(found->second.begin(), found->second.end(), patch) != found->second.end();
    }
    bool IsCrease(Index u, Index v) const {
        const auto found = at_.find(std::minmax({u, v}));
        return found != at_.end() && found->second.front() != found->second.back();
    }

    std::map<Edge, std::vector<Index>> at_;
    std::map<Index, int> n_creases_;
};

bool IsFlat(const Index* oct, const BoundaryPatches& boundary) {
    for (std::size_t k = 0; k < 6; ++k) {
        std::vector<Index> around;  // all but the opposite vertex
        for (std::size_t j = 0; j < 6; ++j) {
            if (j / 2 != k / 2) around.push_back(oct[j]);
        }
        for (std::size_t a = 0; a < 4; ++a) {
            if (boundary.AreInPlane(oct[k], {around[(a + 1) % 4], around[(a + 2) % 4], around[(a + 3) % 4]}))
                return true;
            for (std::size_t c = a + 1; c < 4; ++c) {
                if (boundary.AreStraight(oct[k], around[a], around[c])) return true;
            }
        }
    }
    return false;
}

/// A tet to cut: through an edge, or, where all that could be cut are on the boundary, with a vertex inside.
struct Flat {
    std::array<Index, 4> tet;
    std::optional<Edge> edge{};
};

std::optional<Flat> FlatCorner(const std::array<Index, 4>& tet, const BoundaryPatches& boundary) {
    for (std::size_t i = 0; i < 4; ++i) {
        const Index b = tet[i];
        const std::array<Index, 3> ends{tet[(i + 1) % 4], tet[(i + 2) % 4], tet[(i + 3) % 4]};
        for (std::size_t k = 0; k < 3; ++k) {
            const Edge edge(ends[k], ends[(k + 1) % 3]);
            if (boundary.AreStraight(b, edge.first, edge.second)) return Flat{tet, edge};
        }
        if (!boundary.AreInPlane(b, ends)) continue;
        for (std::size_t k = 0; k < 3; ++k) {
            const Edge edge(ends[k], ends[(k + 1) % 3]);
            if (!boundary.HasEdge(edge.first, edge.second)) return Flat{tet, edge};
        }
        return Flat{tet};
    }
    return {};
}

}  // namespace

void CutFlatCells(TetCutter& cutter) {
    constexpr int kMostPasses = 8;  // cutting an edge of the boundary makes new ones
    for (int pass = 0; pass < kMostPasses; ++pass) {
        const BoundaryPatches boundary(cutter.Faces());
        for (std::size_t o = 0; 6 * o < cutter.mesh().octs.size();) {
            if (IsFlat(&cutter.mesh().octs[6 * o], boundary)) {
                cutter.CutOct(o);
            } else {
                ++o;
            }
        }
        std::vector<Flat> flat;
        for (std::size_t t = 0; t < cutter.n_tets(); ++t) {
            if (const auto found = FlatCorner(cutter.Tet(t), boundary)) flat.push_back(*found);
        }
        if (flat.empty()) return;
        for (const Flat& f : flat) {
            bool is_there = false;  // cuts before this one may have changed it
            for (std::size_t t = 0; t < cutter.n_tets() && !is_there; ++t) is_there = cutter.Tet(t) == f.tet;
            if (!is_there) continue;
            if (f.edge) {
                cutter.CutEdge(f.edge->first, f.edge->second,
                               0.5 * (cutter.At(f.edge->first) + cutter.At(f.edge->second)));
            } else {
                cutter.CutTet(f.tet);
            }
        }
    }
}

}  // namespace SolidSubdiv::Fit::Internal
