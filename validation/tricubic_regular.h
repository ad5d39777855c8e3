// SPDX-License-Identifier: Apache-2.0
// Holds tables made on a regular block of hexahedra to tensor products of cubic B-splines: knot insertion for values,
// the closed form for limits. Places are matched by the refiner's parent-child relations.
#pragma once

#include <array>
#include <vector>

#include <solidsubdiv/far/limit_stencil_table.h>
#include <solidsubdiv/far/stencil_table.h>

#include "findings.h"
#include "solid_shapes.h"

namespace SolidSubdiv::Validation {

/// n^3 cubes refined, where every vertex of every level lies, in steps of 1/2^level, and random control values.
struct RefinedCubes {
    RefinedCubes(int n_cubes, int max_level);

    int n;
    Far::TopologyRefiner refiner;
    std::vector<std::vector<std::array<int, 3>>> places;
    std::vector<double> control;  ///< three a vertex, in [-1, 1]; vertex x + (n + 1) (y + (n + 1) z) at (x y z)

    /// Whether no boundary rule reaches a place of a level, or any place next to it.
    bool IsInside(int level, const std::array<int, 3>& place, bool with_neighbors = false) const;
};

/// Values at all levels by the table against knot insertion.
void CompareWithKnotInsertion(const RefinedCubes& cubes, const Far::StencilTable& table, Findings& findings);

/// Limits at a level's vertices, by rows over that level's values, against the spline of the control values there.
void CompareWithTricubic(const RefinedCubes& cubes, const Far::StencilTable& table,
                         const Far::StencilRows<double>& limits, int level, Findings& findings);

}  // namespace SolidSubdiv::Validation
