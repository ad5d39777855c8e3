// SPDX-License-Identifier: Apache-2.0
// What is squared and summed: three numbers a row, linear in control points. The weights of rows are the derivatives.
#pragma once

#include <array>
#include <span>
#include <utility>
#include <vector>

#include <solidsubdiv/apps/fit/internal/pairs.h>
#include <solidsubdiv/far/stencil_table.h>
#include <solidsubdiv/sdc/types.h>

namespace SolidSubdiv::Fit::Internal {

/// M (sum over control points of weight * position - goal).
struct LinearRow {
    std::vector<std::pair<Index, double>> weights;  ///< of control points, each once
    std::array<double, 3> goal{};
    std::array<double, 9> matrix{};  ///< M, row-major, symmetric

    std::array<double, 3> Residuals(std::span<const double> control) const;
};

/// What a pair is in the sum of squares.
LinearRow RowOf(const Pair& pair, const MovingSurface& surface, double across);
/// Fairness at a control point; no weights where it has none.
LinearRow FairRowOf(const Far::StencilRows<double>& fair_rows, Index point, double fairness);

}  // namespace SolidSubdiv::Fit::Internal
