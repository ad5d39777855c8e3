// SPDX-License-Identifier: Apache-2.0
// Changes of level pass, and vertices that jump are caught.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <solidsubdiv/kit/io/formats.h>

#include "validation/ffd_levels.h"

namespace SolidSubdiv::Validation {
namespace {

using testing::Contains;
using testing::HasSubstr;

constexpr double kTolerance = 1e-10;

std::vector<double> Bunny() {
    return Io::ReadMesh(std::filesystem::path(SOLIDSUBDIV_SHAPES) / "demo" / "bunny.obj").positions;
}

TEST(FfdLevelsValidator, PassesOnTheFrameworksOwn) {
    const auto model = Bunny();
    Findings findings;
    CheckLevels(model, Deform::MakeOctreeLattices(model, {}, {.levels = 2}), findings);
    EXPECT_TRUE(findings.Passes(kTolerance)) << findings.where;
    EXPECT_THAT(findings.notes, Contains(HasSubstr("would jump")));
}

TEST(FfdLevelsValidator, CatchesAVertexThatJumps) {
    const auto model = Bunny();
    auto moved = model;
    moved[3 * 100 + 1] += 1e-8;
    Findings findings;
    CompareStill(model, moved, 10, "to level 1", findings);
    EXPECT_FALSE(findings.Passes(kTolerance));
    EXPECT_EQ(findings.where, "to level 1, vertex 100");
    moved.resize(3);
    CompareStill(model, moved, 10, "to level 1", findings);
    EXPECT_THAT(findings.faults, Contains(HasSubstr("1 points of 1839")));
}

TEST(FfdLevelsValidator, CatchesMovesThatNeedNoCorrection) {
    // With one level there is nothing to correct: the check itself would be empty.
    const auto model = Bunny();
    Findings findings;
    CheckLevels(model, Deform::MakeOctreeLattices(model, {}, {.levels = 0}), findings);
    EXPECT_THAT(findings.faults, Contains(HasSubstr("too small")));
}

}  // namespace
}  // namespace SolidSubdiv::Validation
