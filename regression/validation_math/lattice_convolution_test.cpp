// SPDX-License-Identifier: Apache-2.0
// Subdivision on the lattice: its mask, its rows, where its values are known, and its limit, which is the box spline.
#include "validation/lattice_convolution.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <vector>

#include "validation_math/random_points.h"

namespace SolidSubdiv::Validation {
namespace {

// Control values without any pattern, `width` numbers in [-1, 1] a point.
LatticeValues RandomControl(const LatticePoint& size, int width) {
    const int points = (size[0] + 1) * (size[1] + 1) * (size[2] + 1);
    std::vector<double> values;
    for (const auto& p : RandomPoints(points * width, 1, 21)) values.push_back(p[0]);
    return ValuesOnBlock(size, width, values);
}

// 1 at the middle of a box around it, 0 elsewhere.
LatticeValues Spike(int radius) {
    const LatticePoint size = {2 * radius, 2 * radius, 2 * radius};
    LatticeValues spike =
        ValuesOnBlock(size, 1, std::vector<double>((2 * radius + 1) * (2 * radius + 1) * (2 * radius + 1)));
    spike.lo = {-radius, -radius, -radius};
    spike.hi = {radius, radius, radius};
    spike.values[spike.Offset({0, 0, 0})] = 1;
    return spike;
}

LatticeValues SubdivideTimes(LatticeValues values, int level) {
    for (int i = 0; i < level; ++i) values = Subdivide(values);
    return values;
}

template <class Visit>
void ForEachPoint(const LatticeValues& values, Visit visit) {
    for (int z = values.lo[2]; z <= values.hi[2]; ++z)
        for (int y = values.lo[1]; y <= values.hi[1]; ++y)
            for (int x = values.lo[0]; x <= values.hi[0]; ++x) visit(LatticePoint{x, y, z});
}

int Parity(const LatticePoint& p) { return (p[0] & 1) + 2 * (p[1] & 1) + 4 * (p[2] & 1); }

TEST(LatticeMask, WeightsOfEachParityClassSumToOne) {
    std::map<int, double> sums;
    for (const auto& [offset, weight] : BoxSplineMask()) sums[Parity(offset)] += weight;
    ASSERT_EQ(sums.size(), 8U);
    for (const auto& [parity, sum] : sums) EXPECT_EQ(sum, 1);  // dyadic: exact
}

// The vertex rule and the edge rules of the scheme, link 6 along u_k and link 4 along u_i + u_j, are what the product
// contains.
TEST(LatticeMask, ContainsTheVertexAndEdgeRulesOfTheScheme) {
    std::map<LatticePoint, double> mask;
    for (const auto& [offset, weight] : BoxSplineMask()) mask[offset] = weight * 32;
    EXPECT_EQ((mask[{0, 0, 0}]), 18);
    std::map<int, std::vector<double>> rows;
    for (const auto& [offset, weight] : mask) rows[Parity(offset)].push_back(weight);
    for (auto& [parity, weights] : rows) {
        std::sort(weights.rbegin(), weights.rend());
        const LatticePoint midpoint = {parity & 1, (parity >> 1) & 1, (parity >> 2) & 1};
        std::vector<double> expected;
        if (parity == 0) {
            expected.assign(15, 1);
            expected[0] = 18;
        } else if (ClassifyEdge({0, 0, 0}, midpoint) == EdgeKind::A) {
            expected = {10, 10, 2, 2, 2, 2, 2, 2};
        } else {
            expected = {8, 8, 4, 4, 4, 4};
        }
        EXPECT_EQ(weights, expected);
    }
}

TEST(LatticeMask, HasSumRulesOfOrderFour) {
    // All moments of degree up to 3 agree between the parity classes: the scheme generates cubics. Degree 4 does not.
    const auto spread = [](int a, int b, int c) {
        std::map<int, double> moments;
        for (const auto& [p, weight] : BoxSplineMask())
            moments[Parity(p)] += weight * std::pow(p[0], a) * std::pow(p[1], b) * std::pow(p[2], c);
        const auto [low, high] = std::minmax_element(moments.begin(), moments.end(),
                                                     [](const auto& x, const auto& y) { return x.second < y.second; });
        return high->second - low->second;
    };
    for (int a = 0; a <= 3; ++a)
        for (int b = 0; a + b <= 3; ++b)
            for (int c = 0; a + b + c <= 3; ++c) EXPECT_EQ(spread(a, b, c), 0);  // small integers / 32: exact
    EXPECT_GT(spread(4, 0, 0), 0.1);
}

TEST(LatticeRow, EqualsRepeatedSubdivisionOfASpike) {
    const LatticeValues spike = Spike(3);
    for (int level = 0; level <= 3; ++level) {
        const LatticeValues fine = SubdivideTimes(spike, level);
        ForEachPoint(fine, [&](const LatticePoint& p) {
            double weight = 0;
            for (const auto& [q, w] : SubdivisionRow(p, level))
                if (q == LatticePoint{0, 0, 0}) weight = w;
            EXPECT_EQ(fine.values[fine.Offset(p)], weight);
        });
    }
}

TEST(LatticeRow, SumsToOneAndReproducesLinearFunctions) {
    for (int level = 1; level <= 4; ++level)
        for (const Point3& random : RandomPoints(30, 100, 22)) {
            const LatticePoint fine = {static_cast<int>(random[0]), static_cast<int>(random[1]),
                                       static_cast<int>(random[2])};
            double sum = 0;
            Point3 mean{};
            for (const auto& [q, w] : SubdivisionRow(fine, level)) {
                sum += w;
                for (int i = 0; i < 3; ++i) mean[i] += w * q[i];
            }
            EXPECT_EQ(sum, 1);  // dyadic weights: exact
            for (int i = 0; i < 3; ++i) EXPECT_EQ(mean[i] * (1 << level), fine[i]);
        }
}

TEST(LatticeValuesKnown, IsEverythingNoNearerToTheSidesThanOneMinusTheLastStep) {
    const LatticeValues fine = SubdivideTimes(RandomControl({4, 3, 5}, 1), 3);
    EXPECT_EQ(fine.lo, (LatticePoint{7, 7, 7}));
    EXPECT_EQ(fine.hi, (LatticePoint{25, 17, 33}));
}

// Known means: no value outside the box could change it. The rows say which values enter.
TEST(LatticeValuesKnown, NeedsNothingOutsideTheBoxAndNothingMoreIsKnown) {
    const LatticeValues control = RandomControl({3, 3, 3}, 1);
    const LatticeValues fine = SubdivideTimes(control, 2);
    for (int z = 0; z <= 12; ++z)
        for (int y = 0; y <= 12; ++y)
            for (int x = 0; x <= 12; ++x) {
                bool inside = true;
                for (const auto& [q, w] : SubdivisionRow({x, y, z}, 2)) inside = inside && control.Contains(q);
                EXPECT_EQ(inside, fine.Contains({x, y, z}));
            }
}

TEST(LatticeExpected, GivesTheRowsTimesTheControlValues) {
    const LatticeValues control = RandomControl({4, 4, 4}, 3);
    const std::vector<LatticePoint> points = {{8, 8, 8}, {5, 9, 6}, {3, 3, 13}, {2, 8, 8}, {0, 0, 0}};
    const ExpectedValues expected = ExpectedAtLevel(control, 2, points);
    EXPECT_EQ(expected.known, (std::vector<bool>{true, true, true, false, false}));
    for (std::size_t row = 0; row < 3; ++row)
        for (int i = 0; i < 3; ++i) {
            double value = 0;
            for (const auto& [q, w] : SubdivisionRow(points[row], 2))
                value += w * control.values[control.Offset(q) + i];
            EXPECT_NEAR(expected.values[3 * row + i], value, 1e-15);  // two orders of summation of numbers below 1
        }
    EXPECT_EQ(expected.values[3 * 3], 0);
}

// The limit is a fixed point: level-L values under the limit mask are the box spline at dyadic points, at every L, to
// round-off.
TEST(LatticeLimit, MaskAppliedAtAnyLevelGivesTheClosedForm) {
    const LatticeValues spike = Spike(3);
    for (int level = 0; level <= 5; ++level) {
        const LatticeValues fine = SubdivideTimes(spike, level);
        const double step = std::ldexp(1.0, -level);
        double worst = 0;
        const auto at = [&](const LatticePoint& p, const LatticePoint& d, int sign) {
            return fine.values[fine.Offset({p[0] + sign * d[0], p[1] + sign * d[1], p[2] + sign * d[2]})];
        };
        ForEachPoint(fine, [&](const LatticePoint& p) {
            for (int i = 0; i < 3; ++i)
                if (p[i] == fine.lo[i] || p[i] == fine.hi[i] || std::abs(p[i]) > (2 << level)) return;
            double limit = 2.0 / 5 * at(p, {0, 0, 0}, 1);
            for (int k = 0; k < 4; ++k) {
                const LatticePoint& u = kDirections[k];
                limit += (at(p, u, 1) + at(p, u, -1)) / 20;
                for (int l = 0; l < k; ++l) {
                    const LatticePoint& w = kDirections[l];
                    limit += at(p, {u[0] + w[0], u[1] + w[1], u[2] + w[2]}, 1) / 30;
                }
            }
            const double exact = EvaluateBoxSpline({p[0] * step, p[1] * step, p[2] * step}).value;
            worst = std::max(worst, std::abs(limit - exact));
        });
        EXPECT_LT(worst, 5e-15) << "level " << level;  // the closed form itself is good to 3e-15
    }
}

TEST(LatticeLimit, IteratedSubdivisionConvergesWithOrderTwo) {
    const LatticeValues spike = Spike(3);
    double previous = 0;
    for (int level = 1; level <= 5; ++level) {
        const LatticeValues fine = SubdivideTimes(spike, level);
        const double step = std::ldexp(1.0, -level);
        double worst = 0;
        ForEachPoint(fine, [&](const LatticePoint& p) {
            const double exact = EvaluateBoxSpline({p[0] * step, p[1] * step, p[2] * step}).value;
            worst = std::max(worst, std::abs(fine.values[fine.Offset(p)] - exact));
        });
        // A fourth of the error from each level to the next; 10 % off that on the coarse levels.
        if (level >= 3) {
            EXPECT_NEAR(previous / worst, 4, 0.4) << "level " << level;
        }
        previous = worst;
    }
    EXPECT_LT(previous, 1e-3);
}

TEST(LatticeLimit, IsTheLimitOfSubdividedValues) {
    const LatticeValues control = RandomControl({4, 4, 4}, 2);
    const LatticeValues fine = SubdivideTimes(control, 2);
    for (const Point3& random : RandomPoints(50, 0.9, 23)) {
        const Point3 x = {2 + random[0], 2 + random[1], 2 + random[2]};
        const auto coarse_limit = ExpectedLimit(control, x);
        const auto fine_limit = ExpectedLimit(fine, {4 * x[0], 4 * x[1], 4 * x[2]});
        ASSERT_EQ(coarse_limit.size(), 2U);
        for (int w = 0; w < 2; ++w) {
            EXPECT_NEAR(coarse_limit[w].value, fine_limit[w].value, 1e-14);
            for (int i = 0; i < 3; ++i) {
                EXPECT_NEAR(coarse_limit[w].gradient[i], 4 * fine_limit[w].gradient[i], 1e-13);
                for (int j = 0; j < 3; ++j)
                    EXPECT_NEAR(coarse_limit[w].hessian[i][j], 16 * fine_limit[w].hessian[i][j], 1e-12);
            }
        }
    }
}

TEST(LatticeLimit, IsKnownUpToOneStepFromTheSides) {
    const LatticeValues control = RandomControl({2, 2, 2}, 1);
    EXPECT_NO_THROW(ExpectedLimit(control, {1, 1, 1}));
    EXPECT_THROW(ExpectedLimit(control, {1, 1, 1.001}), std::invalid_argument);
    EXPECT_THROW(ExpectedLimit(control, {0.999, 1, 1}), std::invalid_argument);
}

TEST(LatticeInput, RefusesWrongNumbersOfValuesAndThinBoxes) {
    EXPECT_THROW(ValuesOnBlock({1, 1, 1}, 2, std::vector<double>(15)), std::invalid_argument);
    EXPECT_THROW(Subdivide(ValuesOnBlock({0, 2, 2}, 1, std::vector<double>(9))), std::invalid_argument);
}

// A refiner with one weight off by 1e-6, played by changing one expected value's row.
TEST(LatticeFault, OneWeightOffByAMillionthIsNoticed) {
    const LatticeValues control = RandomControl({4, 4, 4}, 1);
    std::vector<LatticeWeight> row = SubdivisionRow({9, 8, 7}, 2);
    row[row.size() / 2].second += 1e-6;
    double value = 0;
    for (const auto& [q, w] : row) value += w * control.values[control.Offset(q)];
    EXPECT_GT(std::abs(value - ExpectedAtLevel(control, 2, {{9, 8, 7}}).values[0]), 1e-8);
    BoxSplineCoefficients faulty;
    faulty.shifts[1] += 1e-6;
    EXPECT_GT(std::abs(ExpectedLimit(control, {2.1, 2.2, 2.3}, faulty)[0].value -
                       ExpectedLimit(control, {2.1, 2.2, 2.3})[0].value),
              1e-8);
}

}  // namespace
}  // namespace SolidSubdiv::Validation
