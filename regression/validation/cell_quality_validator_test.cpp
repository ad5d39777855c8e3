// SPDX-License-Identifier: Apache-2.0
// The validator of quality: faults planted in numbers that are right.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "validation/cell_quality.h"

namespace SolidSubdiv::Validation {
namespace {

constexpr double kTolerance = 1e-12;  // the validator's own

/// A hexahedron whose determinants are 40 and more at its corners, and negative between them.
Io::Mesh FoldedBetweenCorners() {
    Io::Mesh mesh;
    mesh.topology.n_vertices = 8;
    mesh.positions = {-2, 2, 0, 5, 1, -3, 7, 6, 3, 3, 2, 0, 2, 0, 2, 4, -1, 1, 5, 2, 4, 2, 7, 1};
    mesh.topology.hexes = {0, 1, 2, 3, 4, 5, 6, 7};
    return mesh;
}

class CellQualityValidator : public testing::Test {
  protected:
    Findings Compare() const {
        Findings findings;
        CompareQuality(mesh_, ours_, verdict_, findings);
        return findings;
    }
    Io::Mesh mesh_ = FoldedBetweenCorners();
    std::vector<Geometry::CellQuality> ours_ = MeasureMesh(mesh_);
    std::vector<double> verdict_{ours_[0].scaled_jacobian};  // the comparison is tested here, not VTK
};

TEST_F(CellQualityValidator, PassesOnTheFrameworksOwnNumbers) { EXPECT_TRUE(Compare().Passes(kTolerance)); }

TEST_F(CellQualityValidator, CatchesAScaledJacobianThatIsALittleOff) {
    ours_[0].scaled_jacobian += 1e-9;
    EXPECT_FALSE(Compare().Passes(kTolerance));
}

TEST_F(CellQualityValidator, CatchesASignTakenFromTheCorners) {
    ours_[0].sign = Geometry::MinimumSign::Positive;
    EXPECT_THAT(Compare().faults, testing::ElementsAre(testing::HasSubstr("hexahedron 0 has the determinant")));
}

TEST_F(CellQualityValidator, CatchesABoundThatIsNone) {
    ours_[0].lower_bound = 0;
    EXPECT_FALSE(Compare().Passes(kTolerance));
}

TEST_F(CellQualityValidator, CatchesAMissingCell) {
    ours_.pop_back();
    EXPECT_THAT(Compare().faults, testing::ElementsAre("another number of cells"));
}

}  // namespace
}  // namespace SolidSubdiv::Validation
