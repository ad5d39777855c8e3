// SPDX-License-Identifier: Apache-2.0
// A complex on integer points, refined, with the place of every vertex of every level by its parents.
#pragma once

#include <array>
#include <vector>

#include <solidsubdiv/far/topology_refiner.h>

#include "octet_truss.h"

namespace SolidSubdiv::Validation {

/// `points[l]`: where the vertices of level l lie if nothing moves, times 2^l. Inside each control cell that is an
/// affine picture of the octet truss, so around a vertex each level looks like the one before, halved.
struct RefinedPoints {
    Far::TopologyRefiner refiner;
    std::vector<std::vector<LatticePoint>> points;
};

/// Cells are taken as ordered; all levels keep full topology. @throws InvalidInput if the refiner can't take them
RefinedPoints RefinePoints(const std::vector<LatticePoint>& points, const std::vector<std::array<int, 4>>& tets,
                           const std::vector<std::array<int, 6>>& octs, int max_level);

}  // namespace SolidSubdiv::Validation
