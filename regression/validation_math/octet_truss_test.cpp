// SPDX-License-Identifier: Apache-2.0
// The octet-truss blocks: positive cells that fill the block, the right kinds and rings of edges, and the splits of the
// rules.
#include "validation/octet_truss.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "validation_math/truss_checks.h"

namespace SolidSubdiv::Validation {
namespace {

struct Case {
    const char* name;
    LatticePoint size;
    TrussCells cells;
    int axis;
};
class OctetTruss : public testing::TestWithParam<Case> {
  protected:
    TrussBlock block_ = MakeTrussBlock(GetParam().size, GetParam().cells, GetParam().axis);
};

TEST_P(OctetTruss, CellsArePositiveAndOrderedByTheirBEdges) {
    EXPECT_EQ(CellDefects(block_), std::vector<std::string>());
    TrussBlock view = block_;
    view.tets = TetrahedralView(block_);
    view.octs.clear();
    EXPECT_EQ(CellDefects(view), std::vector<std::string>());
}

TEST_P(OctetTruss, VolumesSumToTheBlock) {
    int volume = 0;
    for (const Tet& t : TetrahedralView(block_)) volume += SixVolumesOf(block_, t);
    EXPECT_EQ(volume, 6 * block_.size[0] * block_.size[1] * block_.size[2]);
}

// With positive cells whose volumes sum to the block's: each inner face twice, from its two sides, means no gap and no
// overlap.
TEST_P(OctetTruss, InnerFacesBelongToTwoCellsFromBothSides) {
    std::map<std::set<int>, std::vector<std::vector<int>>> faces;
    const auto add = [&faces](std::vector<int> face) {
        std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
        faces[{face.begin(), face.end()}].push_back(face);
    };
    for (const Tet& t : block_.tets) {
        add({t[0], t[1], t[2]});
        add({t[0], t[3], t[1]});
        add({t[0], t[2], t[3]});
        add({t[1], t[3], t[2]});
    }
    for (const Oct& o : block_.octs)
        for (int corner = 0; corner < 8; ++corner) {
            const int a = corner & 1, b = (corner >> 1) & 1, c = (corner >> 2) & 1;
            // An odd number of second vertices mirrors the face; positive tets see theirs as 0 1 2, octahedra as 0 2 4.
            if ((a + b + c) % 2 == 0)
                add({o[a], o[2 + b], o[4 + c]});
            else
                add({o[a], o[4 + c], o[2 + b]});
        }
    for (const auto& [corners, copies] : faces) {
        const std::vector<int> v(corners.begin(), corners.end());
        const bool boundary =
            OnBoundary(block_, v[0], v[1]) && OnBoundary(block_, v[1], v[2]) && OnBoundary(block_, v[0], v[2]);
        const auto flat = [&](int axis) {
            return block_.vertices[v[0]][axis] == block_.vertices[v[1]][axis] &&
                   block_.vertices[v[0]][axis] == block_.vertices[v[2]][axis];
        };
        if (boundary && (flat(0) || flat(1) || flat(2))) {
            EXPECT_EQ(copies.size(), 1U);
        } else {
            ASSERT_EQ(copies.size(), 2U);
            EXPECT_NE(copies[0], copies[1]);
        }
    }
}

TEST_P(OctetTruss, InnerEdgesHaveSixTetsAroundAAndFourAroundB) {
    std::map<Edge, int> ring;
    for (const Tet& t : TetrahedralView(block_))
        for (int i = 0; i < 4; ++i)
            for (int j = i + 1; j < 4; ++j) ++ring[MakeEdge(t[i], t[j])];
    for (const auto& [edge, count] : ring) {
        const EdgeKind kind = Kind(block_, edge.first, edge.second);
        EXPECT_NE(kind, EdgeKind::None);
        if (OnBoundary(block_, edge.first, edge.second)) continue;
        EXPECT_EQ(count, kind == EdgeKind::A ? 6 : 4);
    }
}

TEST_P(OctetTruss, InnerVerticesHaveEightANeighboursAndSixB) {
    std::map<int, std::set<int>> neighbours[2];
    for (const Tet& t : TetrahedralView(block_))
        for (int i = 0; i < 4; ++i)
            for (int j = 0; j < 4; ++j)
                if (i != j) neighbours[Kind(block_, t[i], t[j]) == EdgeKind::B][t[i]].insert(t[j]);
    int inner = 0;
    for (int v = 0; v < static_cast<int>(block_.vertices.size()); ++v) {
        if (OnBoundary(block_, v, v)) continue;
        ++inner;
        EXPECT_EQ(neighbours[0][v].size(), 8U);
        EXPECT_EQ(neighbours[1][v].size(), 6U);
    }
    EXPECT_EQ(inner, (block_.size[0] - 1) * (block_.size[1] - 1) * (block_.size[2] - 1));
}

// The choice of diagonals is not seen in the tetrahedral view; in the terms of the rules, all faces are matched.
TEST_P(OctetTruss, TetrahedralViewIsTheBlockOfTets) {
    const TrussBlock tets = MakeTrussBlock(block_.size, TrussCells::Tets);
    EXPECT_EQ(Cells(TetrahedralView(block_)), Cells(tets.tets));
    EXPECT_EQ(block_.tets.size() + 4 * block_.octs.size(), tets.tets.size());
}

TEST_P(OctetTruss, VerticesAreFoundByTheirCoordinates) {
    for (int v = 0; v < static_cast<int>(block_.vertices.size()); ++v) {
        EXPECT_EQ(block_.VertexAt(block_.vertices[v]), v);
        EXPECT_TRUE(block_.Contains(block_.vertices[v]));
    }
    EXPECT_FALSE(block_.Contains({0, 0, block_.size[2] + 1}));
    EXPECT_FALSE(block_.Contains({0, -1, 0}));
}

INSTANTIATE_TEST_SUITE_P(Blocks, OctetTruss,
                         testing::Values(Case{"Tets", {3, 2, 4}, TrussCells::Tets, 2},
                                         Case{"OneCube", {1, 1, 1}, TrussCells::Tets, 2},
                                         Case{"ParallelX", {4, 3, 2}, TrussCells::ParallelDiagonals, 0},
                                         Case{"ParallelY", {4, 3, 2}, TrussCells::ParallelDiagonals, 1},
                                         Case{"ParallelZ", {3, 4, 5}, TrussCells::ParallelDiagonals, 2},
                                         Case{"RefinedOnce", {4, 6, 4}, TrussCells::RefinedOnce, 2}),
                         [](const auto& param_info) { return param_info.param.name; });

TEST(OctetTrussCounts, AreThoseOfTheRules) {
    const TrussBlock tets = MakeTrussBlock({2, 3, 4}, TrussCells::Tets);
    EXPECT_EQ(tets.tets.size(), 6U * 2 * 3 * 4);
    EXPECT_EQ(tets.octs.size(), 0U);
    // One split: T' = 4 T, O' = T.
    const TrussBlock refined = MakeTrussBlock({4, 6, 8}, TrussCells::RefinedOnce);
    EXPECT_EQ(refined.tets.size(), 4 * tets.tets.size());
    EXPECT_EQ(refined.octs.size(), tets.tets.size());
    // Octahedra sit at the inner unit squares across the axis; away from those sides there are two tets to one
    // octahedron.
    const TrussBlock parallel = MakeTrussBlock({2, 3, 4}, TrussCells::ParallelDiagonals, 2);
    EXPECT_EQ(parallel.octs.size(), 2U * 3 * 3);
    EXPECT_EQ(parallel.tets.size(), 6U * 24 - 4 * 18);
}

TEST(OctetTrussCounts, OctahedraOfOneDirectionLeaveTwelveEdgesAtAnInnerVertex) {
    const TrussBlock block = MakeTrussBlock({4, 4, 4}, TrussCells::ParallelDiagonals, 1);
    const int centre = block.VertexAt({2, 2, 2});
    std::set<int> edges, diagonals;
    for (const Tet& t : block.tets)
        if (std::find(t.begin(), t.end(), centre) != t.end()) edges.insert(t.begin(), t.end());
    for (const Oct& o : block.octs)
        for (int i = 0; i < 6; ++i) {
            if (o[i] != centre) continue;
            if (i < 2) diagonals.insert(o[1 - i]);
            for (int j = 0; j < 6; ++j)
                if (j / 2 != i / 2) edges.insert(o[j]);
        }
    edges.erase(centre);
    EXPECT_EQ(edges.size(), 12U);
    EXPECT_EQ(diagonals, (std::set<int>{block.VertexAt({1, 2, 1}), block.VertexAt({3, 2, 3})}));
}

TEST(OctetTrussEdges, FourteenDirectionsAreOfKindAOrB) {
    int a = 0, b = 0;
    for (int x = -2; x <= 2; ++x)
        for (int y = -2; y <= 2; ++y)
            for (int z = -2; z <= 2; ++z) {
                const EdgeKind kind = ClassifyEdge({5, 6, 7}, {5 + x, 6 + y, 7 + z});
                a += kind == EdgeKind::A;
                b += kind == EdgeKind::B;
            }
    EXPECT_EQ(a, 8);
    EXPECT_EQ(b, 6);
    for (int i = 0; i < 4; ++i) {
        const LatticePoint u = kDirections[i];
        EXPECT_EQ(ClassifyEdge({0, 0, 0}, u), EdgeKind::A);
        EXPECT_EQ(ClassifyEdge(u, {0, 0, 0}), EdgeKind::A);
        for (int j = 0; j < 4; ++j) {
            const LatticePoint w = {u[0] + kDirections[j][0], u[1] + kDirections[j][1], u[2] + kDirections[j][2]};
            EXPECT_EQ(ClassifyEdge({0, 0, 0}, w), i == j ? EdgeKind::None : EdgeKind::B);
        }
    }
}

TEST(OctetTrussEdges, BccPositionsMakeTheTwoKindsOfEqualLength) {
    const auto length2 = [](const LatticePoint& d) {
        const auto p = BccPosition({1.0 * d[0], 1.0 * d[1], 1.0 * d[2]});
        return p[0] * p[0] + p[1] * p[1] + p[2] * p[2];
    };
    for (int i = 0; i < 4; ++i) {
        EXPECT_EQ(length2(kDirections[i]), 3);
        for (int j = 0; j < i; ++j)
            EXPECT_EQ(length2({kDirections[i][0] + kDirections[j][0], kDirections[i][1] + kDirections[j][1],
                               kDirections[i][2] + kDirections[j][2]}),
                      4);
    }
    // Orientation is kept: det(u1, u2, u3) = 1 becomes 4, the volume of a cell of the BCC lattice with these points.
    const auto a = BccPosition({1, 0, 0}), b = BccPosition({0, 1, 0}), c = BccPosition({0, 0, 1});
    const double determinant =
        a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
    EXPECT_EQ(determinant, 4);
}

TEST(OctetTrussInput, RefusesSizesAndAxesThatMakeNoBlock) {
    EXPECT_THROW(MakeTrussBlock({0, 2, 2}, TrussCells::Tets), std::invalid_argument);
    EXPECT_THROW(MakeTrussBlock({2, 3, 2}, TrussCells::RefinedOnce), std::invalid_argument);
    EXPECT_THROW(MakeTrussBlock({2, 2, 2}, TrussCells::ParallelDiagonals, 3), std::invalid_argument);
}

TEST(OctetTrussFault, SwappedAndMisorderedCellsAreNoticed) {
    const TrussBlock good = MakeTrussBlock({2, 2, 2}, TrussCells::RefinedOnce);
    TrussBlock swapped = good;
    std::swap(swapped.tets[7][2], swapped.tets[7][3]);
    EXPECT_EQ(CellDefects(swapped), std::vector<std::string>{"tet: volume"});
    TrussBlock wrong_pair = good;  // an even permutation: still positive, but another pair of edges comes first
    wrong_pair.tets[3] = {good.tets[3][0], good.tets[3][2], good.tets[3][3], good.tets[3][1]};
    EXPECT_EQ(CellDefects(wrong_pair), std::vector<std::string>(4, "tet: edge kind"));
    TrussBlock mirrored = good;
    std::swap(mirrored.octs[1][4], mirrored.octs[1][5]);
    EXPECT_EQ(CellDefects(mirrored), std::vector<std::string>{"oct: orientation"});
}

}  // namespace
}  // namespace SolidSubdiv::Validation
