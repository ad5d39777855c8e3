// SPDX-License-Identifier: Apache-2.0
// The framework's voxels of shapes, for the validators of voxels.
#include <algorithm>
#include <cmath>
#include <random>

#include <solidsubdiv/apps/voxel/voxelize.h>

#include "voxel_attributes.h"
#include "voxel_level_set.h"

namespace SolidSubdiv::Validation {

ShapeVoxels VoxelizeShape(const VoxelShape& shape, double voxel_size, double half_width) {
    const auto grids = Voxel::Voxelize(shape.refiner, shape.level, shape.positions,
                                       {.voxel_size = voxel_size, .kind = Voxel::Kind::Both, .half_width = half_width});
    VoxelBlock block{voxel_size, half_width};
    const int margin = static_cast<int>(half_width) + 2;
    for (std::size_t c = 0; c < 3; ++c) {
        double low = HUGE_VAL, high = -HUGE_VAL;
        for (std::size_t i = c; i < shape.positions.size(); i += 3) {
            low = std::min(low, shape.positions[i]);
            high = std::max(high, shape.positions[i]);
        }
        block.low[c] = static_cast<int>(std::floor(low / voxel_size)) - margin;
        block.high[c] = static_cast<int>(std::ceil(high / voxel_size)) + margin;
    }
    ShapeVoxels voxels{block, block};
    voxels.distances.values = grids.Values("surface", block.low, block.high);
    voxels.fog.values = grids.Values("density", block.low, block.high);
    return voxels;
}

VoxelSamples SampleVoxels(const VoxelShape& shape, double voxel_size, int n, unsigned seed) {
    const auto numbers = MakeValues(shape, 1), vectors = MakeValues(shape, 3);
    const auto grids = Voxel::Voxelize(shape.refiner, shape.level, shape.positions,
                                       {.voxel_size = voxel_size,
                                        .attributes = {{.name = "number", .values = numbers}, {"vector", 3, vectors}},
                                        .cell_id = true});
    std::array<int, 3> low{}, high{};
    for (const auto& info : grids.Describe()) {
        if (info.name == "cell_id") low = info.low, high = info.high;
    }
    const auto ids = grids.Values("cell_id", low, high), number = grids.Values("number", low, high);
    const auto vector = grids.Vectors("vector", low, high);
    std::vector<std::size_t> inside;
    for (std::size_t i = 0; i < ids.size(); ++i) {
        if (ids[i] >= 0) inside.push_back(i);
    }
    std::mt19937 engine(seed);
    VoxelSamples samples{.voxel_size = voxel_size, .voxels = {}, .cells = {}, .numbers = {}, .vectors = {}};
    const auto ny = static_cast<std::size_t>(high[1] - low[1] + 1), nz = static_cast<std::size_t>(high[2] - low[2] + 1);
    for (int k = 0; k < n && !inside.empty(); ++k) {
        const std::size_t i = inside[engine() % inside.size()];
        samples.voxels.push_back({low[0] + static_cast<int>(i / (ny * nz)), low[1] + static_cast<int>(i / nz % ny),
                                  low[2] + static_cast<int>(i % nz)});
        samples.cells.push_back(static_cast<Index>(ids[i]));
        samples.numbers.push_back(number[i]);
        samples.vectors.insert(samples.vectors.end(), &vector[3 * i], &vector[3 * i] + 3);
    }
    return samples;
}

}  // namespace SolidSubdiv::Validation
