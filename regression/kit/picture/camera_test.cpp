// SPDX-License-Identifier: Apache-2.0
// The fitted camera: everything in the frame, and nothing larger would be.
#include <gtest/gtest.h>
#include <solidsubdiv/kit/picture/camera.h>
#include <solidsubdiv/kit/picture/scene.h>
#include <solidsubdiv/sdc/errors.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace SolidSubdiv::Picture {
namespace {

std::vector<double> RandomPoints(int n, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> x(-1, 1);
    std::vector<double> points;
    for (int i = 0; i < n; ++i) points.insert(points.end(), {3 * x(random) + 20, x(random), 0.5 * x(random) - 7});
    return points;
}

double Dot(const double* p, const std::array<double, 3>& a) { return p[0] * a[0] + p[1] * a[1] + p[2] * a[2]; }

/// The largest distance of a projected point from the picture's middle, 1 = at its edge, across and down.
std::pair<double, double> Extent(const Camera& camera, const std::vector<double>& points, double sign_x,
                                 double sign_y) {
    double x = -HUGE_VAL, y = -HUGE_VAL;
    for (std::size_t i = 0; i < points.size(); i += 3) {
        const double p[3] = {points[i] - camera.position[0], points[i + 1] - camera.position[1],
                             points[i + 2] - camera.position[2]};
        const double depth = Dot(p, camera.forward);
        EXPECT_GT(depth, 0);
        x = std::max(x, sign_x * Dot(p, camera.right) / depth / camera.half_width);
        y = std::max(y, sign_y * Dot(p, camera.up) / depth / camera.half_height);
    }
    return {x, y};
}

TEST(CameraTest, FittedSceneFillsTheFrameBetweenTheMargins) {
    for (unsigned seed = 0; seed < 40; ++seed) {
        const std::vector<double> points = RandomPoints(30, seed);
        Scene scene;
        scene.Add(Points{.positions = points});
        const View view{.azimuth = 37.0 * seed,
                        .elevation = seed * 4.5 - 90,
                        .field_of_view = 10.0 + 2 * seed,
                        .margin = 0.01 * (seed % 10),
                        .up = seed % 2 == 0 ? UpAxis::Y : UpAxis::Z};
        const Camera camera = FitCamera(view, seed % 3 == 0 ? 400 : 800, 600, scene);
        const auto [right, top] = Extent(camera, points, 1, 1);
        const auto [left, bottom] = Extent(camera, points, -1, -1);
        const double frame = 1 - 2 * view.margin;
        // Centred both ways, and tight in one of them; doubles hold 1e-9 at coordinates of 20.
        EXPECT_NEAR(std::max({right, left, top, bottom}), frame, 1e-9);
        EXPECT_TRUE(std::abs(right - frame) + std::abs(left - frame) < 1e-9 ||
                    std::abs(top - frame) + std::abs(bottom - frame) < 1e-9);
    }
}

TEST(CameraTest, AxesAreAsTheViewSays) {
    const std::vector<double> points = RandomPoints(5, 1);
    Scene scene;
    scene.Add(Points{.positions = points});
    const auto expect = [](const std::array<double, 3>& a, const std::array<double, 3>& b) {
        for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(a[k], b[k], 1e-15);
    };
    const Camera front = FitCamera({.azimuth = 0, .elevation = 0}, 100, 100, scene);
    expect(front.forward, {0, 0, -1});
    expect(front.up, {0, 1, 0});
    expect(front.right, {1, 0, 0});
    const Camera side = FitCamera({.azimuth = 90, .elevation = 0}, 100, 100, scene);
    expect(side.forward, {-1, 0, 0});
    const Camera above = FitCamera({.azimuth = 0, .elevation = 90, .up = UpAxis::Z}, 100, 100, scene);
    expect(above.forward, {0, 0, -1});
    expect(above.up, {0, 1, 0});
    expect(above.world_up, {0, 0, 1});
    const Camera front_z = FitCamera({.azimuth = 0, .elevation = 0, .up = UpAxis::Z}, 100, 100, scene);
    expect(front_z.forward, {0, 1, 0});
    expect(front_z.right, {1, 0, 0});
}

TEST(CameraTest, SeveralScenesShareOneCamera) {
    const std::vector<double> a = RandomPoints(9, 1), b = RandomPoints(9, 2);
    std::vector<double> both = a;
    both.insert(both.end(), b.begin(), b.end());
    Scene first, second, together;
    first.Add(Points{.positions = a});
    second.Add(Points{.positions = b});
    together.Add(Points{.positions = both});
    const Scene* scenes[] = {&first, &second};
    EXPECT_EQ(FitCamera({}, 640, 480, scenes).position, FitCamera({}, 640, 480, together).position);
}

TEST(CameraTest, PointsThatNothingUsesAreNotFitted) {
    const std::vector<double> points = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1000, 1000, 1000};
    const std::vector<Index> triangle = {0, 1, 2};
    Scene all, used;
    all.Add(Surface{.positions = points, .triangles = triangle});
    used.Add(Surface{.positions = std::span(points).first(9), .triangles = triangle});
    EXPECT_EQ(FitCamera({}, 64, 64, all).position, FitCamera({}, 64, 64, used).position);
}

TEST(CameraTest, ASinglePointCanBeLookedAt) {
    const std::vector<double> point = {5, 6, 7};
    Scene scene;
    scene.Add(Points{.positions = point});
    const Camera camera = FitCamera({}, 64, 64, scene);
    const auto [x, y] = Extent(camera, point, 1, 1);
    EXPECT_NEAR(x, 0, 1e-12);
    EXPECT_NEAR(y, 0, 1e-12);
}

TEST(CameraTest, NothingToSeeAndViewsOutOfRangeAreRefused) {
    Scene scene;
    EXPECT_THROW(FitCamera({}, 64, 64, scene), InvalidInput);
    scene.Add(Points{.positions = RandomPoints(2, 0)});
    EXPECT_THROW(FitCamera({.elevation = 91}, 64, 64, scene), InvalidInput);
    EXPECT_THROW(FitCamera({.azimuth = NAN}, 64, 64, scene), InvalidInput);
    EXPECT_THROW(FitCamera({.field_of_view = 0}, 64, 64, scene), InvalidInput);
    EXPECT_THROW(FitCamera({.margin = 0.5}, 64, 64, scene), InvalidInput);
}

}  // namespace
}  // namespace SolidSubdiv::Picture
