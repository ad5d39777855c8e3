// SPDX-License-Identifier: Apache-2.0
// Grids of what is inside a solid: attributes, determinants, numbers of cells.
#pragma once

#include <solidsubdiv/apps/voxel/internal/tiles.h>
#include <solidsubdiv/apps/voxel/internal/vdb.h>
#include <solidsubdiv/apps/voxel/voxelize.h>

namespace SolidSubdiv::Voxel::Internal {

/// One grid for each attribute asked for. @throws Cancelled
openvdb::GridPtrVec MakeAttributeGrids(const Tiles& tiles, const Far::TopologyRefiner& refiner, int level,
                                       const VoxelizeOptions& options);

}  // namespace SolidSubdiv::Voxel::Internal
