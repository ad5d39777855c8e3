// SPDX-License-Identifier: Apache-2.0
// Holds octree lattices to published numbers of cells and to what a count of the model's vertices says.
#pragma once

#include <span>
#include <vector>

#include <solidsubdiv/apps/deform/octree_lattices.h>

#include "findings.h"

namespace SolidSubdiv::Validation {

/// Cells of levels 0 to 5 against table 1 of ono2002ffd (1, 8, 64, 512, 4096, 32768), control points against
/// (2^i + 1)^3. Differences are errors of their own size.
void CompareWithTable(std::span<const Deform::LatticeLevel> levels, Findings& findings);

/// A lattice of 2^level cells along each side of the points' box, cut by points, (n, 3). Faults: cells that hold no
/// point, points in no cell (on sides between cells, within rounding, either will do). Errors: control points more or
/// fewer than the cells have corners in different places, cells given twice.
void CompareWithPoints(const Deform::ControlLattice& lattice, int level, std::span<const double> points,
                       Findings& findings);

}  // namespace SolidSubdiv::Validation
