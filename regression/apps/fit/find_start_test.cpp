// SPDX-License-Identifier: Apache-2.0
// Several starts, and the one that a short fit likes best.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <solidsubdiv/apps/fit/find_start.h>
#include <solidsubdiv/apps/fit/fit_solid.h>
#include <solidsubdiv/sdc/errors.h>
#include <solidsubdiv/sdc/parallel.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "apps/fit/start_testing.h"
#include "sanitized.h"

namespace SolidSubdiv::Fit {
namespace {

const Sdc::Scheme kScheme = Sdc::CatmullClarkSolid{};

/// Of the whole fit that a start is for.
double ErrorAfter(const ControlMesh& start, const TargetSurface& target) {
    const SolidFit fit = FitSolid(start, kScheme, target, {});
    return std::hypot(fit.result.to_target.rms, fit.result.from_target.rms) * static_cast<double>(1 + fit.n_folded);
}

TEST(SolidStarts, AreDifferentAndTheFirstIsMakeSolidStarts) {
    SOLIDSUBDIV_LONG_TEST();
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

TEST(FindSolidStart, FitsBetterThanStartsDoOnAverage) {
    SOLIDSUBDIV_LONG_TEST();
    const Surface target = Bunny();
    const StartOptions options{.n_control = 200};
    StartReport report;
    const ControlMesh found = FindSolidStart(target.View(), kScheme, options, &report);
    EXPECT_TRUE(report.has_target_topology);
    const std::vector<ControlMesh> starts = MakeSolidStarts(target.View(), options, 12);
    const auto taken = std::find_if(starts.begin(), starts.end(),
                                    [&](const ControlMesh& start) { return start.positions == found.positions; });
    ASSERT_NE(taken, starts.end());

    std::vector<double> errors(starts.size());
    Sdc::ParallelFor(static_cast<Offset>(starts.size()), 1, [&](Offset begin, Offset end) {
        const Sdc::SerialScope serial;
        for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i) {
            errors[i] = ErrorAfter(starts[i], target.View());
        }
    });
    // Trials guess well, not surely.
    const double mean = std::accumulate(errors.begin(), errors.end(), 0.) / static_cast<double>(errors.size());
    EXPECT_LT(errors[static_cast<std::size_t>(taken - starts.begin())], mean);
}

TEST(FindSolidStart, DoesNotDependOnTheNumberOfThreads) {
    SOLIDSUBDIV_LONG_TEST();
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
