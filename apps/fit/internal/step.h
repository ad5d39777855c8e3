// SPDX-License-Identifier: Apache-2.0
// One round's least-squares problem, for Ceres.
#pragma once

#include <span>
#include <string>
#include <vector>

#include <solidsubdiv/apps/fit/internal/blocks.h>
#include <solidsubdiv/apps/fit/internal/pairs.h>

namespace SolidSubdiv::Fit::Internal {

/// What stays the same from round to round. Lengths are in the problem's own unit.
struct StepSettings {
    const Problem& problem;
    const Far::StencilRows<double>& fair_rows;  ///< of internal/fairness.h
    std::span<const double> enough;             ///< of each corner: the scaled Jacobian at which the barrier ends
    double barrier = 0;
    double across = 0;
    std::span<const LinearBlock::Row> more{};  ///< rows of other terms (internal/more_rows.h)
};

struct StepReport {
    int steps = 0;
    std::string linear_solver{};
};

/// What a pair is in the sum of squares.
LinearBlock::Row RowOf(const Pair& pair, const MovingSurface& surface, double across);
/// Fairness at a control point; no weights where it has none.
LinearBlock::Row FairRowOf(const Far::StencilRows<double>& fair_rows, Index point, double fairness);

/// Moves `control` to where pairs and fairness are least. @throws SolverError
StepReport SolveStep(const StepSettings& settings, std::span<const Pair> pairs, double fairness,
                     std::span<double> control);

}  // namespace SolidSubdiv::Fit::Internal
