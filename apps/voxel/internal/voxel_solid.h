// SPDX-License-Identifier: Apache-2.0
// A level of a solid in the coordinates of voxels.
#pragma once

#include <span>

#include <solidsubdiv/apps/voxel/internal/tiles.h>
#include <solidsubdiv/far/topology_refiner.h>

namespace SolidSubdiv::Voxel::Internal {

/// @throws InvalidInput where there is no such level or no cell, or a position is not finite
VoxelSolid MakeVoxelSolid(const Far::TopologyRefiner& refiner, int level, std::span<const double> positions,
                          double voxel_size);

}  // namespace SolidSubdiv::Voxel::Internal
