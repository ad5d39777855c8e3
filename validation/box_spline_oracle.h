// SPDX-License-Identifier: Apache-2.0
// The box spline N(2,2,2,2) in closed form: value, gradient and Hessian at any point. An oracle: it shares no code with
// the library.
#pragma once

#include <array>

namespace SolidSubdiv::Validation {

using Point3 = std::array<double, 3>;
using Matrix3 = std::array<std::array<double, 3>, 3>;

/// The constants of the closed form. Tests change one by 1e-6 to see that the laws notice; nobody else touches them.
struct BoxSplineCoefficients {
    /// Weights of the truncated power shifted by 0, by one e_i, by e_i + e_j, and by (1,1,1).
    std::array<double, 4> shifts = {1, -2, 4, -10};
    /// Coefficients of m^2, m^3, m^4, m^5 in the truncated power, m its smallest coordinate.
    std::array<double, 4> powers = {1.0 / 2, -1.0 / 3, 1.0 / 4, -1.0 / 5};
};

struct BoxSplineJet {
    double value = 0;
    Point3 gradient{};
    Matrix3 hessian{};
};

/// The quintic C2 box spline with directions u1 = e1, u2 = e2, u3 = e3, u4 = -(1,1,1), each twice, centred at the
/// origin; its integer translates sum to 1. It vanishes where the largest and the smallest of x1, x2, x3, 0 differ by 2
/// or more. Exact to a few units of round-off of 1 (a sum of eight quintic polynomials whose terms are at most 6 in
/// total). Derivation: docs/derivations/box_spline_bcc.md.
BoxSplineJet EvaluateBoxSpline(const Point3& x, const BoxSplineCoefficients& coefficients = {});

}  // namespace SolidSubdiv::Validation
