// SPDX-License-Identifier: Apache-2.0
// OpenVDB, and what stands behind Grids. Included in few source files: it takes half a minute to compile.
#pragma once

#include <solidsubdiv/apps/voxel/grids.h>

#include <openvdb/openvdb.h>

namespace SolidSubdiv::Voxel {

struct Grids::State {
    openvdb::GridPtrVec grids;
};

namespace Internal {

/// OpenVDB registers its types once a process; any thread may ask.
void InitializeVdb();

}  // namespace Internal

}  // namespace SolidSubdiv::Voxel
