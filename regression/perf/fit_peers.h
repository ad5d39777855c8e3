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
    Grouped   ///< 256 rows at most that have their largest weight at one control point
};

/// What Fit::Internal::SolveStep does, by Levenberg-Marquardt, with derivatives that are Ceres' own
/// (DynamicAutoDiffCostFunction for rows, AutoDiffCostFunction for corners).
void SolveByAutoDiff(Blocks blocks, const Fit::Internal::StepSettings& settings,
                     std::span<const Fit::Internal::Pair> pairs, double fairness, std::span<double> control);

/// By Levenberg-Marquardt, on as many threads as there are: small problems by a sparse Cholesky decomposition, others
/// by conjugate gradients, which is quickest for each.
void SolveByTrustRegion(ceres::Problem& problem, std::size_t n_unknowns, double trust_radius);

}  // namespace SolidSubdiv::Perf
