// SPDX-License-Identifier: Apache-2.0
// Holds the largest distances that fits report to CGAL's.
#pragma once

#include "findings.h"
#include "fit_shapes.h"

namespace SolidSubdiv::Validation {

/// Our figure is measured at points, so it is at most the true one, and lacks at most how far a point of the surface
/// can be from the next one measured. Errors are what exceeds either, over the size.
/// @param theirs within `bound` of the true one @param gap between points measured
void CompareMost(double ours, double theirs, double bound, double gap, double size, Findings& findings);

/// The largest distance of one surface from the other by both.
void CheckDistance(const FitTarget& from, const FitTarget& to, Findings& findings);

}  // namespace SolidSubdiv::Validation
