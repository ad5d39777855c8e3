// SPDX-License-Identifier: Apache-2.0
// Lines and points: as wide as asked, hidden where something is in front.
#include "kit/picture/picture_testing.h"

#include <gtest/gtest.h>

#include <numbers>

namespace SolidSubdiv::Picture {
namespace {

constexpr int kSize = 200;
const RenderOptions kPlain{.width = kSize, .height = kSize, .ground_shadow = false};
const Camera kCamera = CameraOnZ(10, 0.2, 0.2);  // 50 pixels a unit at z = 0
const std::vector<Index> kEdge = {0, 1};

Image PictureOfLine(const std::vector<double>& ends, double width) {
    Scene scene;
    scene.Add(Lines{.positions = ends, .edges = kEdge, .color = kBlack, .width = width});
    return Render(scene, kCamera, kPlain);
}

TEST(LinesTest, InkIsLengthTimesWidthWithRoundEnds) {
    for (double width : {1.5, 4.0, 9.0}) {
        const double ink = Darkness(PictureOfLine({-1, -0.7, 0, 1, 0.8, 0}, width));
        const double length = 50 * std::hypot(2, 1.5);
        // 16 samples a pixel along 125 pixels of edge average out; a thin line's tube bulges to the viewer by far less
        // than a hundredth of its distance.
        EXPECT_NEAR(ink, length * width + std::numbers::pi * width * width / 4, 0.03 * length * width) << width;
    }
}

TEST(LinesTest, WidthIsTheSameNearAndFar) {
    const double near = Darkness(PictureOfLine({-0.5, 0, 5, 0.5, 0, 5}, 6));  // 100 pixels long
    const double far = Darkness(PictureOfLine({-2, 0, -10, 2, 0, -10}, 6));   // 100 pixels long
    EXPECT_NEAR(near, 100 * 6 + std::numbers::pi * 9, 15);
    EXPECT_NEAR(far, near, 15);
}

TEST(LinesTest, HiddenLinesLeaveNoTrace) {
    const Triangles square = MakeSquare(1, 1.5);
    const auto picture = [&](double z) {
        const std::vector<double> ends = {-1, -0.5, z, 1, 0.5, z};
        Scene scene;
        scene.Add(Surface{.positions = square.positions, .triangles = square.triangles});
        scene.Add(Lines{.positions = ends, .edges = kEdge, .width = 3});
        return Render(scene, kCamera, kPlain);
    };
    Scene bare;
    bare.Add(Surface{.positions = square.positions, .triangles = square.triangles});
    const Image without = Render(bare, kCamera, kPlain);
    EXPECT_EQ(picture(0), without);
    EXPECT_GT(DifferentPixels(picture(1), without), 250);  // on the surface: 112 pixels long, 3 wide
    EXPECT_GT(DifferentPixels(picture(2), without), 250);  // before it
}

TEST(LinesTest, WireframeOfASurfaceIsVisibleInValleysAndOnRidges) {
    // A white sheet folded along a vertical edge, towards the viewer or away, each side at 45 degrees.
    for (double fold : {-1.0, 0.0, 1.0}) {
        const std::vector<double> sheet = {0,    -2, 0,          0,   2, 0,          -1.5, 2,  fold * 1.5,
                                           -1.5, -2, fold * 1.5, 1.5, 2, fold * 1.5, 1.5,  -2, fold * 1.5};
        const std::vector<Index> triangles = {0, 1, 2, 0, 2, 3, 0, 4, 1, 0, 5, 4};
        Scene bare, drawn;
        for (Scene* scene : {&bare, &drawn}) {
            scene->Add(Surface{.positions = sheet,
                               .triangles = triangles,
                               .material = {.color = {1, 1, 1}, .smooth = false, .gloss = 0}});
        }
        const std::vector<double> ends = {0, -1, 0, 0, 1, 0};
        drawn.Add(Lines{.positions = ends, .edges = kEdge, .color = kBlack, .width = 3});
        RenderOptions options = kPlain;
        options.light_rays = 0;
        const Image without = Render(bare, kCamera, options), with = Render(drawn, kCamera, options);
        int black = 0;
        for (int x = 90; x < 110; ++x) black += with.At(x, 100).g < 0.6f * without.At(x, 100).g ? 1 : 0;
        EXPECT_GE(black, 2) << fold;
        EXPECT_LE(black, 4) << fold;
    }
}

TEST(LinesTest, UnshadedLinesCastNoShadowShadedOnesDo) {
    const Triangles wall = MakeSquare(0, 3);
    const std::vector<double> ends = {-1.2, 1.5, 1, 0.6, 1.5, 1};
    const auto picture = [&](bool shaded) {
        Scene scene;
        scene.Add(Surface{.positions = wall.positions, .triangles = wall.triangles});
        scene.Add(Lines{.positions = ends, .edges = kEdge, .width = 12, .shaded = shaded});
        return Render(scene, kCamera, kPlain);
    };
    Scene bare;
    bare.Add(Surface{.positions = wall.positions, .triangles = wall.triangles});
    const Image without = Render(bare, kCamera, kPlain), pen = picture(false), tube = picture(true);
    int pen_changes = 0, tube_changes = 0;  // below the line, where its shadow would fall
    for (int y = 40; y < 140; ++y) {
        for (int x = 20; x < 180; ++x) {
            pen_changes += pen.At(x, y) == without.At(x, y) ? 0 : 1;
            tube_changes += tube.At(x, y).g < without.At(x, y).g - 0.05f ? 1 : 0;
        }
    }
    EXPECT_EQ(pen_changes, 0);
    EXPECT_GT(tube_changes, 100);
}

TEST(PointsTest, PointsAreDiscsOfTheirDiameter) {
    const std::vector<double> points = {-1, 0, 0, 1, 0, 3};
    Scene scene;
    scene.Add(Points{.positions = points, .color = kBlack, .diameter = 20, .shaded = false});
    EXPECT_NEAR(Darkness(Render(scene, kCamera, kPlain)), 2 * std::numbers::pi * 100, 0.02 * 628);
}

}  // namespace
}  // namespace SolidSubdiv::Picture
