// SPDX-License-Identifier: Apache-2.0
// The least-squares problem of a round of fitting, given to Ceres as its users write it: differentiated by machine.
#pragma once

#include <span>
#include <vector>

#include <ceres/problem.h>
#include <solidsubdiv/apps/fit/internal/step.h>

namespace SolidSubdiv::Perf {

enum class Blocks {
    OneARow,  ///< a block a residual row, as one writes it first
    Grouped   ///< rows together that ours has together
};

/// What Fit::Internal::SolveStep does, with the same settings of the solver, but that derivatives are Ceres' own
/// (DynamicAutoDiffCostFunction for rows, AutoDiffCostFunction for corners).
void SolveByAutoDiff(Blocks blocks, const Fit::Internal::StepSettings& settings,
                     std::span<const Fit::Internal::Pair> pairs, double fairness, std::span<double> control);

/// With the settings of Fit::Internal::SolveStep, on as many threads as there are.
void SolveAsOurs(ceres::Problem& problem, std::size_t n_unknowns, double trust_radius);

}  // namespace SolidSubdiv::Perf
