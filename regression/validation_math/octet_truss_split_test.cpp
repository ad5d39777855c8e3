// SPDX-License-Identifier: Apache-2.0
// The splits of tets and octahedra, applied to blocks: which block comes out, and that the conventions survive.
#include <gtest/gtest.h>

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "validation/octet_truss.h"
#include "validation_math/truss_checks.h"

namespace SolidSubdiv::Validation {
namespace {

// The splits of the rules, section 1, on doubled coordinates. Written here once more so that the block's own pattern
// has a judge.
struct Split {
    explicit Split(const TrussBlock& coarse, const TrussBlock& fine) : coarse_(coarse), fine_(fine) {}

    void OfTet(const Tet& v) {
        const auto m = [&](int i, int j) { return Mid(v[i], v[j]); };
        tets.push_back({Mid(v[0], v[0]), m(0, 1), m(0, 2), m(0, 3)});
        tets.push_back({m(0, 1), Mid(v[1], v[1]), m(1, 2), m(1, 3)});
        tets.push_back({m(0, 2), m(1, 2), Mid(v[2], v[2]), m(2, 3)});
        tets.push_back({m(0, 3), m(1, 3), m(2, 3), Mid(v[3], v[3])});
        octs.push_back({m(0, 1), m(2, 3), m(0, 2), m(1, 3), m(0, 3), m(1, 2)});
    }

    void OfOct(const Oct& v) {
        const int c = Mid(v[0], v[1]);
        for (int corner = 0; corner < 6; ++corner) {
            Oct child{};
            for (int j = 0; j < 6; ++j) child[j] = j / 2 == corner / 2 ? c : Mid(v[corner], v[j]);
            child[corner] = Mid(v[corner], v[corner]);
            octs.push_back(child);
        }
        for (int face = 0; face < 8; ++face) {
            const int second_a = face & 1, second_b = (face >> 1) & 1, second_d = (face >> 2) & 1;
            const int a = v[second_a], b = v[2 + second_b], d = v[4 + second_d];
            Tet child = {c, Mid(b, d), Mid(a, b), Mid(a, d)};
            if ((second_a + second_b + second_d) % 2 == 1) std::swap(child[2], child[3]);
            tets.push_back(child);
        }
    }

    int Mid(int a, int b) const {
        const LatticePoint &p = coarse_.vertices[a], &q = coarse_.vertices[b];
        return fine_.VertexAt({p[0] + q[0], p[1] + q[1], p[2] + q[2]});
    }

    std::vector<Tet> tets;
    std::vector<Oct> octs;

  private:
    const TrussBlock& coarse_;
    const TrussBlock& fine_;
};

// An octahedron up to symmetries that keep its diagonal: the diagonal, and the two other pairs.
std::pair<Edge, std::set<Edge>> Canonical(const Oct& o) {
    return {MakeEdge(o[0], o[1]), {MakeEdge(o[2], o[3]), MakeEdge(o[4], o[5])}};
}

std::set<std::pair<Edge, std::set<Edge>>> Canonical(const std::vector<Oct>& octs) {
    std::set<std::pair<Edge, std::set<Edge>>> result;
    for (const Oct& o : octs) result.insert(Canonical(o));
    return result;
}

TEST(OctetTrussSplit, OfTheBlockOfTetsIsRefinedOnce) {
    const TrussBlock coarse = MakeTrussBlock({2, 2, 3}, TrussCells::Tets);
    const TrussBlock fine = MakeTrussBlock({4, 4, 6}, TrussCells::RefinedOnce);
    Split split(coarse, fine);
    for (const Tet& t : coarse.tets) split.OfTet(t);
    EXPECT_EQ(Cells(split.tets), Cells(fine.tets));
    EXPECT_EQ(Canonical(split.octs), Canonical(fine.octs));

    // The split keeps the conventions: the children are positive and ordered by their B edges as the rules write them.
    TrussBlock children = fine;
    children.tets = split.tets;
    children.octs = split.octs;
    EXPECT_EQ(CellDefects(children), std::vector<std::string>());
}

TEST(OctetTrussSplit, OfParallelDiagonalsKeepsThemParallel) {
    for (int axis = 0; axis < 3; ++axis) {
        const TrussBlock coarse = MakeTrussBlock({3, 3, 3}, TrussCells::ParallelDiagonals, axis);
        const TrussBlock fine = MakeTrussBlock({6, 6, 6}, TrussCells::ParallelDiagonals, axis);
        LatticePoint direction = {1, 1, 1};
        direction[axis] = 0;
        Split split(coarse, fine);
        for (const Oct& o : coarse.octs) split.OfOct(o);
        // Halves of octahedra at the block's sides have a B edge along the diagonals; their own diagonal is another
        // one.
        for (const Tet& t : coarse.tets) {
            const LatticePoint first = Difference(coarse.vertices[t[0]], coarse.vertices[t[1]]);
            const LatticePoint second = Difference(coarse.vertices[t[2]], coarse.vertices[t[3]]);
            const auto along = [&direction](const LatticePoint& d) {
                return d == direction || d == LatticePoint{-direction[0], -direction[1], -direction[2]};
            };
            if (!along(first) && !along(second)) split.OfTet(t);
        }
        const auto fine_tets = Cells(fine.tets);
        for (const std::set<int>& tet : Cells(split.tets)) EXPECT_EQ(fine_tets.count(tet), 1U);
        const auto fine_octs = Canonical(fine.octs);
        for (const auto& oct : Canonical(split.octs)) EXPECT_EQ(fine_octs.count(oct), 1U);
        EXPECT_EQ(split.octs.size(), 6 * coarse.octs.size() + (split.tets.size() - 8 * coarse.octs.size()) / 4);

        TrussBlock children = fine;
        children.tets = split.tets;
        children.octs = split.octs;
        EXPECT_EQ(CellDefects(children), std::vector<std::string>());
    }
}

}  // namespace
}  // namespace SolidSubdiv::Validation
