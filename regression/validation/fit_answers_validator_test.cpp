// SPDX-License-Identifier: Apache-2.0
// Known answers of fits pass, and other answers are caught.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <solidsubdiv/apps/fit/internal/fairness.h>

#include "sanitized.h"
#include "validation/fit_known_answers.h"

namespace SolidSubdiv::Validation {
namespace {

using testing::Contains;
using testing::HasSubstr;

TEST(FitKnownPartnersValidator, CatchesAControlPointThatIsOff) {
    SOLIDSUBDIV_LONG_TEST();
    const FitCase solid = FitCasesAround(MakeFitBall(6).View(), 64)[0];
    const Fit::Problem problem = MakeProblem(solid.mesh, solid.scheme, {}, 2);
    std::vector<double> found = problem.control;
    const auto seen = static_cast<std::size_t>(problem.surface.rows.indices[0]);
    found[3 * seen + 1] += 1e-7;
    Findings findings;
    CompareSeen(problem, found, problem.control, findings);
    EXPECT_FALSE(findings.Passes(1e-8));
    EXPECT_EQ(findings.where, "control point " + std::to_string(seen));
}

TEST(FitFreePartnersValidator, CatchesFitsThatAreNotNearAndOnesThatHaveNothingToDo) {
    const double diagonal = 2;
    Findings good, far_off, idle;
    CompareRounds({{.surface_rms = 0.01}, {.surface_rms = 1e-6, .target_rms = 1e-6}}, diagonal, good);
    EXPECT_TRUE(good.Passes(1e-6));
    CompareRounds({{.surface_rms = 0.01}, {.surface_rms = 1e-6, .target_rms = 3e-6}}, diagonal, far_off);
    EXPECT_FALSE(far_off.Passes(1e-6));
    CompareRounds({{.surface_rms = 1e-6, .target_rms = 1e-6}}, diagonal, idle);
    EXPECT_THAT(idle.faults, Contains(HasSubstr("answer already")));
}

TEST(FitAffineValidator, CatchesFairnessWithAWeightThatIsOff) {
    SOLIDSUBDIV_LONG_TEST();
    const FitCase solid = FitCasesAround(MakeFitBall(6).View(), 64)[0];
    const Fit::Problem problem = MakeProblem(solid.mesh, solid.scheme, {}, 1);
    auto rows = Fit::Internal::AffineRows(problem.control, problem.neighbors);
    Findings good, bad, blind;
    CompareFairness(rows, problem.control, good);
    EXPECT_TRUE(good.Passes(1e-12)) << good.largest_error;
    auto spoiled = rows;
    spoiled.weights[5] += 1e-9;
    CompareFairness(spoiled, problem.control, bad);
    EXPECT_FALSE(bad.Passes(1e-12));
    rows.offsets.assign(rows.offsets.size(), 0);  // rows without weights ask for nothing
    CompareFairness(rows, problem.control, blind);
    EXPECT_THAT(blind.faults, Contains(HasSubstr("shaken")));
}

TEST(FitAffineLatticeValidator, CatchesAPointThatIsNotWhereItShouldBe) {
    Findings good, bad;
    CheckAffineLattice(MakeFitBall(4), Sdc::CatmullClarkSolid{}, good);
    EXPECT_TRUE(good.Passes(1e-9)) << good.largest_error;
    ComparePoints({0, 0, 0, 1, 1 + 1e-8, 1}, {0, 0, 0, 1, 1, 1}, bad);
    EXPECT_FALSE(bad.Passes(1e-9));
    EXPECT_EQ(bad.where, "point 1");
}

}  // namespace
}  // namespace SolidSubdiv::Validation
