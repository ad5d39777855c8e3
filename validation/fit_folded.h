// SPDX-License-Identifier: Apache-2.0
// Looks for folds of fitted solids at random places.
#pragma once

#include <span>
#include <string>
#include <vector>

#include <solidsubdiv/apps/fit/fit.h>
#include <solidsubdiv/kit/geometry/cell_quality.h>

#include "findings.h"

namespace SolidSubdiv::Validation {

/// A solid and what a fit made of it, refined alike.
struct FitLevels {
    FitLevels(const Fit::ControlMesh& at_rest, const std::vector<double>& fitted, const Sdc::Scheme& scheme,
              int n_levels);

    Far::TopologyRefiner refiner;
    std::vector<std::vector<double>> before, after;  ///< positions of each level
};

/// Cells with a random place, of n in the level, where the map from the solid at rest to the fitted one turns over: the
/// determinant there, by differences of points alone, is not positive. A cell stands there once a place.
/// @pre the solid at rest is valid
std::vector<Index> FoldedCells(const FitLevels& levels, int level, int n_places);

/// Faults where a cell that was found folded is proved positive.
void CompareVerdicts(std::span<const Geometry::CellQuality> verdicts, std::span<const Index> folded,
                     const std::string& what, Findings& findings);

}  // namespace SolidSubdiv::Validation
