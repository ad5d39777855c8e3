// SPDX-License-Identifier: Apache-2.0
// What can't be voxelized is refused, and the message says why.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <solidsubdiv/sdc/errors.h>

#include <limits>

#include "apps/voxel/voxel_testing.h"

namespace SolidSubdiv::Voxel {
namespace {

using namespace TestShapes;
using testing::AllOf;
using testing::HasSubstr;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

std::string ErrorOf(const Solid& solid, const VoxelizeOptions& options) {
    try {
        solid.Voxelize(options);
    } catch (const InvalidInput& error) {
        return error.what();
    }
    return "no error";
}

Solid Block() { return SolidOf("block", HexBlock(2)); }

TEST(BadInput, VoxelSizesMustBeAboveZero) {
    for (double size : {0.0, -0.1, kNan, HUGE_VAL, -HUGE_VAL}) {
        EXPECT_THAT(ErrorOf(Block(), {.voxel_size = size}), HasSubstr("voxel_size is")) << size;
    }
    EXPECT_THAT(ErrorOf(Block(), {.voxel_size = 1e-7 * -1}), HasSubstr("voxel_size is -1e-07"));
}

TEST(BadInput, TooManyVoxelsAreRefusedWithTheirNumber) {
    EXPECT_THAT(ErrorOf(Block(), {.voxel_size = 2e-9}),
                AllOf(HasSubstr("1e+09 x 1e+09 x 1e+09"), HasSubstr("= 1e+27")));
    EXPECT_THAT(ErrorOf(Block(), {.voxel_size = 2e-4}), HasSubstr("1e+04 x 1e+04 x 1e+04 = 1e+12"));
    EXPECT_THAT(ErrorOf(Block(), {.voxel_size = 1e-300}), HasSubstr("too many"));
    EXPECT_THAT(ErrorOf(Block(), {.voxel_size = 0.01, .max_bytes = 10000}), HasSubstr("too many"));
    Solid far = Block();
    for (double& x : far.positions) x += 1e10;
    EXPECT_THAT(ErrorOf(far, {.voxel_size = 1}), HasSubstr("too many"));
}

TEST(BadInput, BandsMustBeOneToAHundredVoxels) {
    for (double half_width : {0.0, 0.99, -3.0, 101.0, kNan, HUGE_VAL}) {
        EXPECT_THAT(ErrorOf(Block(), {.voxel_size = 0.1, .half_width = half_width}), HasSubstr("half_width is"));
    }
}

TEST(BadInput, AttributesMustFitTheVertices) {
    const std::vector<double> values(27, 1.0);
    EXPECT_EQ(ErrorOf(Block(), {.voxel_size = 0.1, .attributes = {{"a", 1, values}}}), "no error");
    for (int width : {0, 2, 3, -1}) {
        EXPECT_THAT(ErrorOf(Block(), {.voxel_size = 0.1, .attributes = {{"heat", width, values}}}),
                    AllOf(HasSubstr("'heat'"), HasSubstr("27 numbers")));
    }
    EXPECT_THAT(ErrorOf(Block(), {.voxel_size = 0.1, .attributes = {{"heat", 1, {values.data(), 26}}}}),
                HasSubstr("26 numbers"));
}

TEST(BadInput, GridsMustHaveNamesOfTheirOwn) {
    const std::vector<double> values(27, 1.0);
    for (const char* name : {"surface", "density", "jacobian", "cell_id", "level", ""}) {
        EXPECT_THAT(ErrorOf(Block(), {.voxel_size = 0.1,
                                      .kind = Kind::Both,
                                      .attributes = {{name, 1, values}},
                                      .jacobian = true,
                                      .cell_id = true,
                                      .level_id = true}),
                    HasSubstr("name"));
    }
    // Names of grids that are not asked for are free.
    for (const char* name : {"density", "jacobian", "cell_id", "level"}) {
        EXPECT_EQ(ErrorOf(Block(), {.voxel_size = 0.1, .attributes = {{name, 1, values}}}), "no error");
    }
    EXPECT_THAT(ErrorOf(Block(), {.voxel_size = 0.1, .attributes = {{"a", 1, values}, {"a", 1, values}}}),
                HasSubstr("'a'"));
}

TEST(BadInput, LevelsMustBeThereAndHaveCells) {
    Solid solid = Block();
    for (int level : {-1, 1}) {
        solid.level = level;
        EXPECT_THAT(ErrorOf(solid, {.voxel_size = 0.1}), HasSubstr("no level " + std::to_string(level)));
    }
    EXPECT_THAT(ErrorOf(SolidOf("surface", OctahedronSurface()), {.voxel_size = 0.1}), HasSubstr("no cells"));
}

TEST(BadInput, PositionsMustBeNumbersOfAllVertices) {
    for (double bad : {kNan, HUGE_VAL}) {
        Solid solid = Block();
        solid.positions[3 * 17 + 1] = bad;
        EXPECT_THAT(ErrorOf(solid, {.voxel_size = 0.1}), HasSubstr("vertex 17"));
    }
    Solid solid = Block();
    solid.positions.pop_back();
    EXPECT_THAT(ErrorOf(solid, {.voxel_size = 0.1}), HasSubstr("80 coordinates"));
}

TEST(BadInput, ThereMustBeSomeGrid) {
    EXPECT_THAT(ErrorOf(Block(), {.voxel_size = 0.1, .kind = Kind::None}), HasSubstr("no attribute"));
    EXPECT_EQ(ErrorOf(Block(), {.voxel_size = 0.1, .kind = Kind::None, .level_id = true}), "no error");
}

TEST(BadInput, KindsHaveFourNames) {
    EXPECT_EQ(KindOf("level-set"), Kind::LevelSet);
    EXPECT_EQ(KindOf("fog"), Kind::Fog);
    EXPECT_EQ(KindOf("both"), Kind::Both);
    EXPECT_EQ(KindOf("none"), Kind::None);
    EXPECT_THROW(KindOf("mist"), InvalidInput);
}

TEST(BadInput, WorkCanBeCancelled) {
    const Progress cancel([](std::string_view, double) { return false; });
    EXPECT_THROW(Block().Voxelize({.voxel_size = 0.1, .progress = cancel}), Cancelled);
    EXPECT_THROW(Block().Voxelize({.voxel_size = 0.1, .cell_id = true, .progress = cancel}), Cancelled);
}

}  // namespace
}  // namespace SolidSubdiv::Voxel
