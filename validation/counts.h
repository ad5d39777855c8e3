// SPDX-License-Identifier: Apache-2.0
// Holds the numbers of parts of every level to sets of vertices, to the formulas, and to published figures.
#pragma once

#include <span>
#include <vector>

#include <solidsubdiv/far/topology_refiner.h>

#include "cells_oracle.h"
#include "findings.h"

namespace SolidSubdiv::Validation {

/// What a level says of itself, and its cells.
struct CountedLevel {
    PartCounts counts;
    Complex cells;
};
std::vector<CountedLevel> LevelsOf(const Far::TopologyRefiner& refiner);

/// Each level's counts against those of the vertex sets of its cells, and against the formulas from level 0 on. Every
/// difference is an error of its own size. @pre every vertex of the mesh is in a cell
void CompareCounts(std::span<const CountedLevel> levels, Findings& findings);

/// Cells of levels 0, 1, ... against published figures.
void ComparePublished(std::span<const CountedLevel> levels, std::span<const std::int64_t> n_cells, Findings& findings);

}  // namespace SolidSubdiv::Validation
