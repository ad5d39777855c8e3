// SPDX-License-Identifier: Apache-2.0
// An order of points in which those that follow each other lie near each other: along a Hilbert curve through a cube.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <solidsubdiv/sdc/types.h>

namespace SolidSubdiv::Geometry::Internal {

/// The place on the curve of a point of the cube [-1, 1]^3; what lies outside counts as on its surface. 30 bits.
std::uint32_t CurveKey(const float point[3]);

/// Numbers of the keys in ascending order; equal keys keep theirs. @pre keys have 30 bits
std::vector<Index> OrderByKey(std::span<const std::uint32_t> keys);

}  // namespace SolidSubdiv::Geometry::Internal
