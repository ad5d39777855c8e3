// SPDX-License-Identifier: Apache-2.0
// The step of one round.
#pragma once

#include <span>

#include <solidsubdiv/apps/fit/internal/pairs.h>
#include <solidsubdiv/apps/fit/internal/rows.h>

namespace SolidSubdiv::Fit::Internal {

/// What stays the same from round to round. Lengths are in the problem's own unit.
struct StepSettings {
    const Problem& problem;
    const Far::StencilRows<double>& fair_rows;  ///< of internal/fairness.h
    std::span<const double> enough;             ///< of each corner: the scaled Jacobian at which the barrier ends
    double barrier = 0;
    double across = 0;
    std::span<const LinearRow> more{};  ///< rows of other terms (internal/more_rows.h)
};

/// Moves `control` to where rows and barrier are least. @return steps of the solver. @throws SolverError
int SolveStep(const StepSettings& settings, std::span<const Pair> pairs, double fairness, std::span<double> control);

}  // namespace SolidSubdiv::Fit::Internal
