// SPDX-License-Identifier: Apache-2.0
// Orientation: repair makes cells positive and keeps their pairs; keep and refuse do what they say.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <solidsubdiv/kit/geometry/cell_volume.h>
#include <solidsubdiv/kit/geometry/orientation.h>
#include <solidsubdiv/sdc/errors.h>

#include <array>
#include <set>

namespace SolidSubdiv::Geometry {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

// A positive tet's corners, a flat fourth corner, and a positive octahedron.
const std::vector<double> kPositions = {0, 0, 0, 1, 0, 0,  0, 1, 0, 0, 0,  1, 1, 1, 0,  //
                                        0, 0, 1, 0, 0, -1, 0, 1, 0, 0, -1, 0, 1, 0, 0, -1, 0, 0};
const std::vector<Index> kTets = {0, 1, 2, 3, 0, 1, 3, 2, 0, 1, 2, 4};
const std::vector<Index> kOcts = {5, 6, 7, 8, 9, 10, 5, 6, 7, 8, 10, 9};

TEST(OrientCells, RepairMakesPositiveKeepsPairsAndTellsWhich) {
    std::vector<Index> tets = kTets, octs = kOcts;
    const OrientationReport report = OrientCells(tets, octs, kPositions, OrientationPolicy::Repair);
    EXPECT_THAT(report.inverted_tets, ElementsAre(1));
    EXPECT_THAT(report.inverted_octs, ElementsAre(1));
    EXPECT_THAT(report.flat_tets, ElementsAre(2));
    EXPECT_THAT(report.flat_octs, IsEmpty());
    EXPECT_EQ(report.n_inverted(), 2);
    EXPECT_EQ(report.n_flat(), 1);
    EXPECT_GT(TetVolume(kPositions, std::span<const Index>(tets).subspan(4).first<4>()), 0);
    EXPECT_GT(OctVolume(kPositions, std::span<const Index>(octs).subspan(6).first<6>()), 0);
    for (std::size_t pair = 0; pair < kTets.size(); pair += 2) {
        EXPECT_EQ((std::set{kTets[pair], kTets[pair + 1]}), (std::set{tets[pair], tets[pair + 1]}));
    }
    for (std::size_t pair = 0; pair < kOcts.size(); pair += 2) {
        EXPECT_EQ((std::set{kOcts[pair], kOcts[pair + 1]}), (std::set{octs[pair], octs[pair + 1]}));
    }
    EXPECT_TRUE(std::equal(tets.begin() + 8, tets.end(), kTets.begin() + 8)) << "a flat cell is left";
    EXPECT_THAT(OrientCells(tets, octs, kPositions, OrientationPolicy::Repair).n_inverted(), 0);
}

TEST(OrientCells, KeepReportsAndChangesNothing) {
    std::vector<Index> tets = kTets, octs = kOcts;
    EXPECT_EQ(OrientCells(tets, octs, kPositions, OrientationPolicy::Keep).n_inverted(), 2);
    EXPECT_EQ(tets, kTets);
    EXPECT_EQ(octs, kOcts);
}

TEST(OrientCells, RefuseNamesTheFirstInvertedCell) {
    std::vector<Index> tets = kTets, octs = kOcts;
    try {
        OrientCells(tets, octs, kPositions, OrientationPolicy::Refuse);
        FAIL() << "an inverted tet was accepted";
    } catch (const InvalidInput& error) {
        EXPECT_THAT(error.what(), HasSubstr("tet 1 is inverted"));
        EXPECT_THAT(error.what(), HasSubstr("-0.166667"));
        EXPECT_THAT(error.what(), HasSubstr("1 other is"));
    }
    EXPECT_EQ(tets, kTets);
    std::vector<Index> none;
    try {
        OrientCells(none, octs, kPositions, OrientationPolicy::Refuse);
        FAIL() << "an inverted oct was accepted";
    } catch (const InvalidInput& error) {
        EXPECT_THAT(error.what(), HasSubstr("oct 1 is inverted, its volume is -1.33333;"));
    }
}

TEST(OrientCells, RefuseAcceptsFlatCells) {
    std::vector<Index> tets = {0, 1, 2, 4}, none;
    EXPECT_EQ(OrientCells(tets, none, kPositions, OrientationPolicy::Refuse).n_flat(), 1);
}

TEST(OrientationPolicy, NamesAreThoseOfTheCommandLine) {
    EXPECT_EQ(OrientationPolicyOf("repair"), OrientationPolicy::Repair);
    EXPECT_EQ(OrientationPolicyOf("keep"), OrientationPolicy::Keep);
    EXPECT_EQ(OrientationPolicyOf("refuse"), OrientationPolicy::Refuse);
    EXPECT_THROW(OrientationPolicyOf("fix"), InvalidInput);
}

}  // namespace
}  // namespace SolidSubdiv::Geometry
