// SPDX-License-Identifier: Apache-2.0
// The box-spline solid on the regular lattice, without a mesh: subdivision as a convolution on Z^3, and its limit as a
// sum of box splines.
#pragma once

#include <array>
#include <utility>
#include <vector>

#include "box_spline_oracle.h"
#include "octet_truss.h"

namespace SolidSubdiv::Validation {

/// A coarse lattice point and its weight.
using LatticeWeight = std::pair<LatticePoint, double>;

/// Coefficients of (1/32) prod_k (z^-u_k + 2 + z^u_k), sorted by exponent. Over each parity class of exponents they sum
/// to 1.
std::vector<LatticeWeight> BoxSplineMask();

/// One row of the subdivision matrix over all of Z^3: the point `fine`/2^level as a combination of level-0 lattice
/// points, sorted. Weights are dyadic, hence exact. @pre level >= 0
std::vector<LatticeWeight> SubdivisionRow(const LatticePoint& fine, int level);

/// Values on all lattice points of the box lo..hi (both included), `width` numbers each.
struct LatticeValues {
    LatticePoint lo{}, hi{};
    int width = 1;
    std::vector<double> values;  ///< (n_points, width), row-major, points x fastest, then y, then z

    bool Contains(const LatticePoint& p) const;
    /// Index of the first number of point p in `values`. @pre Contains(p)
    int Offset(const LatticePoint& p) const;
};

/// Values on the vertices of a TrussBlock of this size, in its vertex order.
/// @throws std::invalid_argument if their number is not that of the vertices times the width
LatticeValues ValuesOnBlock(const LatticePoint& size, int width, std::vector<double> values);

/// One round of subdivision: the values at the integer points of the lattice scaled by two, from 2 lo + 1 to 2 hi - 1.
/// These are all points whose mask lies inside; after L rounds it is every point that is not nearer to a side of the
/// box than 1 - 1/2^L. On a mesh of the same block these are the points that feel no boundary rule.
/// @throws std::invalid_argument if nothing would be left
LatticeValues Subdivide(const LatticeValues& coarse);

/// What a refiner must give at the points fine_points/2^level, row by row; `known` tells which lie far enough from the
/// sides (the others are left 0).
struct ExpectedValues {
    std::vector<double> values;  ///< (n_points, width)
    std::vector<bool> known;
};
ExpectedValues ExpectedAtLevel(const LatticeValues& control, int level, const std::vector<LatticePoint>& fine_points);

/// The limit sum_i v_i N(x - i) and its derivatives with respect to lattice coordinates, one entry per number of the
/// values. @throws std::invalid_argument unless lo + 1 <= x <= hi - 1: else part of the sum is missing
std::vector<BoxSplineJet> ExpectedLimit(const LatticeValues& control, const Point3& x,
                                        const BoxSplineCoefficients& coefficients = {});

}  // namespace SolidSubdiv::Validation
