// SPDX-License-Identifier: Apache-2.0
// One round's least-squares problem, for Ceres.
#pragma once

#include <span>
#include <string>
#include <vector>

#include <solidsubdiv/apps/fit/internal/pairs.h>

namespace SolidSubdiv::Fit::Internal {

/// What stays the same from round to round. Lengths are in the problem's own unit.
struct StepSettings {
    const Problem& problem;
    const Far::StencilRows<double>& fair_rows;  ///< of internal/fairness.h
    std::span<const double> least_volumes;      ///< of each corner
    double barrier = 0;
    double across = 0;
};

struct StepReport {
    int steps = 0;
    std::string linear_solver{};
};

/// Moves `control` to where pairs and fairness are least. @throws SolverError
StepReport SolveStep(const StepSettings& settings, std::span<const Pair> pairs, double fairness,
                     std::span<double> control);

}  // namespace SolidSubdiv::Fit::Internal
