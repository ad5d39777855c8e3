// SPDX-License-Identifier: Apache-2.0
// The validator of location: faults planted in places that are right.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <solidsubdiv/kit/io/formats.h>

#include "validation/location.h"

namespace SolidSubdiv::Validation {
namespace {

constexpr double kTolerance = 3e-14;  // the validator's own

class LocationValidator : public testing::TestWithParam<Sdc::Split> {
  protected:
    LocationValidator()
        : mesh_(Io::ReadSolid(std::filesystem::path(SOLIDSUBDIV_SHAPES) / "demo" / "bunny_lattice.vtu")),
          refiner_(Far::TopologyRefiner::Create(mesh_.topology, GetParam())) {
        refiner_.RefineUniform({.max_level = 0});
        drawn_ = DrawPlaces(shape_, 2000, 1);
        points_ = EvaluatePlainly(shape_, drawn_);
        found_ = Geometry::Locator(refiner_, 0, mesh_.positions).Locate(points_);
    }
    Findings Compare() const {
        Findings findings;
        CompareLocation(shape_, drawn_, points_, found_, findings);
        return findings;
    }

    Io::Mesh mesh_;
    Far::TopologyRefiner refiner_;
    LocationShape shape_{refiner_, 0, mesh_.positions};
    std::vector<Far::Place> drawn_;
    std::vector<double> points_;
    Geometry::Location found_;
};

TEST_P(LocationValidator, PassesOnTheFrameworksOwnPlaces) {
    const Findings findings = Compare();
    EXPECT_TRUE(findings.Passes(kTolerance)) << findings.largest_error << " " << findings.where;
    EXPECT_EQ(findings.n_compared, 2000);
}

TEST_P(LocationValidator, CatchesALostPoint) {
    found_.outside.push_back({7, 0.0});
    EXPECT_THAT(Compare().faults, testing::ElementsAre(testing::HasSubstr("1 points lost, the first 7")));
}

TEST_P(LocationValidator, CatchesACoordinateThatIsALittleOff) {
    found_.places[11].at[1] += 1e-11;
    const Findings findings = Compare();
    EXPECT_GT(findings.largest_error, kTolerance);
    EXPECT_EQ(findings.where, "point 11");
}

TEST_P(LocationValidator, CatchesTheSameCoordinatesInAnotherCell) {
    found_.places[12].element -= found_.places[12].element > 0 ? 1 : 0;
    EXPECT_FALSE(Compare().Passes(kTolerance));
}

TEST_P(LocationValidator, CatchesACellThatIsNotTheLowest) {
    found_.places[13].element = drawn_[13].element + 1;
    EXPECT_THAT(Compare().faults, testing::ElementsAre(testing::HasSubstr("or a lower one")));
}

TEST_P(LocationValidator, CatchesCoordinatesOutOfTheirRanges) {
    found_.places[14].at = {-0.001, 0.5, 0.5};
    EXPECT_THAT(Compare().faults, testing::Contains(testing::HasSubstr("out of their ranges")));
}

INSTANTIATE_TEST_SUITE_P(TetsAndParts, LocationValidator, testing::Values(Sdc::Split::TetOct, Sdc::Split::Polyhedral));

}  // namespace
}  // namespace SolidSubdiv::Validation
