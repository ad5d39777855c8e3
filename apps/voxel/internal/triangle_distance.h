// SPDX-License-Identifier: Apache-2.0
// Distances from the voxels of a tile to a triangle.
#pragma once

#include <array>
#include <span>

#include <solidsubdiv/apps/voxel/internal/tiles.h>

namespace SolidSubdiv::Voxel::Internal {

/// Lowers the squares of distances of a tile's voxels to that from a triangle, where it is less than reach^2.
/// @param corners relative to the tile's first voxel
void LowerDistances(const std::array<std::array<double, 3>, 3>& corners, float reach,
                    std::span<float, kTileVoxels> squares);

}  // namespace SolidSubdiv::Voxel::Internal
