// SPDX-License-Identifier: Apache-2.0
// The validators' only file that includes OpenVDB.
#include "voxel_oracle.h"

#include <openvdb/openvdb.h>
#include <openvdb/tools/MeshToVolume.h>

namespace SolidSubdiv::Validation {

void MeshToVolume(const TriangleSurface& surface, VoxelBlock& block) {
    openvdb::initialize();
    std::vector<openvdb::Vec3s> points;
    std::vector<openvdb::Vec3I> triangles;
    // It takes points in voxels.
    const auto in_voxels = [&](std::size_t i) { return static_cast<float>(surface.points[i] / block.voxel_size); };
    for (std::size_t i = 0; i < surface.points.size(); i += 3) {
        points.emplace_back(in_voxels(i), in_voxels(i + 1), in_voxels(i + 2));
    }
    for (std::size_t i = 0; i < surface.triangles.size(); i += 3) {
        const auto v = [&](std::size_t k) { return static_cast<openvdb::Index32>(surface.triangles[i + k]); };
        triangles.emplace_back(v(0), v(1), v(2));
    }
    const auto width = static_cast<float>(block.half_width);
    const auto grid = openvdb::tools::meshToVolume<openvdb::FloatGrid>(
        openvdb::tools::QuadAndTriangleDataAdapter<openvdb::Vec3s, openvdb::Vec3I>(points, triangles),
        *openvdb::math::Transform::createLinearTransform(block.voxel_size), width, width,
        // What it does by default to make gradients of length 1 moves curved surfaces by several hundredths of a voxel.
        openvdb::tools::DISABLE_RENORMALIZATION);
    block.values.clear();
    const auto accessor = grid->getConstAccessor();
    for (int x = block.low[0]; x <= block.high[0]; ++x) {
        for (int y = block.low[1]; y <= block.high[1]; ++y) {
            for (int z = block.low[2]; z <= block.high[2]; ++z) {
                block.values.push_back(static_cast<double>(accessor.getValue({x, y, z})));
            }
        }
    }
}

}  // namespace SolidSubdiv::Validation
