// SPDX-License-Identifier: Apache-2.0
// The counts of octree lattices pass, and catch cells that are missing, too many or given twice, and corners apart.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <solidsubdiv/kit/io/formats.h>

#include "validation/lattice_counts.h"

namespace SolidSubdiv::Validation {
namespace {

using testing::Contains;
using testing::HasSubstr;

constexpr int kLevel = 4;

class LatticeCountsValidator : public testing::Test {
  protected:
    LatticeCountsValidator()
        : points_(Io::ReadMesh(std::filesystem::path(SOLIDSUBDIV_SHAPES) / "demo" / "bunny.obj").positions),
          lattice_(Deform::MakeOctreeLattices(points_, {}, {.levels = kLevel}).levels.back().lattice) {}
    Findings Compare() const {
        Findings findings;
        CompareWithPoints(lattice_, kLevel, points_, findings);
        return findings;
    }

    std::vector<double> points_;
    Deform::ControlLattice lattice_;
};

TEST_F(LatticeCountsValidator, PassesOnTheFrameworksOwn) { EXPECT_TRUE(Compare().Passes(0)) << Compare().where; }

TEST_F(LatticeCountsValidator, CatchesACellThatIsMissing) {
    lattice_.hexes.resize(lattice_.hexes.size() - 8);
    EXPECT_THAT(Compare().faults, Contains(HasSubstr("is in no cell")));
}

TEST_F(LatticeCountsValidator, CatchesCellsThatHoldNothing) {
    lattice_ =
        Deform::MakeOctreeLattices(points_, {}, {.levels = kLevel, .cut = Deform::Cut::None}).levels.back().lattice;
    EXPECT_THAT(Compare().faults, Contains(HasSubstr("holds no point")));
}

TEST_F(LatticeCountsValidator, CatchesACellThatIsGivenTwice) {
    std::vector<Index>& hexes = lattice_.hexes;
    const std::vector<Index> first(hexes.begin(), hexes.begin() + 8);
    hexes.insert(hexes.end(), first.begin(), first.end());
    EXPECT_EQ(Compare().largest_error, 1);
}

TEST_F(LatticeCountsValidator, CatchesACornerThatCellsDoNotShare) {
    const auto v = static_cast<std::size_t>(lattice_.hexes[0]);
    const std::vector<double> corner(&lattice_.positions[3 * v], &lattice_.positions[3 * v] + 3);
    lattice_.positions.insert(lattice_.positions.end(), corner.begin(), corner.end());
    lattice_.hexes[0] = lattice_.n_control_points() - 1;
    EXPECT_EQ(Compare().largest_error, 1);
}

TEST_F(LatticeCountsValidator, CatchesALevelOfOtherNumbersThanTheTables) {
    const std::vector<double> cube = {0, 0, 0, 1, 1, 1};
    auto levels = Deform::MakeOctreeLattices(cube, {}, {.levels = 5, .cut = Deform::Cut::None}).levels;
    Findings right, wrong, fewer;
    CompareWithTable(levels, right);
    EXPECT_TRUE(right.Passes(0));
    levels[3].lattice.hexes.resize(8 * 511);
    CompareWithTable(levels, wrong);
    EXPECT_EQ(wrong.largest_error, 1);
    EXPECT_EQ(wrong.where, "511 cells of level 3, expected 512");
    CompareWithTable(std::span(levels).first(3), fewer);
    EXPECT_EQ(fewer.largest_error, 3);
}

}  // namespace
}  // namespace SolidSubdiv::Validation
