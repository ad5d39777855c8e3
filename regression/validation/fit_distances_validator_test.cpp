// SPDX-License-Identifier: Apache-2.0
// Distances that agree pass; too large and too small ones are caught.
#include <gtest/gtest.h>

#include "or_skip.h"
#include "validation/fit_distances.h"

namespace SolidSubdiv::Validation {
namespace {

TEST(FitDistancesValidator, CatchesDistancesThatAreTooLargeOrTooSmall) {
    const auto error_of = [](double ours) {
        Findings findings;
        CompareMost(ours, 1.0, 0.01, 0.05, 2, findings);
        return findings.largest_error;
    };
    EXPECT_EQ(error_of(1), 0);
    EXPECT_EQ(error_of(0.95), 0);
    EXPECT_NEAR(error_of(1.03), 0.01, 1e-12);  // what exceeds over the size
    EXPECT_NEAR(error_of(0.92), 0.01, 1e-12);
}

TEST(FitDistancesValidator, AgreesOnABallThatIsMoved) {
    const FitTarget ball = MakeFitBall(6);
    FitTarget moved = ball;
    for (std::size_t i = 0; i < moved.positions.size(); i += 3) moved.positions[i] += 0.1;
    OrSkip([&] {
        Findings findings;
        CheckDistance(ball, moved, findings);
        EXPECT_TRUE(findings.Passes(0)) << findings.where;
    });
}

}  // namespace
}  // namespace SolidSubdiv::Validation
