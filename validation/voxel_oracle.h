// SPDX-License-Identifier: Apache-2.0
// Level sets of closed surfaces by OpenVDB's meshToVolume. An oracle: it shares no code with the library.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace SolidSubdiv::Validation {

/// Numbers of a box of voxels, low to high inclusive, z fastest. Voxel (i, j, k) has its centre at size * (i, j, k).
struct VoxelBlock {
    double voxel_size = 1;
    double half_width = 3;  ///< of the band, in voxels
    std::array<int, 3> low{}, high{};
    std::vector<double> values{};

    std::array<int, 3> PlaceOf(std::size_t i) const {
        const auto n = [&](std::size_t c) { return static_cast<std::size_t>(high[c] - low[c] + 1); };
        return {low[0] + static_cast<int>(i / (n(1) * n(2))), low[1] + static_cast<int>(i / n(2) % n(1)),
                low[2] + static_cast<int>(i % n(2))};
    }
};

struct TriangleSurface {
    std::vector<double> points;           ///< (n, 3)
    std::vector<std::int32_t> triangles;  ///< (n, 3), counterclockwise from outside
};

/// Fills in the values: distances, negative inside. @pre the surface is closed. @throws Unavailable
void MeshToVolume(const TriangleSurface& surface, VoxelBlock& block);

}  // namespace SolidSubdiv::Validation
