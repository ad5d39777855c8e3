// SPDX-License-Identifier: Apache-2.0
// Pictures of shapes whose pictures are known.
#include "kit/picture/picture_testing.h"

#include <gtest/gtest.h>
#include <solidsubdiv/sdc/errors.h>
#include <solidsubdiv/sdc/parallel.h>

#include <numbers>
#include <string>

namespace SolidSubdiv::Picture {
namespace {

constexpr double kPi = std::numbers::pi;

Material Matt(Color color, bool smooth = false) { return {.color = color, .smooth = smooth, .gloss = 0}; }

RenderOptions Plain(int width, int height) { return {.width = width, .height = height, .ground_shadow = false}; }

TEST(RenderTest, SilhouetteOfASphereHasItsAnalyticArea) {
    const Triangles sphere = MakeSphere(6);
    Scene scene;
    scene.Add(Surface{.positions = sphere.positions, .triangles = sphere.triangles, .material = Matt(kBlack)});
    const Image image = Render(scene, CameraOnZ(4, 0.4, 0.3), Plain(400, 300));
    // Seen from distance d, a sphere of radius r covers the cone of half angle asin(r / d).
    const double radius = std::tan(std::asin(1.0 / 4)) / 0.4 * 200;
    // The sphere's polygon is smaller by 1 - (pi/256)^2/6.. of its radius, 16 samples at the edge err by far less than
    // one pixel each, both ways: together well below 0.2 %.
    EXPECT_NEAR(Darkness(image), kPi * radius * radius, 0.002 * kPi * radius * radius);
}

TEST(RenderTest, WhatIsNearerHidesWhatIsBehind) {
    const Triangles near = MakeSquare(1), far = MakeSquare(0);
    for (bool red_in_front : {true, false}) {
        Scene scene;
        const Color front = red_in_front ? Color{0.8f, 0, 0} : Color{0, 0.8f, 0},
                    back = red_in_front ? Color{0, 0.8f, 0} : Color{0.8f, 0, 0};
        scene.Add(Surface{.positions = far.positions, .triangles = far.triangles, .material = Matt(back)});
        scene.Add(Surface{.positions = near.positions, .triangles = near.triangles, .material = Matt(front)});
        const Color middle = Render(scene, CameraOnZ(5, 0.5, 0.5), Plain(64, 64)).At(32, 32);
        EXPECT_GT(red_in_front ? middle.r : middle.g, 0.5f);
        EXPECT_EQ(red_in_front ? middle.g : middle.r, 0.f);
    }
}

TEST(RenderTest, StrokesKeepTheirColourAndTheBackgroundIsAsAsked) {
    const std::vector<double> origin = {0, 0, 0};
    const Color ink = Color::Hex(0x336699), top = Color::Hex(0xffffff), bottom = Color::Hex(0x204060);
    Scene scene;
    scene.Add(Points{.positions = origin, .color = ink, .diameter = 20, .shaded = false});
    RenderOptions options = Plain(65, 65);
    options.background_top = top;
    options.background_bottom = bottom;
    const Image image = Render(scene, CameraOnZ(5, 0.5, 0.5), options);
    EXPECT_EQ(image.At(32, 32), ink);
    // The outermost pixels lie half a pixel inside the gradient's ends.
    EXPECT_NEAR(image.At(0, 0).r, top.r, 0.02);
    EXPECT_NEAR(image.At(0, 64).r, bottom.r, 0.05);
}

TEST(RenderTest, ReflectionLinesOfAPlaneAreLevelAndWhereTheMirrorLawPutsThem) {
    const Triangles square = MakeSquare(0, 3);
    const auto render = [&](int stripes) {
        Scene scene;
        Material material = Matt({0.5f, 0.5f, 0.5f});
        material.stripes = stripes;
        scene.Add(Surface{.positions = square.positions, .triangles = square.triangles, .material = material});
        RenderOptions options = Plain(100, 401);
        options.light_rays = 0;
        return Render(scene, CameraOnZ(4, 0.125, 0.50125), options);  // a pixel is 0.0025 at distance 1
    };
    const Image image = render(24), without = render(0);
    const auto brightness = [&](int x, int y) {
        return Internal::DecodeSrgb(image.At(x, y).g) / Internal::DecodeSrgb(without.At(x, y).g);
    };
    // Seen at the angle a above the axis a plane mirrors what is at the angle a above it: a dark stripe's middle where
    // 24 a is an odd number of half turns.
    for (int half_turns : {-3, -2, -1, 0, 1, 2, 3}) {
        const int y = 200 - static_cast<int>(std::lround(std::tan(half_turns * kPi / 24) / 0.0025));
        for (int x : {0, 50, 99}) {
            if (half_turns % 2 == 0) {
                EXPECT_NEAR(brightness(x, y), 1, 0.02) << half_turns;
            } else {
                EXPECT_LT(brightness(x, y), 0.2) << half_turns;
            }
        }
    }
}

TEST(RenderTest, ReflectionLinesBreakAtARidge) {
    // Two squares that meet at the given angle on the line x = 0; stripes to both sides of it, along the line.
    const auto changes = [](double degrees) {
        const double rise = std::tan(degrees * kPi / 360);
        const std::vector<double> points = {-1, -1, -rise, -1, 1, -rise, 0, -1, 0, 0, 1, 0, 1, -1, -rise, 1, 1, -rise};
        const std::vector<Index> triangles = {0, 2, 1, 1, 2, 3, 2, 4, 3, 3, 4, 5};
        Scene scene;
        scene.Add(Surface{
            .positions = points, .triangles = triangles, .material = {.smooth = false, .gloss = 0, .stripes = 40}});
        Camera camera = CameraOnZ(4, 0.2, 0.2);
        camera.right = {0.8, 0.6, 0};  // stripes run at an angle to the ridge
        camera.up = {-0.6, 0.8, 0};
        camera.world_up = camera.up;
        RenderOptions options = Plain(200, 200);
        options.light_rays = 0;
        const Image image = Render(scene, camera, options);
        int n = 0;
        for (int i = -80; i <= 80; ++i) {  // up along the ridge, 4 pixels to both sides
            const double x = 100 + 0.6 * i, y = 100 - 0.8 * i;
            const Color left = image.At(static_cast<int>(x - 3.2), static_cast<int>(y - 2.4)),
                        right = image.At(static_cast<int>(x + 3.2), static_cast<int>(y + 2.4));
            n += std::abs(left.g - right.g) > 0.2f ? 1 : 0;
        }
        return n;
    };
    EXPECT_GT(changes(10), 2 * changes(0) + 20);
}

TEST(RenderTest, EmptySceneIsBackground) {
    const Image image = Render(Scene(), CameraOnZ(5, 0.5, 0.5), {.width = 20, .height = 10});
    EXPECT_EQ(image, Image(20, 10, {1, 1, 1}));
    Scene scene;
    EXPECT_THROW(Render(scene, View{}), InvalidInput);  // nothing to fit the camera to
}

Scene SceneOfEverything() {
    const Triangles sphere = MakeSphere(3), square = MakeSquare(-1, 2);
    std::vector<double> heights;
    for (std::size_t i = 0; i < sphere.positions.size(); i += 3) heights.push_back(sphere.positions[i + 1]);
    const std::vector<Index> edges = {0, 1, 1, 2, 2, 3, 3, 0};
    Scene scene;
    scene.Add(Surface{.positions = sphere.positions, .triangles = sphere.triangles, .values = heights});
    scene.Add(Surface{.positions = square.positions, .triangles = square.triangles, .material = Matt(Palette::kSkin)});
    scene.Add(Lines{.positions = sphere.positions, .edges = edges, .width = 3});
    scene.Add(Lines{.positions = square.positions, .edges = edges, .width = 5, .shaded = true});
    scene.Add(Points{.positions = square.positions, .diameter = 9});
    return scene;
}

TEST(RenderTest, BitsDoNotDependOnTheNumberOfThreads) {
    const Scene scene = SceneOfEverything();
    const RenderOptions options{.width = 150, .height = 130};
    const auto with = [&](int n) {
        const Sdc::ThreadLimit limit(n);
        return Render(scene, View{}, options);
    };
    const Image one = with(1);
    for (int n : {2, 3, 8}) EXPECT_EQ(with(n), one) << n << " threads";
    EXPECT_GT(DifferentPixels(one, Image(150, 130)), 4000);
}

TEST(RenderTest, ThreadsStayAvailableAfterwards) {
    const int before = Sdc::ThreadCount();
    Render(SceneOfEverything(), View{}, {.width = 16, .height = 16});
    EXPECT_EQ(Sdc::ThreadCount(), before);
}

TEST(RenderTest, PlaceAndSizeOfTheSceneDoNotMatter) {
    // Embree's floats would lose a sphere of radius 1e-3 at 1e5: they never see it there.
    const auto picture = [](double scale, double shift) {
        Triangles sphere = MakeSphere(4);
        for (double& x : sphere.positions) x = scale * x + shift;
        Scene scene;
        scene.Add(Surface{.positions = sphere.positions, .triangles = sphere.triangles});
        return Render(scene, View{}, {.width = 120, .height = 120});
    };
    const Image reference = picture(1, 0);
    for (auto [scale, shift] : {std::pair{1e-3, 1e5}, {1e20, 0.0}, {1e-20, 0.0}}) {
        const Image other = picture(scale, shift);
        double largest = 0;
        for (std::size_t i = 0; i < reference.bytes().size(); ++i) {
            largest = std::max(largest, std::abs(static_cast<double>(reference.bytes()[i]) - other.bytes()[i]));
        }
        // Doubles at 1e5 know the sphere to 1e-8 of its radius; a ray at a triangle's edge may meet the other one.
        EXPECT_LE(largest, 24) << scale << " " << shift;
        EXPECT_LT(DifferentPixels(reference, other), 150) << scale << " " << shift;
    }
}

TEST(RenderTest, GroundTakesAShadowUnderTheShapeOnly) {
    const Triangles sphere = MakeSphere(3);
    Scene scene;
    scene.Add(Surface{.positions = sphere.positions, .triangles = sphere.triangles, .material = Matt({1, 1, 1}, true)});
    const View view{.elevation = 20, .margin = 0.2};
    RenderOptions options{.width = 200, .height = 200};
    const Image with = Render(scene, view, options);
    options.ground_shadow = false;
    const Image without = Render(scene, view, options);
    const int x = 100, y = 164;  // just under the sphere, which ends at 0.8 of the height
    EXPECT_EQ(without.At(x, y), (Color{1, 1, 1}));
    EXPECT_LT(with.At(x, y).r, 0.9f);
    for (auto [cx, cy] : {std::pair{0, 0}, {199, 0}, {0, 199}, {199, 199}})
        EXPECT_EQ(with.At(cx, cy), (Color{1, 1, 1}));
    options = {.width = 200, .height = 200, .light_rays = 0};
    EXPECT_EQ(Render(scene, view, options).At(x, y), (Color{1, 1, 1}));
}

TEST(RenderTest, ShapesShadeEachOther) {
    // A square wall, and a second one between it and the key light (upper left, in front).
    const Triangles wall = MakeSquare(0, 4);
    const std::vector<double> blocker = {-2, 0, 1, 0, 0, 1, 0, 2, 1, -2, 2, 1};
    Scene lit, shaded;
    lit.Add(Surface{.positions = wall.positions, .triangles = wall.triangles, .material = Matt({0.7f, 0.7f, 0.7f})});
    shaded.Add(Surface{.positions = wall.positions, .triangles = wall.triangles, .material = Matt({0.7f, 0.7f, 0.7f})});
    shaded.Add(Surface{.positions = blocker, .triangles = wall.triangles, .material = Matt({0.7f, 0.7f, 0.7f})});
    const Camera camera = CameraOnZ(10, 0.4, 0.4);
    const Image a = Render(lit, camera, Plain(80, 80)), b = Render(shaded, camera, Plain(80, 80));
    const int x = 43, y = 43;  // x = y = 0.35 right of and below the middle: one unit of key light behind the blocker
    EXPECT_LT(b.At(x, y).g, 0.75f * a.At(x, y).g);
    EXPECT_NEAR(b.At(70, 70).g, a.At(70, 70).g, 0.02f);
}

TEST(RenderTest, SmoothShadingOfACoarseSphereIsThatOfAFineOne) {
    const auto picture = [](int levels, bool smooth) {
        const Triangles sphere = MakeSphere(levels);
        Scene scene;
        scene.Add(Surface{
            .positions = sphere.positions, .triangles = sphere.triangles, .material = Matt(Palette::kSkin, smooth)});
        return Render(scene, CameraOnZ(5, 0.25, 0.25), Plain(100, 100));
    };
    const auto difference = [](const Image& a, const Image& b) {
        double largest = 0;
        for (int y = 30; y < 70; ++y) {  // well inside the silhouette
            for (int x = 30; x < 70; ++x)
                largest = std::max(largest, std::abs(static_cast<double>(a.At(x, y).g - b.At(x, y).g)));
        }
        return largest;
    };
    const Image fine = picture(6, true);
    EXPECT_LT(difference(picture(3, true), fine), 0.02);   // normals are right to the triangle size squared
    EXPECT_GT(difference(picture(3, false), fine), 0.04);  // facets show
}

TEST(RenderTest, ValuesAreColouredByTheMap) {
    const Triangles square = MakeSquare(0, 4);
    const auto middle = [&](std::vector<double> values, double low, double high) {
        Scene scene;
        scene.Add(Surface{.positions = square.positions,
                          .triangles = square.triangles,
                          .material = Matt(kBlack),
                          .values = values,
                          .low = low,
                          .high = high});
        return Render(scene, CameraOnZ(10, 0.2, 0.2), Plain(20, 20)).At(10, 10);
    };
    const auto hue_is = [](Color seen, Color expected) {
        // Light scales all three channels alike: compare ratios of linear light, to the rounding of 8 bits.
        const auto linear = [](Color c) {
            return std::array{Internal::DecodeSrgb(c.r), Internal::DecodeSrgb(c.g), Internal::DecodeSrgb(c.b)};
        };
        const auto s = linear(seen), e = linear(expected);
        const float light = (s[0] + s[1] + s[2]) / (e[0] + e[1] + e[2]);
        EXPECT_GT(light, 0.3f);
        for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(s[k], light * e[k], 0.01) << k;
    };
    hue_is(middle({2, 2, 2, 2}, 1, 3), Lookup(ColorMap::Sequential, 0.5));
    hue_is(middle({1, 2, 3, 2}, 0, 0), Lookup(ColorMap::Sequential, 0.5));  // own range; interpolated
    hue_is(middle({0, 0, 0, 0}, 1, 3), Lookup(ColorMap::Sequential, 0));
    hue_is(middle({5, 5, 5, 5}, 1, 21), Lookup(ColorMap::Sequential, 0.2));
    hue_is(middle({NAN, NAN, NAN, NAN}, 0, 1), Lookup(ColorMap::Sequential, NAN));
    hue_is(middle({7, 7, 7, 7}, 0, 0), Lookup(ColorMap::Sequential, 0.5));  // one value: the map's middle
}

TEST(RenderTest, ProgressIsReportedAndCanCancel) {
    double last = -1;
    Render(SceneOfEverything(), View{}, {.width = 32, .height = 300}, [&](std::string_view, double fraction) {
        EXPECT_GT(fraction, last);
        last = fraction;
        return true;
    });
    EXPECT_EQ(last, 1);
    EXPECT_THROW(Render(SceneOfEverything(), View{}, {.width = 32, .height = 300},
                        [](std::string_view, double f) { return f < 0.3; }),
                 Cancelled);
}

TEST(RenderTest, OptionsOutOfRangeAreRefused) {
    const Scene scene = SceneOfEverything();
    EXPECT_THROW(Render(scene, View{}, {.width = 0}), InvalidInput);
    EXPECT_THROW(Render(scene, View{}, {.height = 40000}), InvalidInput);
    EXPECT_THROW(Render(scene, View{}, {.samples = 0}), InvalidInput);
    EXPECT_THROW(Render(scene, View{}, {.light_rays = -1}), InvalidInput);
}

}  // namespace
}  // namespace SolidSubdiv::Picture
