// SPDX-License-Identifier: Apache-2.0
// What positions of a level must be, for everything that computes with them.
#pragma once

#include <span>

#include <solidsubdiv/far/topology_refiner.h>

namespace SolidSubdiv::Geometry::Internal {

/// Fourth powers of coordinates must not overflow.
inline constexpr double kLargestCoordinate = 1e75;

/// @throws InvalidInput naming the first row of `what` with a coordinate that is not finite or too large
void RequireUsable(std::span<const double> positions, const char* what);

/// @throws InvalidInput where there is no such level, positions are not three a vertex, or one is not usable
void RequirePositionsOfLevel(const Far::TopologyRefiner& refiner, int level, std::span<const double> positions);

}  // namespace SolidSubdiv::Geometry::Internal
