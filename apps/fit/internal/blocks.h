// SPDX-License-Identifier: Apache-2.0
// Residual blocks of what is linear in control points. The weights of rows are the derivatives.
#pragma once

#include <array>
#include <span>
#include <vector>

#include <ceres/cost_function.h>

#include <solidsubdiv/far/stencil_table.h>
#include <solidsubdiv/sdc/types.h>

namespace SolidSubdiv::Fit::Internal {

/// Residuals that are three numbers a row: M (sum over control points of weight * position - goal).
class LinearBlock final : public ceres::CostFunction {
  public:
    struct Row {
        std::vector<std::pair<Index, double>> weights;  ///< of control points
        std::array<double, 3> goal{};
        std::array<double, 9> matrix{};  ///< M, row-major
    };
    /// Of rows that share most of their control points: each is as wide as all of them together.
    explicit LinearBlock(std::span<const Row> rows);

    /// In the order of the parameter blocks.
    const std::vector<Index>& control_points() const { return control_points_; }

    bool Evaluate(double const* const* parameters, double* residuals, double** jacobians) const override;

  private:
    std::vector<Index> control_points_;
    std::vector<double> weights_;  ///< (rows, control points)
    std::vector<std::array<double, 3>> goals_;
    std::vector<std::array<double, 9>> matrices_;
};

}  // namespace SolidSubdiv::Fit::Internal
