// SPDX-License-Identifier: Apache-2.0
// Laws of fog: the part of each voxel that cells fill.
#include <gtest/gtest.h>

#include "apps/voxel/voxel_testing.h"
#include "sanitized.h"

namespace SolidSubdiv::Voxel {
namespace {

using namespace TestShapes;

/// A block of one hexahedron between two corners.
Solid Brick(const Vec& low, const Vec& high) {
    PolyhedralShape brick = HexBlock(1);
    for (std::size_t i = 0; i < brick.positions.size(); ++i) {
        brick.positions[i] = brick.positions[i] > 0 ? high[i % 3] : low[i % 3];
    }
    return SolidOf("brick", brick);
}

/// How much of [v - 1/2, v + 1/2] lies between two places.
double Covered(int v, double low, double high) {
    return std::max(0.0, std::min(v + 0.5, high) - std::max(v - 0.5, low));
}

TEST(Fog, IsExactForBricksOnQuartersOfVoxels) {
    // On faces of voxels, on quarters of them, thinner than a voxel, across tiles.
    const std::vector<std::array<Vec, 2>> bricks = {{{{-0.5, -2.5, 3.5}, {7.5, 20.5, 5.5}}},
                                                    {{{-3.25, 0.75, 5}, {12.75, 1.25, 25.5}}},
                                                    {{{0, 0, 0}, {8, 8, 8}}},
                                                    {{{7.25, 7.5, -0.5}, {7.75, 8.5, -0.25}}}};
    for (const auto& brick : bricks) {
        const Solid solid = Brick(brick[0], brick[1]);
        const VoxelBox box = BoxAround(solid, 1, 3);
        const auto values = solid.Voxelize({.voxel_size = 1, .kind = Kind::Fog}).Values("density", box.low, box.high);
        std::size_t i = 0;
        box.ForEach([&](const Voxel3& v) {
            double covered = 1;
            for (std::size_t c = 0; c < 3; ++c) covered *= Covered(v[c], brick[0][c], brick[1][c]);
            EXPECT_EQ(values[i++], covered) << NameOf(v);
        });
    }
}

TEST(Fog, IsThePartOfSamplesThatSomeCellHolds) {
    SOLIDSUBDIV_LONG_TEST();
    constexpr double kVoxel = 0.3;
    for (const Solid& solid : Solids()) {
        const BruteForce brute(solid);
        const VoxelBox box = BoxAround(solid, kVoxel, 2);
        const auto values =
            solid.Voxelize({.voxel_size = kVoxel, .kind = Kind::Fog}).Values("density", box.low, box.high);
        int n_partial = 0;
        box.ForCompared([&](const Voxel3& v, std::size_t i) {
            const Vec center = Center(v, kVoxel);
            int least = 0, most = 0;               // a sample on a face may be either
            if (brute.Outside(center) > kVoxel) {  // it is far from all cells
                EXPECT_EQ(values[i], 0) << solid.name << ", " << NameOf(v);
                return;
            }
            for (int k = 0; k < 64; ++k) {
                const double outside =
                    brute.Outside({center[0] + kVoxel * (k / 16 - 1.5) / 4, center[1] + kVoxel * (k / 4 % 4 - 1.5) / 4,
                                   center[2] + kVoxel * (k % 4 - 1.5) / 4});
                least += outside <= 1e-12;
                most += outside <= 1e-8;
            }
            EXPECT_GE(values[i], least / 64.0) << solid.name << ", " << NameOf(v);
            EXPECT_LE(values[i], most / 64.0) << solid.name << ", " << NameOf(v);
            n_partial += values[i] > 0 && values[i] < 1;
        });
        EXPECT_GT(n_partial, 50 / kOneIn) << solid.name;
    }
}

TEST(Fog, AddsUpToTheVolumeOfTheCells) {
    for (const Solid& solid : Solids()) {
        if (solid.name.starts_with("folded")) continue;  // their cells lie over each other
        constexpr double kVoxel = 0.1;
        double volume = 0;
        const auto tets = solid.Tets();
        for (std::size_t t = 0; t < tets.size(); t += 4) {
            const Vec a = solid.Point(tets[t]);
            const Vec b = Minus(solid.Point(tets[t + 1]), a), c = Minus(solid.Point(tets[t + 2]), a),
                      d = Minus(solid.Point(tets[t + 3]), a);
            volume += std::abs(Dot(b, Cross(c, d))) / 6;  // some are inverted
        }
        const VoxelBox box = BoxAround(solid, kVoxel, 2);
        const auto values =
            solid.Voxelize({.voxel_size = kVoxel, .kind = Kind::Fog}).Values("density", box.low, box.high);
        double sum = 0;
        for (double x : values) sum += x * kVoxel * kVoxel * kVoxel;
        // Errors of 64 samples a voxel have either sign and cancel, but on faces along the axes (0.33 %).
        EXPECT_NEAR(sum, volume, 5e-3 * volume) << solid.name;
    }
}

TEST(Fog, BackgroundIsNothingAndOnlyFilledVoxelsAreActive) {
    const Solid solid = Brick({-0.5, -0.5, -0.5}, {19.5, 3.5, 9.5});
    const Grids grids = solid.Voxelize({.voxel_size = 1, .kind = Kind::Fog});
    const auto info = grids.Describe();
    ASSERT_EQ(info.size(), 1u);
    EXPECT_EQ(info[0].name, "density");
    EXPECT_EQ(info[0].grid_class, "fog volume");
    EXPECT_EQ(info[0].background, 0);
    EXPECT_EQ(info[0].active_voxels, 20 * 4 * 10);
    EXPECT_EQ(info[0].low, (Voxel3{0, 0, 0}));
    EXPECT_EQ(info[0].high, (Voxel3{19, 3, 9}));
    EXPECT_EQ(info[0].least, 1);
    EXPECT_EQ(info[0].greatest, 1);
}

}  // namespace
}  // namespace SolidSubdiv::Voxel
