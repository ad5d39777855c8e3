// SPDX-License-Identifier: Apache-2.0
// Stands in for voxel_oracle.cpp and voxel_grids.cpp where OpenVDB was not found: says so.
#include "findings.h"
#include "voxel_attributes.h"
#include "voxel_level_set.h"

namespace SolidSubdiv::Validation {

namespace {

[[noreturn]] void Missing() {
    throw Unavailable{"OpenVDB was not found when this program was built (Debian: libopenvdb-dev)"};
}

}  // namespace

ShapeVoxels VoxelizeShape(const VoxelShape&, double, double) { Missing(); }
void MeshToVolume(const TriangleSurface&, VoxelBlock&) { Missing(); }
VoxelSamples SampleVoxels(const VoxelShape&, double, int, unsigned) { Missing(); }

}  // namespace SolidSubdiv::Validation
