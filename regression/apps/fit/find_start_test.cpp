// SPDX-License-Identifier: Apache-2.0
// Several starts, and the one that a short fit likes best.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <solidsubdiv/apps/fit/find_start.h>
#include <solidsubdiv/apps/fit/fit.h>
#include <solidsubdiv/sdc/errors.h>
#include <solidsubdiv/sdc/parallel.h>

#include <cmath>

#include "apps/fit/start_testing.h"
#include "sanitized.h"

namespace SolidSubdiv::Fit {
namespace {

const Sdc::Scheme kScheme = Sdc::CatmullClarkSolid{};

double ErrorOf(const ControlMesh& start, const TargetSurface& target) {
    const Result result = FitControlPoints(MakeProblem(start, kScheme, target, 2), {.max_rounds = 30});
    return result.n_folded > 0 ? HUGE_VAL : std::hypot(result.to_target.rms, result.from_target.rms);
}

TEST(SolidStarts, AreDifferentAndTheFirstIsMakeSolidStarts) {
    const Surface target = Torus(16);
    const StartOptions options{.n_control = 200};
    std::vector<StartReport> reports;
    const std::vector<ControlMesh> starts = MakeSolidStarts(target.View(), options, 5, &reports);
    ASSERT_GT(starts.size(), 1u);
    ASSERT_LE(starts.size(), 5u);
    ASSERT_EQ(reports.size(), starts.size());
    EXPECT_EQ(starts[0].positions, MakeSolidStart(target.View(), options).positions);
    for (std::size_t i = 0; i < starts.size(); ++i) {
        EXPECT_EQ(EulerOf(BoundaryOf(starts[i])), reports[i].euler);
        for (std::size_t j = 0; j < i; ++j) EXPECT_NE(starts[i].positions, starts[j].positions);
    }
    EXPECT_THROW(MakeSolidStarts(target.View(), options, 0), InvalidInput);
}

TEST(FindSolidStart, TakesTheOneThatFitsBest) {
    if (kIsSanitized) GTEST_SKIP() << "a minute under a sanitizer";
    const Surface target = Bunny();
    const StartOptions options{.n_control = 150};
    StartReport report;
    const ControlMesh found = FindSolidStart(target.View(), kScheme, options, &report, 5);
    EXPECT_TRUE(report.has_target_topology);
    std::vector<double> errors;
    for (const ControlMesh& start : MakeSolidStarts(target.View(), options, 5))
        errors.push_back(ErrorOf(start, target.View()));
    std::sort(errors.begin(), errors.end());
    // A short fit is a guess: among the better half.
    EXPECT_LE(ErrorOf(found, target.View()), errors[errors.size() / 2]);
    EXPECT_LT(errors.front(), 0.8 * errors[errors.size() / 2]) << "starts that differ so little need no search";
}

TEST(FindSolidStart, DoesNotDependOnTheNumberOfThreads) {
    const Surface target = SphereAt({0, 0, 0}, 1);
    std::vector<std::vector<double>> found;
    for (int n : {1, 3}) {
        const Sdc::ThreadLimit limit(n);
        found.push_back(FindSolidStart(target.View(), kScheme, {.n_control = 120}, nullptr, 3).positions);
    }
    EXPECT_EQ(found[1], found[0]);
}

TEST(FindSolidStart, NumbersOutOfRangeAreNamed) {
    const Surface target = SphereAt({0, 0, 0}, 1);
    for (int n : {0, 17}) {
        EXPECT_THROW(FindSolidStart(target.View(), kScheme, {.n_control = 100}, nullptr, n), InvalidInput);
    }
}

}  // namespace
}  // namespace SolidSubdiv::Fit
