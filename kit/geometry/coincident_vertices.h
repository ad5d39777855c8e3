// SPDX-License-Identifier: Apache-2.0
// Vertices at the same place: often a mesh whose parts were meant to be joined.
#pragma once

#include <span>
#include <vector>

#include <solidsubdiv/sdc/types.h>

namespace SolidSubdiv::Geometry {

/// Vertices, ascending, that have exactly the position of a vertex of lower number. Positions are (n, 3).
/// Cost: a sort of the positions.
std::vector<Index> FindCoincidentVertices(std::span<const double> positions);

}  // namespace SolidSubdiv::Geometry
