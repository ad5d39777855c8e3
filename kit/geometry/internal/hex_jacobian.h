// SPDX-License-Identifier: Apache-2.0
// The determinant of a trilinear map's Jacobian as a polynomial in Bernstein form, and bounds of its minimum.
#pragma once

#include <array>

#include <solidsubdiv/kit/geometry/internal/trilinear.h>

namespace SolidSubdiv::Geometry::Internal {

/// A polynomial of degree 2 in each of u, v, w: coefficient i + 3j + 9k belongs to B_i(u) B_j(v) B_k(w).
struct TriquadraticBernstein {
    std::array<double, 27> coefficients{};

    double Least() const { return *std::min_element(coefficients.begin(), coefficients.end()); }
    /// The halves across an axis (0, 1, 2), by de Casteljau's steps.
    std::array<TriquadraticBernstein, 2> Halves(int axis) const;
};

/// Coefficients are means of determinants of edges, one edge along each axis.
TriquadraticBernstein JacobianOf(const Trilinear& hex);

struct JacobianMinimum {
    double least = 0;        ///< found, at `at`
    double lower_bound = 0;  ///< proved, but for rounding
    Vec3 at;
};

/// Cuts the cube until least - lower_bound is at most `near_enough` and the sign is known (lower_bound > rounding or
/// least < -rounding), or until there are most_parts parts.
JacobianMinimum FindJacobianMinimum(const Trilinear& hex, double near_enough, double rounding, int most_parts);

}  // namespace SolidSubdiv::Geometry::Internal
