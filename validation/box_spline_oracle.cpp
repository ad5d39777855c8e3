// SPDX-License-Identifier: Apache-2.0
// Folds a point into one chamber of the lattice's symmetry group, where the box spline is a sum of eight truncated
// powers.
#include "box_spline_oracle.h"

#include <algorithm>

namespace SolidSubdiv::Validation {
namespace {

// The cone spline of e1, e2, e3 and twice (1,1,1), with e1, e2, e3 doubled:
//     T(y) = integral over 0 < s < m of s (y1 - s)(y2 - s)(y3 - s),  m = min(y1, y2, y3),
// and 0 where m <= 0. Adds weight * T and its derivatives to the jet.
void AddTruncatedPower(const Point3& y, double weight, const std::array<double, 4>& power, BoxSplineJet& jet) {
    const double m = std::min({y[0], y[1], y[2]});
    if (m <= 0) return;
    const double m2 = power[0] * m * m, m3 = power[1] * m * m * m;
    const double m4 = power[2] * m * m * m * m, m5 = power[3] * m * m * m * m * m;
    jet.value += weight * (y[0] * y[1] * y[2] * m2 + (y[0] * y[1] + y[0] * y[2] + y[1] * y[2]) * m3 +
                           (y[0] + y[1] + y[2]) * m4 + m5);
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        jet.gradient[i] += weight * (y[j] * y[k] * m2 + (y[j] + y[k]) * m3 + m4);
        jet.hessian[j][k] += weight * (y[i] * m2 + m3);
        jet.hessian[k][j] += weight * (y[i] * m2 + m3);
        // Only the upper end of the integral depends on y_i twice over; equal smallest coordinates make this 0.
        if (y[i] == m) jet.hessian[i][i] += weight * m * (y[j] - m) * (y[k] - m);
    }
}

}  // namespace

BoxSplineJet EvaluateBoxSpline(const Point3& x, const BoxSplineCoefficients& coefficients) {
    // x = sum of c_k u_k, the c_k up to a common constant. Permuting the directions permutes the c_k and leaves N as it
    // is.
    const std::array<double, 4> c = {x[0], x[1], x[2], 0};
    std::array<int, 4> order = {0, 1, 2, 3};
    std::sort(order.begin(), order.end(), [&c](int a, int b) { return c[a] > c[b]; });
    const double lowest = c[order[3]];
    if (!(c[order[0]] - lowest < 2)) return {};

    // N(x) = N(-x): the reflected point, seen from the corner -(2,2,2) of the support. There y1 <= y2 <= y3 <= 2.
    Point3 y;
    for (int i = 0; i < 3; ++i) y[i] = 2 - (c[order[i]] - lowest);
    BoxSplineJet folded;
    for (int corner = 0; corner < 8; ++corner) {
        const std::array<int, 3> shift = {corner & 1, (corner >> 1) & 1, (corner >> 2) & 1};
        const Point3 shifted = {y[0] - shift[0], y[1] - shift[1], y[2] - shift[2]};
        AddTruncatedPower(shifted, coefficients.shifts[shift[0] + shift[1] + shift[2]], coefficients.powers, folded);
    }

    // Chain rule: dy_i/dx_k is -1 where x_k is the coordinate behind y_i, +1 where it is the lowest of the four.
    BoxSplineJet jet;
    jet.value = folded.value;
    Matrix3 dy{};
    for (int i = 0; i < 3; ++i) {
        if (order[i] < 3) dy[i][order[i]] -= 1;
        if (order[3] < 3) dy[i][order[3]] += 1;
    }
    for (int k = 0; k < 3; ++k) {
        for (int i = 0; i < 3; ++i) jet.gradient[k] += folded.gradient[i] * dy[i][k];
        for (int l = 0; l < 3; ++l)
            for (int i = 0; i < 3; ++i)
                for (int j = 0; j < 3; ++j) jet.hessian[k][l] += dy[i][k] * folded.hessian[i][j] * dy[j][l];
    }
    return jet;
}

}  // namespace SolidSubdiv::Validation
