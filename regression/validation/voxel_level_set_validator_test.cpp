// SPDX-License-Identifier: Apache-2.0
// The validator of level sets passes on the framework's own, and catches faults planted in them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "validation/or_skip.h"
#include "validation/voxel_level_set.h"

namespace SolidSubdiv::Validation {
namespace {

using testing::Contains;
using testing::HasSubstr;

constexpr double kTolerance = 1e-12, kVoxel = 0.08;

class VoxelLevelSetValidator : public testing::Test {
  protected:
    void SetUp() override {
        OrSkip([&] {
            ours_ = VoxelizeShape(shape_, kVoxel, 3);
            theirs_ = ours_.distances;
            MeshToVolume(surface_, theirs_);
        });
    }
    Findings AgainstOpenVdb() const {
        Findings findings;
        CompareLevelSets(ours_.distances, theirs_, surface_, findings);
        return findings;
    }
    Findings AgainstExact() const {
        Findings findings;
        CompareDistances(ours_.distances, DistanceToBall, SagittaOf(surface_, DistanceToBall), findings);
        return findings;
    }
    Findings Volumes() const {
        Findings findings;
        CompareVolumes(ours_, surface_, findings);
        return findings;
    }
    /// The first voxel whose distance lies in a range of voxels.
    double& Find(double low, double high) {
        auto& values = ours_.distances.values;
        return *std::find_if(values.begin(), values.end(),
                             [&](double x) { return x > low * kVoxel && x < high * kVoxel; });
    }

    VoxelShape shape_ = MakeBall(10);
    TriangleSurface surface_ = BoundaryOf(shape_);
    ShapeVoxels ours_;
    VoxelBlock theirs_;
};

TEST_F(VoxelLevelSetValidator, PassesOnTheFrameworksOwn) {
    for (const Findings& findings : {AgainstOpenVdb(), AgainstExact(), Volumes()}) {
        EXPECT_TRUE(findings.Passes(kTolerance)) << findings.largest_error << " " << findings.where;
        EXPECT_THAT(findings.faults, testing::IsEmpty());
    }
}

TEST_F(VoxelLevelSetValidator, CatchesDistancesThatAreOff) {
    Find(-0.8, -0.4) += 0.15 * kVoxel;
    EXPECT_FALSE(AgainstOpenVdb().Passes(kTolerance));
    for (double& x : ours_.distances.values) x *= 1.1;  // another voxel size
    EXPECT_FALSE(AgainstExact().Passes(kTolerance));
}

TEST_F(VoxelLevelSetValidator, CatchesAVoxelOfTheOtherSign) {
    double& value = Find(1, 1.2);
    value = -value;
    EXPECT_THAT(AgainstOpenVdb().faults, Contains(HasSubstr("another sign")));
    EXPECT_THAT(AgainstExact().faults, Contains(HasSubstr("another sign")));
}

TEST_F(VoxelLevelSetValidator, CatchesBackgroundOfTheOtherSign) {
    double& value = ours_.distances.values[ours_.distances.values.size() / 2];  // in the middle of the ball
    ASSERT_LT(value, -2.9 * kVoxel);
    value = -value;
    EXPECT_THAT(AgainstOpenVdb().faults, Contains(HasSubstr("another sign")));
}

TEST_F(VoxelLevelSetValidator, TheOthersFaultsAreTheirs) {
    const auto near = static_cast<std::size_t>(&Find(0.3, 0.4) - ours_.distances.values.data());
    theirs_.values[near] = -theirs_.values[near];
    EXPECT_THAT(AgainstOpenVdb().faults, testing::IsEmpty());
}

TEST_F(VoxelLevelSetValidator, CatchesATileThatIsLeftOut) {
    int n_left = 8 * 8 * 8;
    for (double& x : ours_.fog.values) {
        if (x == 1 && n_left-- > 0) x = 0;
    }
    EXPECT_EQ(Volumes().where, "fog");
    for (double& x : ours_.distances.values) x = x < -2.9 * kVoxel ? -x : x;
    EXPECT_EQ(Volumes().where, "negative voxels");
}

TEST_F(VoxelLevelSetValidator, CatchesAnotherNumberOfVoxels) {
    theirs_.values.pop_back();
    EXPECT_THAT(AgainstOpenVdb().faults, Contains(HasSubstr("number of voxels")));
}

TEST(VoxelShapes, LieOnWhatTheyApproximate) {
    const double pi = std::acos(-1.0);
    const struct {
        VoxelShape shape;
        double (*distance)(const std::array<double, 3>&);
        double volume, sagitta;
    } cases[] = {{MakeBall(6), DistanceToBall, 4 * pi / 3, 0.03},
                 {MakeTorus(4), DistanceToTorus, 2 * pi * pi * 0.16, 0.03},
                 {MakeTurnedBox(2), DistanceToTurnedBox, 2.8, 1e-14}};
    for (const auto& c : cases) {
        const TriangleSurface surface = BoundaryOf(c.shape);
        EXPECT_LT(SagittaOf(surface, c.distance), c.sagitta) << c.shape.name;
        EXPECT_NEAR(VolumeOf(surface), c.volume, 4 * c.sagitta * c.volume + 1e-12) << c.shape.name;
        const auto inner = c.shape.name == "torus" ? std::array{1.0, 0.0, 0.0} : std::array{0.1, 0.2, 0.1};
        EXPECT_NEAR(WindingNumber(surface, inner), 1, 1e-12);
        EXPECT_NEAR(WindingNumber(surface, {3, 0.1, 0.1}), 0, 1e-12);
    }
}

}  // namespace
}  // namespace SolidSubdiv::Validation
