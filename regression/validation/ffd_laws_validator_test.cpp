// SPDX-License-Identifier: Apache-2.0
// The laws of free-form deformation: faults planted in what the framework made of a lattice that is right; steps by
// cells counted by hand.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <solidsubdiv/sdc/errors.h>

#include <algorithm>
#include <bit>
#include <numeric>

#include "validation/ffd_laws.h"
#include "validation/ffd_regular.h"

namespace SolidSubdiv::Validation {
namespace {

constexpr double kTolerance = 1e-12;  // that of the validator
using testing::Contains;
using testing::HasSubstr;

TEST(FfdStepsByCells, CountByHandInARowOfCells) {
    // Quadrilaterals 0 1 3 2, 2 3 5 4, 4 5 7 6 one after another, and a triangle that hangs by a corner; 10 is alone.
    const std::vector<std::vector<int>> cells = {{0, 1, 3, 2}, {2, 3, 5, 4}, {4, 5, 7, 6}, {7, 8, 9}};
    EXPECT_THAT(StepsByCells(cells, 11, 0), testing::ElementsAre(0, 1, 1, 1, 2, 2, 3, 3, 4, 4, -1));
    EXPECT_THAT(StepsByCells(cells, 11, 4), testing::ElementsAre(2, 2, 1, 1, 0, 1, 1, 1, 2, 2, -1));
}

TEST(FfdInBoxes, FindsTheBoxOfEachPointAndNamesAPointThatNoneHolds) {
    Deform::ControlLattice two;  // cubes side by side
    for (double z : {0, 1}) {
        for (double y : {0, 1}) {
            for (double x : {0, 1, 2}) two.positions.insert(two.positions.end(), {x, y, z});
        }
    }
    two.hexes = {0, 1, 4, 3, 6, 7, 10, 9, 1, 2, 5, 4, 7, 8, 11, 10};
    const FfdShape shape = InBoxes("two", two, {0.5, 0.5, 0.5, 1.5, 0.5, 1, 0, 0, 0});
    EXPECT_THAT(shape.homes, testing::ElementsAre(0, 1, 0));
    EXPECT_THROW(InBoxes("two", two, {0.5, 0.5, 0.5, 1.5, 0.5, 1.01}), InvalidInput);
}

class FfdLawsValidator : public testing::Test {
  protected:
    FfdLawsValidator()
        : shape_(DrawFfdShape("row", block_.View(), block_.control, 300, 1)), embedding_(Embed(shape_.points)) {
        std::vector<Index> all(300);
        std::iota(all.begin(), all.end(), 0);
        rows_ = embedding_.ControlRows(all);
        move_ = MoveOne(embedding_, shape_.control, 0);
        const auto is_affected = [&](Index v) {
            return std::find(move_.affected.begin(), move_.affected.end(), v) != move_.affected.end();
        };
        for (Index v : all) (is_affected(v) ? touched_ : untouched_) = static_cast<std::size_t>(v);
    }
    Deform::Embedding Embed(const std::vector<double>& points) const {
        return Deform::Embedding::Create(block_.View(), block_.control, points, {.levels = 2});
    }
    std::vector<std::string> FaultsOfMove() const {
        Findings findings;
        CheckMove(shape_, rows_, move_, true, findings);
        EXPECT_GT(findings.n_compared, 0);
        return findings.faults;
    }

    DeformedBlock block_{{9, 2, 1}, 1};
    FfdShape shape_;
    Deform::Embedding embedding_;
    Far::StencilRows<double> rows_;
    FfdMove move_;
    std::size_t touched_ = 0, untouched_ = 0;
};

TEST_F(FfdLawsValidator, PassesOnTheFrameworksOwn) {
    EXPECT_THAT(FaultsOfMove(), testing::IsEmpty());
    Findings bits;
    CompareBits(embedding_, Embed(shape_.points), shape_.control, bits);
    EXPECT_TRUE(bits.Passes(kTolerance));
}

TEST_F(FfdLawsValidator, CatchesPointsThatAreALittleOff) {
    std::vector<double> found = shape_.points;
    const auto passes = [&] {
        Findings findings;
        ComparePoints(shape_.points, found, 1, "at rest", findings);
        return findings.Passes(kTolerance);
    };
    EXPECT_TRUE(passes());
    found[4] += 1e-11;
    EXPECT_FALSE(passes());
    found.resize(found.size() - 3);
    EXPECT_FALSE(passes());
}

TEST_F(FfdLawsValidator, CatchesOneOtherBit) {
    std::vector<double> points = shape_.points;
    points[5] = std::bit_cast<double>(std::bit_cast<std::uint64_t>(points[5]) + 64);  // more than rounding hides
    Findings findings;
    CompareBits(embedding_, Embed(points), shape_.control, findings);
    EXPECT_THAT(findings.faults, Contains("embedded twice, other points"));
}

TEST_F(FfdLawsValidator, CatchesAnAffectedSetWithAPointTooManyOrTooFew) {
    move_.affected.push_back(static_cast<Index>(untouched_));
    EXPECT_THAT(FaultsOfMove(), Contains(HasSubstr("is not that of the rows")));
    move_.affected.clear();
    EXPECT_THAT(FaultsOfMove(), Contains(HasSubstr("is not that of the rows")));
}

TEST_F(FfdLawsValidator, CatchesAPointThatAnUpdateLeavesOut) {
    std::erase(move_.written, static_cast<Index>(touched_));
    EXPECT_THAT(FaultsOfMove(), Contains(HasSubstr("left out by an update")));
}

TEST_F(FfdLawsValidator, CatchesABitThatChangesWhereNothingMoves) {
    double& x = move_.updated[3 * untouched_];
    x = move_.deformed[3 * untouched_] = std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) ^ 1);
    EXPECT_THAT(FaultsOfMove(), Contains(HasSubstr("changed by a move")));
}

TEST_F(FfdLawsValidator, CatchesAnUpdateThatIsNotWhatDeformingAllGives) {
    double& x = move_.updated[3 * touched_ + 1];
    x = std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) ^ 1);
    EXPECT_THAT(FaultsOfMove(), Contains(HasSubstr("gives other bits")));
}

TEST_F(FfdLawsValidator, CatchesAControlPointThatReachesTooFar) {
    shape_.homes[touched_] = 3;  // the fourth along the row: its far side is four steps from the first control point
    EXPECT_THAT(FaultsOfMove(), Contains(HasSubstr("not in N_p,3")));
    shape_.homes[touched_] = 2;
    EXPECT_THAT(FaultsOfMove(), testing::IsEmpty());
}

}  // namespace
}  // namespace SolidSubdiv::Validation
