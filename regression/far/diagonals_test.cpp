// SPDX-License-Identifier: Apache-2.0
// Choices of diagonals: each policy does what it says, cells keep their orientation, ties are decided.
#include <gtest/gtest.h>
#include <solidsubdiv/far/choose_diagonals.h>

#include "far/far_testing.h"

namespace {

using namespace SolidSubdiv;
using namespace SolidSubdiv::TestFar;
using Far::DiagonalPolicy;

bool IsEvenPermutation(const Index* a, const Index* b, int n) {
    int inversions = 0;
    std::vector<int> order;
    for (int i = 0; i < n; ++i) order.push_back(static_cast<int>(std::find(b, b + n, a[i]) - b));
    for (int i = 0; i < n; ++i) {
        for (int j = i + 1; j < n; ++j) inversions += order[i] > order[j];
    }
    return inversions % 2 == 0;
}

TEST(ChooseDiagonalsTest, ReorderingKeepsOrientationAndBringsThePairToTheFront) {
    const auto s = TestShapes::OctsAndTets();
    for (std::uint8_t pair = 0; pair < 3; ++pair) {
        const std::vector<std::uint8_t> given(4, pair);
        const auto choice = Far::ChooseDiagonals(Describe(s), DiagonalPolicy::Given, {}, given);
        EXPECT_EQ(choice.diagonals, given);
        for (int t = 0; t < 2; ++t) {
            EXPECT_TRUE(IsEvenPermutation(&s.tets[4 * t], &choice.tets[4 * t], 4));
            EXPECT_EQ(choice.tets[4 * t], s.tets[4 * t]);
            EXPECT_EQ(choice.tets[4 * t + 1], s.tets[4 * t + 1 + pair]);
        }
        for (int o = 0; o < 2; ++o) {
            EXPECT_TRUE(IsEvenPermutation(&s.octs[6 * o], &choice.octs[6 * o], 6));
            EXPECT_EQ(choice.octs[6 * o], s.octs[6 * o + 2 * pair]);
            EXPECT_EQ(choice.octs[6 * o + 1], s.octs[6 * o + 2 * pair + 1]);
        }
    }
}

TEST(ChooseDiagonalsTest, ShortestTakesTheShortestAndTiesGoToTheLowestPair) {
    auto s = TestShapes::SingleTet();
    s.positions = {1, 1, 1, 1, -1, -1, -1, 1, -1, -1, -1, 1};  // regular: all three tie
    EXPECT_EQ(Far::ChooseDiagonals(Describe(s), DiagonalPolicy::Shortest, s.positions).diagonals[0], 0);
    for (int pair = 0; pair < 3;
         ++pair) {  // squeezed along the axis of one pair's diagonal: 01|23 is x, 02|13 y, 03|12 z
        auto squeezed = s.positions;
        for (int v = 0; v < 4; ++v) squeezed[3 * v + pair] *= 0.5;
        EXPECT_EQ(Far::ChooseDiagonals(Describe(s), DiagonalPolicy::Shortest, squeezed).diagonals[0], pair);
    }
    EXPECT_THROW(Far::ChooseDiagonals(Describe(s), DiagonalPolicy::Shortest), InvalidInput);
}

TEST(ChooseDiagonalsTest, MatchedIsAtLeastAsGoodAsAnyOtherPolicy) {
    for (const auto& [name, shape] : TestShapes::AllShapes()) {
        SCOPED_TRACE(name);
        const auto d = Describe(shape);
        const double matched = Far::ChooseDiagonals(d, DiagonalPolicy::Matched).MatchedShare();
        EXPECT_GE(matched, Far::ChooseDiagonals(d, DiagonalPolicy::First).MatchedShare());
        EXPECT_GE(matched, Far::ChooseDiagonals(d, DiagonalPolicy::Shortest, shape.positions).MatchedShare());
    }
}

TEST(ChooseDiagonalsTest, RefinedMeshesAreMatchedInsideEveryCellAndAcrossMatchedFaces) {
    const auto refiner = Refined(TestShapes::SingleTet(), 2, true);
    const auto s = AsShape(refiner.level(2), std::vector<double>(3 * refiner.level(2).n_vertices));
    EXPECT_EQ(Far::ChooseDiagonals(Describe(s), DiagonalPolicy::First).MatchedShare(), 1.0);
    const auto oct = Refined(TestShapes::SingleOct(), 2, true);
    const auto t = AsShape(oct.level(2), std::vector<double>(3 * oct.level(2).n_vertices));
    EXPECT_EQ(Far::ChooseDiagonals(Describe(t), DiagonalPolicy::First).MatchedShare(), 1.0);
    EXPECT_EQ(Far::ChooseDiagonals(Describe(t), DiagonalPolicy::Matched).MatchedShare(), 1.0);
}

TEST(ChooseDiagonalsTest, IsTheSameEveryTime) {
    const auto s = TestShapes::RandomSubset(TestShapes::KuhnBlock(4), 80, 4);
    EXPECT_EQ(Far::ChooseDiagonals(Describe(s), DiagonalPolicy::Matched).diagonals,
              Far::ChooseDiagonals(Describe(s), DiagonalPolicy::Matched).diagonals);
}

TEST(ChooseDiagonalsTest, RefusesBadGivenValuesAndNames) {
    const auto s = TestShapes::SingleTet();
    const std::vector<std::uint8_t> bad{3}, many{0, 0};
    EXPECT_THROW(Far::ChooseDiagonals(Describe(s), DiagonalPolicy::Given, {}, bad), InvalidInput);
    EXPECT_THROW(Far::ChooseDiagonals(Describe(s), DiagonalPolicy::Given, {}, many), InvalidInput);
    EXPECT_THROW(Far::DiagonalPolicyOf("longest"), InvalidInput);
    EXPECT_EQ(Far::DiagonalPolicyOf("shortest"), DiagonalPolicy::Shortest);
}

}  // namespace
