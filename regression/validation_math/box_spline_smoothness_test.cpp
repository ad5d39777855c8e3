// SPDX-License-Identifier: Apache-2.0
// Support, pieces and smoothness of the box spline: quintic in every tet, C2 and no more across the knot planes.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "validation/box_spline_oracle.h"
#include "validation_math/random_points.h"

namespace SolidSubdiv::Validation {
namespace {

double Largest(double a, double b) { return std::max(a, std::abs(b)); }

double Difference(const BoxSplineJet& a, const BoxSplineJet& b) {
    double worst = std::abs(a.value - b.value);
    for (int i = 0; i < 3; ++i) {
        worst = Largest(worst, a.gradient[i] - b.gradient[i]);
        for (int j = 0; j < 3; ++j) worst = Largest(worst, a.hessian[i][j] - b.hessian[i][j]);
    }
    return worst;
}

TEST(BoxSpline, HasSupportWhereCoordinatesDifferByLessThanTwo) {
    int inside = 0, outside = 0;
    for (const Point3& x : RandomPoints(3000, 3, 7)) {
        const auto [low, high] = std::minmax({x[0], x[1], x[2], 0.0});
        const double value = EvaluateBoxSpline(x).value;
        if (high - low < 1.99) {
            EXPECT_GT(value, 0);
            ++inside;
        } else if (high - low >= 2) {
            EXPECT_EQ(value, 0);
            ++outside;
        }
    }
    EXPECT_GT(inside, 100);
    EXPECT_GT(outside, 100);
}

// The six families of knot planes have the normals e_k and e_i - e_j.
constexpr std::array<Point3, 6> kNormals = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, -1, 0}, {1, 0, -1}, {0, 1, -1}}};

// Projects a point onto the knot plane normal . x = level.
Point3 OnPlane(Point3 x, const Point3& normal, double level) {
    const double length2 = normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2];
    const double gap = (level - normal[0] * x[0] - normal[1] * x[1] - normal[2] * x[2]) / length2;
    for (int k = 0; k < 3; ++k) x[k] += gap * normal[k];
    return x;
}

TEST(BoxSpline, IsTwiceContinuouslyDifferentiableAcrossKnotPlanes) {
    const double h = 1e-7;
    for (const Point3& normal : kNormals)
        for (int level = -2; level <= 2; ++level)
            for (const Point3& random : RandomPoints(50, 1.5, 8)) {
                const Point3 x = OnPlane(random, normal, level);
                Point3 before = x, after = x;
                for (int k = 0; k < 3; ++k) {
                    before[k] -= h * normal[k];
                    after[k] += h * normal[k];
                }
                // 2h times a third derivative of at most about 10, times the normal's length.
                EXPECT_LT(Difference(EvaluateBoxSpline(before), EvaluateBoxSpline(after)), 1e-5);
            }
}

TEST(BoxSpline, ThirdDerivativeJumpsAtEveryFamilyOfKnotPlanes) {
    const double h = 1e-4;
    for (const Point3& normal : kNormals) {
        double largest = 0;
        for (const Point3& random : RandomPoints(50, 1, 9)) {
            const Point3 x = OnPlane(random, normal, 0);
            const auto second = [&](double t) {
                const Matrix3 q =
                    EvaluateBoxSpline({x[0] + t * normal[0], x[1] + t * normal[1], x[2] + t * normal[2]}).hessian;
                double sum = 0;
                for (int i = 0; i < 3; ++i)
                    for (int j = 0; j < 3; ++j) sum += normal[i] * q[i][j] * normal[j];
                return sum;
            };
            largest = Largest(largest, (second(h) - 2 * second(0) + second(-h)) / h);
        }
        EXPECT_GT(largest, 0.1);
    }
}

TEST(BoxSpline, IsQuinticInsideEachTet) {
    for (const Point3& corner : RandomPoints(200, 1.9, 10)) {
        // A line from a tet's centroid, short enough to stay inside: 0, e1, e1 + e2, (1,1,1) has inradius > 0.15.
        const Point3 centre = {std::floor(corner[0]) + 0.75, std::floor(corner[1]) + 0.5, std::floor(corner[2]) + 0.25};
        const std::array<double, 7> sixth_difference = {1, -6, 15, -20, 15, -6, 1};
        const std::array<double, 6> fifth_difference = {-1, 5, -10, 10, -5, 1};
        double sixth = 0, fifth = 0;
        for (int s = 0; s <= 6; ++s) {
            const double t = 0.02 * (s - 3);
            const double value = EvaluateBoxSpline({centre[0] + t, centre[1] - 2 * t, centre[2] + t}).value;
            sixth += sixth_difference[s] * value;
            if (s < 6) fifth += fifth_difference[s] * value;
        }
        EXPECT_LT(std::abs(sixth), 64 * 2e-15);
        EXPECT_LT(std::abs(fifth), 1e-4);
    }
}

}  // namespace
}  // namespace SolidSubdiv::Validation
