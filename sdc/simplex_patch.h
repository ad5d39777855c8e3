// SPDX-License-Identifier: Apache-2.0
// What box splines are inside one cell of their regular lattice: a polynomial in Bernstein form for each control point.
//
// In d dimensions the lattice has d + 1 directions that sum to zero, each twice in the spline: quintic on the tets of
// the body-centred cubic lattice (d = 3, chang2002boxspline), quartic on triangles (d = 2: Loop's surfaces where all
// valences are six, loop1987). Of all lattice points 32, or 12, count inside a cell.
//
//     const auto& patch = Sdc::QuinticTet();
//     patch.Evaluate({1. / 4, 1. / 4, 1. / 4}, 1, weights);  // of patch.points, then their derivatives by u, v, w
#pragma once

#include <array>
#include <span>
#include <vector>

namespace SolidSubdiv::Sdc {

class SimplexPatch {
  public:
    using Point = std::array<int, 3>;

    /// Points of the cell itself: those of a tet with its B edges v0v1 and v2v3, in the cubic lattice of which all
    /// coordinates are even or all odd; or those of a triangle, in axes along two of its edges.
    std::span<const Point> corners() const { return corners_; }
    /// The control points, the corners first.
    std::span<const Point> points() const { return points_; }

    int n_points() const { return static_cast<int>(points_.size()); }
    int dimension() const { return dimension_; }

    /// Number of columns that Evaluate fills.
    static constexpr int NDerivatives(int dimension, int order) {
        return order == 0 ? 0 : order == 1 ? dimension : dimension + dimension * (dimension + 1) / 2;
    }

    /// Weights of the control points at a place, `at` being the weights of corners 1, 2 (, 3): n_points() numbers;
    /// then, as many each, derivatives by u, v (, w) if order >= 1, by uu, uv, (uw,) vv (, vw, ww) if order = 2.
    void Evaluate(const std::array<double, 3>& at, int order, double* weights) const;

    /// @param dimension 2 or 3
    explicit SimplexPatch(int dimension);

  private:
    /// Bernstein coefficients of degree `degree` of all points: (number of exponents, n_points).
    struct Net {
        int degree = 0;
        std::vector<double> coefficients;
    };
    Net Derivative(const Net& net, int axis) const;
    void Fill(const Net& net, const std::array<double, 4>& barycentric, double* weights) const;

    int dimension_;
    std::vector<Point> corners_, points_;
    std::vector<Net> nets_;  // of the value, then of the derivatives
};

/// The same for everybody, made when first asked for.
const SimplexPatch& QuinticTet();
const SimplexPatch& QuarticTriangle();

}  // namespace SolidSubdiv::Sdc
