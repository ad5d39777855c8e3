// SPDX-License-Identifier: Apache-2.0
// A sum of squares of rows, each three numbers M (sum over points of weight * position - goal), as one quadratic form.
//
// However many rows there are, what is kept are 3 x 3 blocks for pairs of control points that share one: a sum over
// them takes a hundredth of the time of one over the rows.
#pragma once

#include <array>
#include <span>
#include <utility>
#include <vector>

#include <solidsubdiv/sdc/types.h>

namespace SolidSubdiv::Fit::Internal {

class NormalEquations {
  public:
    using Weights = std::span<const std::pair<Index, double>>;  ///< of points, each once

    /// About points `at` (n, 3): forms are small differences from there, and lose no digits.
    explicit NormalEquations(std::span<const double> at);

    /// Adds |M (sum of weight * position - goal)|^2 / 2; M is symmetric, row-major.
    void Add(Weights weights, const std::array<double, 3>& goal, const std::array<double, 9>& matrix);

    /// Half the sum of squares, all of it, where points have moved by (n, 3), and its slope, (n, 3), if asked for.
    double Evaluate(std::span<const double> moved, std::span<double> slope) const;
    /// (3, 3), row-major, of a point with itself.
    std::array<double, 9> Diagonal(Index point) const;

  private:
    struct Block {
        Index column;
        std::array<double, 9> sum{};
    };
    std::span<const double> at_;
    std::vector<std::vector<Block>> rows_;  ///< of each point
    std::vector<double> slope_;             ///< at the start
    double start_ = 0;                      ///< half the sum there
};

}  // namespace SolidSubdiv::Fit::Internal
