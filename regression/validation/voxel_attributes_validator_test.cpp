// SPDX-License-Identifier: Apache-2.0
// The validator of attributes passes on the framework's own, and catches faults planted in them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "validation/or_skip.h"
#include "validation/voxel_attributes.h"

namespace SolidSubdiv::Validation {
namespace {

using testing::Contains;
using testing::HasSubstr;

constexpr double kTolerance = 1e-12;

class VoxelAttributesValidator : public testing::Test {
  protected:
    void SetUp() override {
        OrSkip([&] { samples_ = SampleVoxels(shape_, 0.05, 500, 1); });
    }
    Findings Compare() const {
        Findings findings;
        CompareSamples(shape_, samples_, findings);
        return findings;
    }

    VoxelShape shape_ = MakeBall(3);
    VoxelSamples samples_;
};

TEST_F(VoxelAttributesValidator, PassesOnTheFrameworksOwn) {
    const Findings findings = Compare();
    EXPECT_TRUE(findings.Passes(kTolerance)) << findings.largest_error << " " << findings.where;
    EXPECT_GT(findings.n_compared, 7 * 500);  // most by two ways
}

TEST_F(VoxelAttributesValidator, CatchesANumberThatIsOff) {
    samples_.numbers[17] += 1e-6;
    EXPECT_GT(Compare().largest_error, 5e-7);
    EXPECT_THAT(Compare().where, HasSubstr("sample 17"));
}

TEST_F(VoxelAttributesValidator, CatchesComponentsInEachOthersPlace) {
    std::swap(samples_.vectors[3], samples_.vectors[4]);
    EXPECT_THAT(Compare().where, HasSubstr("sample 1"));
}

TEST_F(VoxelAttributesValidator, CatchesAnotherCell) {
    samples_.cells[5] = samples_.cells[5] == 0 ? 100 : 0;
    EXPECT_THAT(Compare().faults, Contains(HasSubstr("sample 5: not in cell")));
    samples_.cells[5] = 1 << 20;
    EXPECT_THAT(Compare().faults, Contains(HasSubstr("there is no cell")));
}

TEST_F(VoxelAttributesValidator, CatchesVoxelsThatAreNotWhereTheyShouldBe) {
    samples_.voxel_size *= 1.001;
    EXPECT_FALSE(Compare().Passes(kTolerance));
}

}  // namespace
}  // namespace SolidSubdiv::Validation
