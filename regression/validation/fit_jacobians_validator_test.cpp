// SPDX-License-Identifier: Apache-2.0
// Derivatives of fits pass, and wrong ones are caught.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sanitized.h"
#include "validation/fit_jacobians.h"
#include "validation/fit_shapes.h"

namespace SolidSubdiv::Validation {
namespace {

using testing::Contains;
using testing::HasSubstr;

constexpr double kTolerance = 1e-7;

TEST(FitJacobiansValidator, CatchesASlopeThatIsOff) {
    const auto energy_spoiled_by = [](double by) {
        return [by](std::span<const double> at, std::span<double> slope) {
            if (!slope.empty()) slope[1] += 3 * at[1] * at[1] + by, slope[0] += 1;
            return at[0] + at[1] * at[1] * at[1];
        };
    };
    const std::vector<double> at = {1, 2, 3};
    Findings good, bad;
    CompareSlope(energy_spoiled_by(0), at, "energy", good);
    EXPECT_TRUE(good.Passes(kTolerance)) << good.where;
    CompareSlope(energy_spoiled_by(1e-4), at, "energy", bad);
    EXPECT_FALSE(bad.Passes(kTolerance));
    EXPECT_EQ(bad.where, "energy, control point 0");
}

TEST(FitJacobiansValidator, AsksForEveryKindOfRow) {
    SOLIDSUBDIV_LONG_TEST();
    const FitTarget ball = MakeFitBall(5);
    const FitCase solid = FitCasesAround(ball.View(), 64)[0];
    Fit::Problem problem = MakeProblem(solid.mesh, solid.scheme, ball.View(), 1);
    Findings good;
    CheckJacobians(problem, 2, good);
    EXPECT_TRUE(good.Passes(kTolerance)) << good.where;
    for (auto& around : problem.neighbors) around.clear();
    problem.corners.resize(1);
    Findings poor;
    CheckJacobians(problem, 2, poor);
    EXPECT_THAT(poor.faults, Contains(HasSubstr("no fair rows")));
    EXPECT_THAT(poor.faults, Contains(HasSubstr("nowhere or everywhere")));
}

}  // namespace
}  // namespace SolidSubdiv::Validation
