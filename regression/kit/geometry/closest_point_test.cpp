// SPDX-License-Identifier: Apache-2.0
// Nearest points of surfaces and clouds, against all elements one after another; distances between known surfaces.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <solidsubdiv/kit/geometry/surface_distance.h>
#include <solidsubdiv/sdc/errors.h>
#include <solidsubdiv/sdc/parallel.h>

#include <cmath>

#include "test_shapes.h"

namespace SolidSubdiv::Geometry {
namespace {

using TestShapes::Random;

/// Triangles anywhere in [-1, 1]^3, some of them flat, some a point.
struct Soup {
    std::vector<double> positions;
    std::vector<Index> triangles;

    explicit Soup(int n, std::uint64_t seed) {
        Random random(seed);
        for (int t = 0; t < n; ++t) {
            double a[3];
            for (double& x : a) x = random.Uniform();
            for (int k = 0; k < 3; ++k) {
                for (double x : a) {
                    const double step = 0.2 * random.Uniform();
                    positions.push_back(t % 7 == 0 ? x : t % 5 == 0 ? x + 0.1 * k : x + step);
                }
                triangles.push_back(3 * t + k);
            }
        }
    }
};

/// The distance to a triangle by many points of it.
double DistanceBySamples(const Soup& soup, std::size_t t, const double* p, int n) {
    double least = HUGE_VAL;
    for (int i = 0; i <= n; ++i) {
        for (int j = 0; i + j <= n; ++j) {
            double square = 0;
            for (std::size_t c = 0; c < 3; ++c) {
                const double* v = &soup.positions[9 * t + c];
                const double x = (v[0] * (n - i - j) + v[3] * i + v[6] * j) / n;
                square += (x - p[c]) * (x - p[c]);
            }
            least = std::min(least, square);
        }
    }
    return std::sqrt(least);
}

std::vector<double> SomePoints(int n, double reach, std::uint64_t seed) {
    Random random(seed);
    std::vector<double> points;
    for (int i = 0; i < 3 * n; ++i) points.push_back(reach * random.Uniform());
    return points;
}

TEST(ClosestPoints, AreNoFartherThanAnyPointOfAnyTriangle_AndOnTheirOwn) {
    const Soup soup(60, 1);
    const ClosestPoints surface(soup.positions, soup.triangles);
    for (double reach : {1.0, 1e3}) {
        const std::vector<double> points = SomePoints(40, reach, 2);
        const auto found = surface.Find(points);
        for (std::size_t i = 0; i < found.size(); ++i) {
            const double* p = &points[3 * i];
            double least = HUGE_VAL;
            for (std::size_t t = 0; t < 60; ++t) least = std::min(least, DistanceBySamples(soup, t, p, 40));
            // Samples lie at most 0.3 / 40 apart.
            EXPECT_LE(found[i].distance, least + 1e-12 * reach);
            EXPECT_GE(found[i].distance, least - 0.01);
            double square = 0;
            for (std::size_t c = 0; c < 3; ++c) {
                double x = 0;
                for (std::size_t k = 0; k < 3; ++k) {
                    EXPECT_GE(found[i].weights[k], -1e-15);
                    x += found[i].weights[k] *
                         soup.positions[9 * static_cast<std::size_t>(found[i].element) + 3 * k + c];
                }
                EXPECT_NEAR(x, found[i].position[c], 1e-12 * reach);
                square += (x - p[c]) * (x - p[c]);
            }
            EXPECT_NEAR(std::sqrt(square), found[i].distance, 1e-12 * reach);
        }
    }
}

TEST(ClosestPoints, OfCloudsAreTheNearestOfAll) {
    const std::vector<double> cloud = SomePoints(500, 1, 3), points = SomePoints(200, 1.5, 4);
    const auto found = ClosestPoints(cloud, {}).Find(points);
    for (std::size_t i = 0; i < found.size(); ++i) {
        double least = HUGE_VAL;
        for (std::size_t j = 0; j < cloud.size(); j += 3) {
            least = std::min(least, std::hypot(cloud[j] - points[3 * i], cloud[j + 1] - points[3 * i + 1],
                                               cloud[j + 2] - points[3 * i + 2]));
        }
        EXPECT_NEAR(found[i].distance, least, 1e-14);
    }
}

TEST(ClosestPoints, DoNotDependOnThreadsUnitsOrTheOrderOfElements) {
    const Soup soup(60, 5);
    const std::vector<double> points = SomePoints(300, 1.2, 6);
    std::vector<std::vector<ClosestPoint>> results;
    for (int n : {1, 2, 3}) {
        const Sdc::ThreadLimit limit(n);
        results.push_back(ClosestPoints(soup.positions, soup.triangles).Find(points));
    }
    for (const double unit : {0x1p-200, 0x1p200}) {
        std::vector<double> scaled = soup.positions, scaled_points = points;
        for (double& x : scaled) x *= unit;
        for (double& x : scaled_points) x *= unit;
        results.push_back(ClosestPoints(scaled, soup.triangles).Find(scaled_points));
        for (ClosestPoint& p : results.back()) p.distance /= unit;
    }
    for (const auto& other : results) {
        for (std::size_t i = 0; i < other.size(); ++i) {
            EXPECT_EQ(other[i].element, results[0][i].element);
            EXPECT_EQ(other[i].distance, results[0][i].distance);
        }
    }
    std::vector<Index> backwards;
    for (std::size_t t = soup.triangles.size(); t > 0; t -= 3) {
        backwards.insert(backwards.end(), soup.triangles.begin() + static_cast<std::ptrdiff_t>(t - 3),
                         soup.triangles.begin() + static_cast<std::ptrdiff_t>(t));
    }
    const auto turned = ClosestPoints(soup.positions, backwards).Find(points);
    for (std::size_t i = 0; i < turned.size(); ++i) EXPECT_EQ(turned[i].distance, results[0][i].distance);
}

TEST(ClosestPoints, RefuseWhatIsNoSurface) {
    const std::vector<double> positions = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    EXPECT_THROW(ClosestPoints({}, {}), InvalidInput);
    EXPECT_THROW(ClosestPoints(positions, std::vector<Index>{0, 1, 3}), InvalidInput);
    EXPECT_THROW(ClosestPoints(positions, std::vector<Index>{0, 1, -1}), InvalidInput);
    EXPECT_THROW(ClosestPoints(std::vector<double>{0, NAN, 0}, {}), InvalidInput);
    EXPECT_THROW(ClosestPoints(positions, {}).Find(std::vector<double>{0, 0, HUGE_VAL}), InvalidInput);
}

TEST(MeasureDistance, OfParallelPlanesIsTheirDistance_AndOfTiltedOnesItsMoments) {
    const TestShapes::Shape grid = TestShapes::TriangleGrid(4);
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (std::size_t i = 0; i < grid.positions.size(); i += 3) {
        low = std::min(low, grid.positions[i]);
        high = std::max(high, grid.positions[i]);
    }
    // A large flat target below.
    const std::vector<double> plane = {-99, -99, 0, 99, -99, 0, 0, 99, 0};
    const std::vector<Index> triangle = {0, 1, 2};
    const ClosestPoints target(plane, triangle);
    std::vector<double> lifted = grid.positions;
    for (std::size_t i = 0; i < lifted.size(); i += 3) lifted[i + 2] = 0.25;
    const DistanceSummary level = MeasureDistance(lifted, grid.triangles, target);
    for (double d : {level.rms, level.mean, level.p95, level.p99, level.most}) EXPECT_NEAR(d, 0.25, 1e-12);
    for (std::size_t i = 0; i < lifted.size(); i += 3) lifted[i + 2] = (lifted[i] - low) / (high - low);
    const DistanceSummary tilted = MeasureDistance(lifted, grid.triangles, target, {.n_points = 200'000});
    // Uniform in [0, 1] over a square; parts of triangles are 1/100 high.
    EXPECT_NEAR(tilted.mean, 0.5, 1e-3);
    EXPECT_NEAR(tilted.rms, std::sqrt(1.0 / 3), 1e-3);
    EXPECT_NEAR(tilted.p95, 0.95, 5e-3);
    EXPECT_NEAR(tilted.p99, 0.99, 5e-3);
    EXPECT_EQ(tilted.most, 1);
    EXPECT_EQ(lifted[3 * static_cast<std::size_t>(tilted.most_vertex) + 2], 1);
    EXPECT_GT(tilted.n_points, 150'000);
}

TEST(MeasureDistance, LeavesOutWhatItIsToldTo) {
    // Two triangles of a square, one of them twice as far away; its points are known by their number and their place.
    const std::vector<double> square = {0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1};
    const std::vector<Index> triangles = {0, 1, 2, 0, 2, 3};
    const std::vector<double> plane = {-99, -99, 0, 99, -99, 0, 0, 99, 0};
    const std::vector<Index> triangle = {0, 1, 2};
    const ClosestPoints target(plane, triangle);
    const DistanceSummary half =
        MeasureDistance(square, triangles, target, {.is_left_out = [](const ClosestPoint&, const auto& p, Index t) {
                            EXPECT_NEAR(p[2], 1, 1e-12);
                            if (std::abs(p[1] - p[0]) > 1e-9) {
                                EXPECT_EQ(t == 1, p[1] > p[0]);
                            }
                            return t == 1;
                        }});
    EXPECT_NEAR(half.left_out, 0.5, 1e-12);
    EXPECT_NEAR(half.rms, 1, 1e-12);
    const DistanceSummary none = MeasureDistance(square, triangles, target,
                                                 {.is_left_out = [](const auto&, const auto&, Index) { return true; }});
    EXPECT_EQ(none.left_out, 1);
    EXPECT_EQ(none.n_points, 0);
}

TEST(MeasureDistance, OfCloudsCountsPoints) {
    const std::vector<double> origin = {0, 0, 0}, points = {1, 0, 0, 0, 2, 0, 0, 0, 2};
    const DistanceSummary d = MeasureDistance(points, {}, ClosestPoints(origin, {}));
    EXPECT_EQ(d.n_points, 3);
    EXPECT_NEAR(d.rms, std::sqrt(3.0), 1e-15);
    EXPECT_EQ(d.most, 2);
}

}  // namespace
}  // namespace SolidSubdiv::Geometry
