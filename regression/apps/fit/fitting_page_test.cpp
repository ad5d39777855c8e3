// SPDX-License-Identifier: Apache-2.0
// The code of docs/fitting.md, compiled and run.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <solidsubdiv/apps/fit/find_start.h>
#include <solidsubdiv/apps/fit/fit_solid.h>

#include <cmath>

#include "apps/fit/start_testing.h"
#include "page_code.h"
#include "sanitized.h"

namespace SolidSubdiv {
namespace {

TEST(FittingPage, HasTheCodeOfThisTest) {
    const std::string page = CodeWithoutBlanks("/docs/fitting.md");
    ASSERT_GT(page.size(), 400u);
    EXPECT_THAT(CodeWithoutBlanks("/regression/apps/fit/fitting_page_test.cpp"), testing::HasSubstr(page));
}

TEST(FittingPage, CodeRuns) {
    SOLIDSUBDIV_LONG_TEST();
    const auto ball = Fit::SphereAt({0, 0, 0}, 1);
    const std::span<const double> positions = ball.View().positions;
    const std::span<const Index> triangles = ball.View().triangles;

    const Fit::TargetSurface target{.positions = positions, .triangles = triangles};

    // A solid.
    Fit::ControlMesh lattice = Fit::FindSolidStart(target, Sdc::CatmullClarkSolid{}, {.n_control = 100});
    const Fit::SolidFit fit = Fit::FitSolid(lattice, Sdc::CatmullClarkSolid{}, target, {});
    lattice.positions = fit.result.control;
    const double rms = fit.result.to_target.rms, largest = fit.result.from_target.most;

    // A cage.
    Fit::ControlMesh cage = Fit::MakeCage(target, {.n_control = 60});
    const Fit::Problem problem = Fit::MakeProblem(cage, Sdc::Loop{}, target);
    cage.positions = Fit::FitControlPoints(problem, {.least_fairness = 1e-5}).control;

    // The target's own facets are up to a hundredth from the ball.
    EXPECT_EQ(fit.n_folded, 0);
    EXPECT_LT(rms, 0.02);
    EXPECT_LT(largest, 0.05);
    const std::vector<double> limit = problem.surface.Positions(cage.positions);
    for (std::size_t i = 0; i < limit.size(); i += 3)
        EXPECT_NEAR(std::hypot(limit[i], limit[i + 1], limit[i + 2]), 1, 0.05);
}

}  // namespace
}  // namespace SolidSubdiv
