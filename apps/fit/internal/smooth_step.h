// SPDX-License-Identifier: Apache-2.0
// One round's step where cells must not fold.
#pragma once

#include <solidsubdiv/apps/fit/internal/step.h>

namespace SolidSubdiv::Fit::Internal {

/// As SolveStep, with the energy of corners. @throws SolverError
StepReport SolveSmoothStep(const StepSettings& settings, std::span<const Pair> pairs, double fairness,
                           std::span<double> control);

}  // namespace SolidSubdiv::Fit::Internal
