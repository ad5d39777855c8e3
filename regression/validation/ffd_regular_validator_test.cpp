// SPDX-License-Identifier: Apache-2.0
// The comparison with tricubic deformation passes, and catches points that are off, other end rules, other levels and
// control points in each other's place; the oracle's spline is what its knot insertions lead to.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "validation/ffd_regular.h"

namespace SolidSubdiv::Validation {
namespace {

constexpr double kTolerance = 1e-12;  // that of the validator
using Point = ControlBlock::Point;

double Distance(const Point& a, const Point& b) { return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]); }

class FfdRegularValidator : public testing::Test {
  protected:
    Deform::EmbedOptions Options(int level, bool limit = false) const {
        return {.levels = level, .limit = limit, .outside = Deform::Outside::Clamp};
    }
    bool PiecesPass(const std::vector<double>& deformed, int level) const {
        Findings findings;
        CompareWithPieces(block_, level, deformed, findings);
        return findings.Passes(kTolerance);
    }
    bool SplinePasses(const std::vector<double>& deformed) const {
        Findings findings;
        CompareWithSpline(block_, deformed, findings);
        return findings.Passes(kTolerance);
    }

    DeformedBlock block_{{3, 2, 4}, 1};
};

TEST_F(FfdRegularValidator, SplineIsWhatKnotInsertionsLeadTo) {
    ControlBlock fine = block_.moved;
    double before = 0;
    for (int level = 0; level <= 4; ++level) {
        double largest = 0;
        for (const Point& u : block_.places) {
            const Point fine_u = {std::ldexp(u[0], level), std::ldexp(u[1], level), std::ldexp(u[2], level)};
            // The same spline, up to the sums of 64 terms of size 1.
            EXPECT_LT(Distance(SplineAt(block_.moved, u), SplineAt(fine, fine_u)), 1e-14);
            largest = std::max(largest, Distance(SplineAt(fine, fine_u), TrilinearAt(fine, fine_u)));
        }
        // Its pieces come near it by a quarter a level, once they are small.
        if (level > 1) {
            EXPECT_NEAR(largest / before, 0.25, 0.03);
        }
        before = largest;
        fine = InsertKnots(fine);
    }
}

TEST_F(FfdRegularValidator, SplineLeavesWhatIsNotDeformed) {
    for (std::size_t i = 0; i < block_.places.size(); ++i) {
        const Point p = {block_.points[3 * i], block_.points[3 * i + 1], block_.points[3 * i + 2]};
        EXPECT_LT(Distance(SplineAt(block_.rest, block_.places[i]), p), 1e-14);  // sums of 64 terms of size 1
    }
}

TEST_F(FfdRegularValidator, CatchesPointsThatAreALittleOff) {
    for (int level : {0, 2}) {
        std::vector<double> deformed = DeformPoints(block_, Options(level));
        EXPECT_TRUE(PiecesPass(deformed, level));
        deformed[7] += 1e-11;
        EXPECT_FALSE(PiecesPass(deformed, level));
        deformed = DeformPoints(block_, Options(level, true));
        EXPECT_TRUE(SplinePasses(deformed));
        deformed[8] += 1e-11;
        EXPECT_FALSE(SplinePasses(deformed));
        deformed.pop_back();
        EXPECT_FALSE(SplinePasses(deformed));
    }
}

TEST_F(FfdRegularValidator, CatchesAnotherLevelAndTheLimitInItsPlace) {
    EXPECT_FALSE(PiecesPass(DeformPoints(block_, Options(1)), 2));
    EXPECT_FALSE(PiecesPass(DeformPoints(block_, Options(2, true)), 2));
    EXPECT_FALSE(SplinePasses(DeformPoints(block_, Options(3))));
}

TEST_F(FfdRegularValidator, CatchesAnotherEndRule) {
    Deform::EmbedOptions options = Options(1);
    options.scheme = Sdc::CatmullClarkSolid{.features = Sdc::Features::Smooth};
    EXPECT_FALSE(PiecesPass(DeformPoints(block_, options), 1));
}

TEST_F(FfdRegularValidator, CatchesControlPointsInEachOthersPlace) {
    std::swap_ranges(&block_.moved_control[0], &block_.moved_control[3], &block_.moved_control[3]);
    EXPECT_FALSE(PiecesPass(DeformPoints(block_, Options(1)), 1));
    EXPECT_FALSE(SplinePasses(DeformPoints(block_, Options(1, true))));
}

}  // namespace
}  // namespace SolidSubdiv::Validation
