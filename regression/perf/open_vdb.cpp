// SPDX-License-Identifier: Apache-2.0
// Threads are those of the race: it limits oneTBB's, which OpenVDB uses.
#include "perf/open_vdb.h"

#include <openvdb/tools/MeshToVolume.h>
#include <tbb/global_control.h>

#include <vector>

namespace SolidSubdiv::Perf {

struct OpenVdbPeer::State {
    std::vector<openvdb::Vec3s> points;
    std::vector<openvdb::Vec3I> triangles;
    openvdb::FloatGrid::Ptr grid;
};

OpenVdbPeer::OpenVdbPeer(std::span<const double> positions, std::span<const Index> triangles)
    : state_(std::make_unique<State>()) {
    openvdb::initialize();
    std::vector<Index> numbers(positions.size() / 3, kNoIndex);
    for (std::size_t t = 0; t < triangles.size(); t += 3) {
        openvdb::Vec3I corners;
        for (std::size_t k = 0; k < 3; ++k) {
            const auto v = static_cast<std::size_t>(triangles[t + k]);
            if (numbers[v] == kNoIndex) {
                numbers[v] = static_cast<Index>(state_->points.size());
                const double* const p = &positions[3 * v];
                state_->points.emplace_back(static_cast<float>(p[0]), static_cast<float>(p[1]),
                                            static_cast<float>(p[2]));
            }
            corners[static_cast<int>(k)] = static_cast<openvdb::Index32>(numbers[v]);
        }
        state_->triangles.push_back(corners);
    }
}

OpenVdbPeer::~OpenVdbPeer() = default;

Offset OpenVdbPeer::MeshToLevelSet(double voxel_size, double half_width, int n_threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(n_threads));
    const auto transform = openvdb::math::Transform::createLinearTransform(voxel_size);
    state_->grid = openvdb::tools::meshToLevelSet<openvdb::FloatGrid>(*transform, state_->points, state_->triangles,
                                                                      static_cast<float>(half_width));
    return static_cast<Offset>(state_->grid->activeVoxelCount());
}

void OpenVdbPeer::Clear() { state_->grid.reset(); }

}  // namespace SolidSubdiv::Perf
