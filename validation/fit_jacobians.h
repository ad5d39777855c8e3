// SPDX-License-Identifier: Apache-2.0
// Holds the derivatives that fits hand to their solver to differences of the residuals.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include <ceres/cost_function.h>
#include <solidsubdiv/apps/fit/fit.h>

#include "findings.h"

namespace SolidSubdiv::Validation {

/// Compares the derivatives of one block by its parameters, three numbers a control point, with central differences:
/// errors over the block's largest derivative. Residuals that begin or cease within a step are left out.
void CompareJacobian(const ceres::CostFunction& block, const std::vector<Index>& points,
                     std::span<const double> control, const std::string& what, Findings& findings);

/// Likewise an energy that adds its slope to zeros, (n, 3) as positions are.
void CompareSlope(const std::function<double(std::span<const double>, std::span<double>)>& energy,
                  std::span<const double> at, const std::string& what, Findings& findings);

/// All rows of a round of a problem of size 1, their normal equations, and the barrier. Every kind of row that it can
/// have must be there.
void CheckJacobians(const Fit::Problem& problem, double robust, Findings& findings);

}  // namespace SolidSubdiv::Validation
