// SPDX-License-Identifier: Apache-2.0
// Holds the derivatives that fits hand to their solver to differences of the residuals.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include <solidsubdiv/apps/fit/fit.h>

#include "findings.h"

namespace SolidSubdiv::Validation {

/// Compares the slope of an energy, which it adds to zeros, (n, 3) as positions are, with central differences: errors
/// over the largest slope.
void CompareSlope(const std::function<double(std::span<const double>, std::span<double>)>& energy,
                  std::span<const double> at, const std::string& what, Findings& findings);

/// All rows of a round of a problem of size 1, their normal equations, and the barrier. Every kind of row that it can
/// have must be there.
void CheckJacobians(const Fit::Problem& problem, double robust, Findings& findings);

}  // namespace SolidSubdiv::Validation
