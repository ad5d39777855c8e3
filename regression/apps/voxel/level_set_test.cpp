// SPDX-License-Identifier: Apache-2.0
// Laws of level sets: distances to the boundary, signs of the cells.
#include <gtest/gtest.h>
#include <solidsubdiv/sdc/parallel.h>

#include "apps/voxel/voxel_testing.h"

namespace SolidSubdiv::Voxel {
namespace {

using namespace TestShapes;

struct Difference {
    double distance = 0;  ///< the largest, in voxels
    int n_in_band = 0, n_wrong_signs = 0, n_inside = 0, n_wrong_background = 0;
    std::string where;
};

/// Values of a box around a solid against all triangles and all tets.
Difference Compare(const Solid& solid, const std::vector<double>& values, const VoxelBox& box, double voxel_size,
                   double half_width) {
    const BruteForce brute(solid);
    // Voxels on a face are in its cell, whatever rounding does: so far outside they may be either (in voxels).
    constexpr double kEither = 1e-8;
    Difference result;
    box.ForCompared([&](const Voxel3& v, std::size_t i) {
        const double value = values[i] / voxel_size, outside = brute.Outside(Center(v, voxel_size)) / voxel_size;
        const double distance = brute.Distance(Center(v, voxel_size)) / voxel_size;
        result.n_inside += outside <= 0;
        if (outside <= 1e-12 || outside > kEither) result.n_wrong_signs += std::signbit(value) != (outside <= 1e-12);
        if (distance < half_width - 1e-4) {
            ++result.n_in_band;
            if (std::abs(std::abs(value) - distance) > result.distance) {
                result.distance = std::abs(std::abs(value) - distance);
                result.where = NameOf(v);
            }
        } else if (distance > half_width + 1e-4) {
            // The background is a float: 1e-6 is ten of its units of rounding.
            result.n_wrong_background += std::abs(std::abs(value) - half_width) > 1e-6 * half_width;
        }
    });
    return result;
}
Difference Compare(const Solid& solid, double voxel_size, double half_width) {
    const VoxelBox box = BoxAround(solid, voxel_size, static_cast<int>(half_width) + 2);
    const auto values =
        solid.Voxelize({.voxel_size = voxel_size, .half_width = half_width}).Values("surface", box.low, box.high);
    return Compare(solid, values, box, voxel_size, half_width);
}

TEST(LevelSet, DistancesAreThoseToTheNearestBoundaryTriangleAndSignsThoseOfTheCells) {
    for (const Solid& solid : Solids()) {
        SCOPED_TRACE(solid.name);
        const Difference difference = Compare(solid, 0.19, 3);
        // Floats of up to a tile (8 voxels) and a triangle's length, some ten roundings of 6e-8 each.
        EXPECT_LT(difference.distance, 1e-4) << difference.where;
        EXPECT_EQ(difference.n_wrong_signs, 0);
        EXPECT_EQ(difference.n_wrong_background, 0);
        EXPECT_GT(difference.n_in_band, 1000 / kOneIn);
        EXPECT_GT(difference.n_inside, 100 / kOneIn);
    }
}

TEST(LevelSet, TheBandIsAsWideAsAskedFor) {
    const Solid solid = SolidOf("hexahedra", Jittered(HexBlock(2), 0.1, 1));
    for (double half_width : {1.0, 2.5, 9.0}) {
        const Difference difference = Compare(solid, 0.25, half_width);
        EXPECT_LT(difference.distance, 1e-4) << half_width;
        EXPECT_EQ(difference.n_wrong_signs, 0) << half_width;
        EXPECT_EQ(difference.n_wrong_background, 0) << half_width;
    }
}

TEST(LevelSet, PlantedFaultsAreCaught) {
    const Solid solid = SolidOf("hexahedra", Jittered(HexBlock(2), 0.1, 1));
    const VoxelBox box = BoxAround(solid, 0.25, 5);
    const auto good = solid.Voxelize({.voxel_size = 0.25}).Values("surface", box.low, box.high);
    std::size_t near = 0;
    while (std::abs(good[near]) >= 0.7) near += kOneIn;
    auto values = good;
    values[near] += 0.25 * 2e-4;
    EXPECT_GT(Compare(solid, values, box, 0.25, 3).distance, 1e-4);
    values = good;
    values[near] *= -1;
    EXPECT_EQ(Compare(solid, values, box, 0.25, 3).n_wrong_signs, 1);
    values = good;
    values[0] *= 1.001;
    EXPECT_EQ(Compare(solid, values, box, 0.25, 3).n_wrong_background, 1);
}

TEST(LevelSet, LongTrianglesLoseNothing) {
    // A plank of 3000 x 40 x 3 voxels of one cell, askew: its triangles cross hundreds of tiles.
    const int length = FewerIfSanitized(300);
    PolyhedralShape plank = HexBlock(1);
    for (std::size_t i = 0; i < plank.positions.size(); i += 3) {
        const double x = length * plank.positions[i], y = 4 * plank.positions[i + 1], z = 0.3 * plank.positions[i + 2];
        plank.positions[i] = 0.8 * x - 0.48 * y + 0.36 * z;
        plank.positions[i + 1] = 0.6 * x + 0.64 * y - 0.48 * z;
        plank.positions[i + 2] = 0.6 * y + 0.8 * z;
    }
    const Solid solid = SolidOf("plank", plank);
    const Grids grids = solid.Voxelize({.voxel_size = 0.1});
    for (const double along : {1.0, length / 2.0, length - 2.0}) {  // near both ends, and in the middle
        const int x = static_cast<int>(10 * (0.8 * along - 1)), y = static_cast<int>(10 * (0.6 * along + 1));
        const VoxelBox box{{x - 8, y - 8, -4}, {x + 8, y + 8, 20}};
        const auto difference = Compare(solid, grids.Values("surface", box.low, box.high), box, 0.1, 3);
        EXPECT_LT(difference.distance, 1e-4) << along << ": " << difference.where;
        EXPECT_EQ(difference.n_wrong_signs, 0);
        EXPECT_GT(difference.n_in_band, 100 / kOneIn);
    }
}

TEST(LevelSet, SliversHoldNoMoreThanTheyShould) {
    // A tet, and one that is all but flat in the plane of its bottom, in a plane of voxels.
    const Solid solid = SolidOf("sliver", Shape{5,
                                                {0, 1, 2, 3, 0, 2, 1, 4},
                                                {},
                                                {},
                                                {},
                                                {0, 0, 0, 10, 0, 0, 0, 10, 0, 0, 0, 10, 10. / 3, 10. / 3, -1e-12}});
    const Difference difference = Compare(solid, 1, 3);
    EXPECT_EQ(difference.n_wrong_signs, 0);
    EXPECT_EQ(
        Compare(
            SolidOf("flat",
                    Shape{5, solid.Tets(), {}, {}, {}, {0, 0, 0, 10, 0, 0, 0, 10, 0, 0, 0, 10, 10. / 3, 10. / 3, 0}}),
            1, 3)
            .n_wrong_signs,
        0);
}

TEST(LevelSet, FoldsThatHaveNoBoundaryKeepTheirSign) {
    // Two tets of 40 voxels on the same side of the face between them: the solid ends there as well.
    const Solid solid = SolidOf(
        "fold",
        Shape{5, {0, 1, 2, 3, 1, 0, 2, 4}, {}, {}, {}, {0, 0, 0, 40, 1, 0.3, 1, 40, 0.4, 12, 13, 40, 14, 12, 30}});
    const Difference difference = Compare(solid, 1, 1);
    EXPECT_EQ(difference.n_wrong_signs, 0);
    EXPECT_LT(difference.distance, 1e-4);
    EXPECT_GT(difference.n_inside, 1000 / kOneIn);
}

TEST(LevelSet, BitsAreTheSameForAnyNumberOfThreads) {
    for (const Solid& solid : Solids()) {
        const VoxelizeOptions options{.voxel_size = 0.11, .kind = Kind::Both, .jacobian = true, .cell_id = true};
        const VoxelBox box = BoxAround(solid, options.voxel_size, 5);
        std::vector<std::vector<double>> values[2];
        for (int n_threads : {1, 2}) {
            const Sdc::ThreadLimit limit(n_threads);
            const Grids grids = solid.Voxelize(options);
            for (const char* name : {"surface", "density", "jacobian", "cell_id"}) {
                values[n_threads - 1].push_back(grids.Values(name, box.low, box.high));
            }
        }
        EXPECT_EQ(values[0], values[1]) << solid.name;
    }
}

TEST(LevelSet, MovingByWholeVoxelsMovesTheValues) {
    constexpr double kVoxel = 0.21;
    const Voxel3 steps{-13, 200, 5};
    for (const Solid& solid : Solids()) {
        Solid moved = solid;
        for (std::size_t i = 0; i < moved.positions.size(); ++i) moved.positions[i] += kVoxel * steps[i % 3];
        const VoxelBox box = BoxAround(solid, kVoxel, 4);
        VoxelBox there = box;
        for (std::size_t c = 0; c < 3; ++c) {
            there.low[c] += steps[c];
            there.high[c] += steps[c];
        }
        const VoxelizeOptions options{.voxel_size = kVoxel, .kind = Kind::Both};
        const Grids here = solid.Voxelize(options), shifted = moved.Voxelize(options);
        for (const char* name : {"surface", "density"}) {
            const auto a = here.Values(name, box.low, box.high), b = shifted.Values(name, there.low, there.high);
            double largest = 0;
            for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
            // Rounding of floats in tiles that begin elsewhere; a sample on a face would show as 1/64.
            EXPECT_LT(largest, 1e-5) << solid.name << ", " << name;
        }
    }
}

}  // namespace
}  // namespace SolidSubdiv::Voxel
