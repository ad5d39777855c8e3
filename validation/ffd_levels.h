// SPDX-License-Identifier: Apache-2.0
// Holds changes of level in editing sessions to the law that they move no vertex.
#pragma once

#include <span>
#include <string>
#include <vector>

#include <solidsubdiv/apps/deform/editing_session.h>
#include <solidsubdiv/apps/deform/octree_lattices.h>

#include "findings.h"

namespace SolidSubdiv::Validation {

/// The largest distance between points before and after, (n, 3), over the size.
void CompareStill(std::span<const double> before, std::span<const double> after, double size, const std::string& what,
                  Findings& findings);

/// Edits a model through all levels of a hierarchy, down, up and down again, with a move of some control points at each
/// and a lattice around everything in between, and compares the model before and after each change of level. Notes how
/// far a change without correction would have moved it.
void CheckLevels(const std::vector<double>& model, const Deform::LatticeHierarchy& hierarchy, Findings& findings);

}  // namespace SolidSubdiv::Validation
