// SPDX-License-Identifier: Apache-2.0
// The validator of diagonals: its definition by hand, and faults planted in a choice.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <utility>

#include "validation/diagonals.h"
#include "validation/meshes.h"
#include "validation/octet_truss.h"

namespace SolidSubdiv::Validation {
namespace {

TEST(DiagonalsOracle, FollowsTheDefinitionOnTwoTets) {
    // Both have the face (0 1 2); its edge 01 is chosen by the first tet.
    const std::array<int, 4> first = {0, 1, 2, 3};
    const MatchedFaces matched = CountMatchedFaces({{first, {1, 0, 2, 4}}, {}});
    EXPECT_EQ(matched.n_inner, 1);
    EXPECT_EQ(matched.n_matched, 1);
    EXPECT_EQ(CountMatchedFaces({{first, {0, 2, 1, 4}}, {}}).n_matched, 0);
    EXPECT_EQ(CountMatchedFaces({{first, {2, 4, 1, 0}}, {}}).n_matched, 1);  // 01 as the second edge of the pair
}

TEST(DiagonalsOracle, FollowsTheDefinitionOnATetAndAnOctahedron) {
    // Of the face (0 2 4) the octahedron with the diagonal 01 chooses the edge 24.
    const std::array<int, 6> oct = {0, 1, 2, 3, 4, 5};
    EXPECT_EQ(CountMatchedFaces({{{2, 4, 0, 6}}, {oct}}).n_matched, 1);
    EXPECT_EQ(CountMatchedFaces({{{0, 4, 2, 6}}, {oct}}).n_matched, 0);
    EXPECT_EQ(CountMatchedFaces({{{0, 4, 2, 6}}, {oct}}).n_inner, 1);
}

TEST(DiagonalsOracle, TellsOrientationKeptFromTurnedRound) {
    using Tet = std::array<int, 4>;
    EXPECT_TRUE(IsSameCell(Tet{5, 6, 7, 8}, Tet{5, 7, 8, 6}));
    EXPECT_TRUE(IsSameCell(Tet{5, 6, 7, 8}, Tet{6, 5, 8, 7}));
    EXPECT_FALSE(IsSameCell(Tet{5, 6, 7, 8}, Tet{6, 5, 7, 8}));
    EXPECT_FALSE(IsSameCell(Tet{5, 6, 7, 8}, Tet{5, 7, 8, 9}));
    using Oct = std::array<int, 6>;
    EXPECT_TRUE(IsSameCell(Oct{0, 1, 2, 3, 4, 5}, Oct{4, 5, 0, 1, 2, 3}));
    EXPECT_FALSE(IsSameCell(Oct{0, 1, 2, 3, 4, 5}, Oct{2, 3, 0, 1, 4, 5}));
}

class DiagonalsValidator : public testing::Test {
  protected:
    DiagonalsValidator() {
        const TrussBlock block = MakeTrussBlock({3, 3, 3}, TrussCells::Tets);
        shape_ = Shuffle({"block", "", {block.tets, block.octs}, std::vector<double>(3 * block.vertices.size())}, 9);
        cells_ = CellArrays(shape_.complex);
        choice_ = Choose(Far::DiagonalPolicy::Matched);
    }
    Far::DiagonalChoice Choose(Far::DiagonalPolicy policy) const {
        return Far::ChooseDiagonals(cells_.Descriptor(shape_.n_vertices()), policy);
    }

    SolidShape shape_;
    CellArrays cells_;
    Far::DiagonalChoice choice_;
    Findings findings_;
};

TEST_F(DiagonalsValidator, PassesOnTheFrameworksOwnChoice) {
    CompareChoice(shape_, choice_, 1.0, findings_);
    EXPECT_TRUE(findings_.Passes(0)) << findings_.where;
}

TEST_F(DiagonalsValidator, CatchesTooSmallAShare) {
    CompareChoice(shape_, Choose(Far::DiagonalPolicy::First), 1.0, findings_);
    EXPECT_TRUE(findings_.faults.empty());
    EXPECT_GT(findings_.largest_error, 0.2);
}

TEST_F(DiagonalsValidator, CatchesOneCellThatDisagrees) {
    auto& t = choice_.tets;
    std::rotate(t.begin() + 41, t.begin() + 42, t.begin() + 44);  // tet 10, another pair, orientation kept
    CompareChoice(shape_, choice_, 1.0, findings_);
    EXPECT_GT(findings_.largest_error, 0);
    EXPECT_THAT(findings_.faults, testing::ElementsAre(testing::HasSubstr("said to be matched")));
}

TEST_F(DiagonalsValidator, CatchesACellTurnedInsideOut) {
    std::swap(choice_.tets[0], choice_.tets[1]);  // keeps the pair, not the orientation
    CompareChoice(shape_, choice_, 1.0, findings_);
    EXPECT_THAT(findings_.faults, testing::ElementsAre(testing::HasSubstr("tets 0 changed")));
}

TEST_F(DiagonalsValidator, CatchesAWrongCount) {
    --choice_.n_matched_faces;
    CompareChoice(shape_, choice_, 1.0, findings_);
    EXPECT_FALSE(findings_.Passes(0));
}

}  // namespace
}  // namespace SolidSubdiv::Validation
