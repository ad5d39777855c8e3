// SPDX-License-Identifier: Apache-2.0
// Pictures of grids: a panel of the surface and one a slice, squares where values are, bad arrays refused.
#include <gtest/gtest.h>
#include <solidsubdiv/kit/picture/grid_picture.h>
#include <solidsubdiv/sdc/errors.h>

#include <cmath>
#include <limits>
#include <vector>

namespace SolidSubdiv::Picture {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// Panels small enough for a test; seen straight from +z.
GridPictureOptions Small() {
    return {.view = {.azimuth = 0, .elevation = 0},
            .render = {.width = 80, .height = 60, .light_rays = 0, .ground_shadow = false},
            .panels = {.gap = 2},
            .caption = ""};
}

VoxelSlice Slice(const std::vector<double>& values, int n_u, int n_v) {
    return {.step_u = {1, 0, 0}, .step_v = {0, 1, 0}, .n_u = n_u, .n_v = n_v, .values = values};
}

/// Pixels of the panel whose upper row is `top` that are not background.
int Covered(const Image& image, int top = 2) {
    int n = 0;
    for (int y = top; y < top + 60; ++y) {
        for (int x = 2; x < 82; ++x) n += image.At(x, y) != Color{1, 1, 1};
    }
    return n;
}

TEST(GridPicture, HasAPanelOfTheSurfaceAndOneASlice) {
    const std::vector<double> points{0, 0, 0, 1, 0, 0, 0, 1, 0}, values{1, 2, 3, 4};
    const std::vector<Index> triangle{0, 1, 2};
    const std::vector<VoxelSlice> slices(2, Slice(values, 2, 2));
    const Surface surface{.positions = points, .triangles = triangle};
    EXPECT_EQ(GridPicture(surface, slices, Small()).width(), 3 * 82 + 2);
    EXPECT_EQ(GridPicture({}, slices, Small()).width(), 2 * 82 + 2);
    EXPECT_EQ(GridPicture(surface, {}, Small()).width(), 82 + 2);
}

TEST(GridPicture, LeavesOutVoxelsWithoutAValue) {
    const std::vector<double> all(16, 1.0);
    std::vector<double> half = all;  // a chequerboard
    for (int i : {1, 3, 4, 6, 9, 11, 12, 14}) half[static_cast<std::size_t>(i)] = kNan;
    const VoxelSlice whole[] = {Slice(all, 4, 4)}, part[] = {Slice(half, 4, 4)};
    const int n_all = Covered(GridPicture({}, whole, Small())), n_half = Covered(GridPicture({}, part, Small()));
    EXPECT_GT(n_all, 1000);
    // Half the squares, and pixels at their sides.
    EXPECT_GT(n_half, 0.4 * n_all);
    EXPECT_LT(n_half, 0.75 * n_all);
}

TEST(GridPicture, ThinsOutLongSides) {
    // 3000 voxels along u become 1000 squares of three voxels: they cover the same.
    const std::vector<double> values(3000 * 1500, 1.0);
    const VoxelSlice slices[] = {Slice(values, 3000, 1500)};
    const std::vector<double> few(2, 1.0);
    const VoxelSlice same[] = {Slice(few, 2, 1)};
    EXPECT_NEAR(Covered(GridPicture({}, slices, Small())), Covered(GridPicture({}, same, Small())), 80);  // a row
}

TEST(GridPicture, ShowsTheSurfaceBehindASliceOnly) {
    const std::vector<double> one(1, 1.0);
    const std::vector<double> behind{-5, -5, -1, 5, -5, -1, 0, 5, -1}, before{-5, -5, 1, 5, -5, 1, 0, 5, 1},
        within{-5, -5, 0, 5, -5, 0, 0, 5, 0};
    const std::vector<Index> triangle{0, 1, 2};
    const VoxelSlice slices[] = {Slice(one, 1, 1)};
    GridPictureOptions options = Small();
    options.panels.columns = 1;  // the slice's panel lies below
    const auto panel = [&](const std::vector<double>& points) {
        return Covered(GridPicture({.positions = points, .triangles = triangle}, slices, options), 2 + 60 + 2);
    };
    // A triangle of area 50 around a square of area 1, and the square alone.
    EXPECT_GT(panel(behind), 20 * panel(before));
    EXPECT_GT(panel(before), 0);
    EXPECT_GT(panel(behind), 20 * panel(within));
}

TEST(GridPicture, RefusesArraysThatDoNotFit) {
    const std::vector<double> values(5, 1.0);
    const VoxelSlice wrong[] = {Slice(values, 2, 3)}, none[] = {Slice({}, 0, 0)};
    EXPECT_THROW(GridPicture({}, wrong, Small()), InvalidInput);
    EXPECT_THROW(GridPicture({}, none, Small()), InvalidInput);
    EXPECT_THROW(GridPicture({}, {}, Small()), InvalidInput);
}

}  // namespace
}  // namespace SolidSubdiv::Picture
