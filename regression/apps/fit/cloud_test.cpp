// SPDX-License-Identifier: Apache-2.0
// Clouds of points: what closes them, which way they look, and what a fit makes of holes, noise and outliers.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <solidsubdiv/apps/fit/cloud.h>
#include <solidsubdiv/apps/fit/fit.h>
#include <solidsubdiv/apps/fit/internal/neighbors.h>
#include <solidsubdiv/apps/fit/start.h>
#include <solidsubdiv/kit/geometry/surface_components.h>
#include <solidsubdiv/sdc/errors.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "sanitized.h"
#include "test_shapes.h"

namespace SolidSubdiv::Fit {
namespace {

using Internal::NeighborTree;
using Internal::PointAt;
using Internal::Vec3;

constexpr double kPi = 3.14159265358979323846;

/// Points on a sphere of radius 1 around (3, 2, 1), evenly strewn along a spiral.
std::vector<double> Sphere(int n) {
    std::vector<double> points;
    for (int i = 0; i < n; ++i) {
        const double z = 1 - (2 * i + 1.0) / n, r = std::sqrt(1 - z * z), a = kPi * (3 - std::sqrt(5.0)) * i;
        points.insert(points.end(), {3 + r * std::cos(a), 2 + r * std::sin(a), 1 + z});
    }
    return points;
}

double RadiusOf(const Vec3& p) { return Internal::Length(p - Vec3{3, 2, 1}); }

/// Those above z = 1.8 cut off: a hole of a tenth of the sphere.
std::vector<double> SphereWithHole(int n) {
    std::vector<double> points;
    const std::vector<double> all = Sphere(n);
    for (std::size_t i = 0; i < all.size(); i += 3) {
        if (all[i + 2] < 1.8)
            points.insert(points.end(), all.begin() + static_cast<std::ptrdiff_t>(i),
                          all.begin() + static_cast<std::ptrdiff_t>(i) + 3);
    }
    return points;
}

Offset EulerOf(const CloudShape& shape) {
    const auto pieces = Geometry::SurfaceComponents(shape.triangles, static_cast<Index>(shape.positions.size() / 3));
    if (pieces.size() != 1 || !pieces[0].IsClosed() || !pieces[0].IsManifold()) return -1000;
    return pieces[0].EulerCharacteristic();
}

TEST(NeighborTree, FindsWhatComparingAllFinds) {
    TestShapes::Random random(3);
    std::vector<double> points;
    for (int i = 0; i < 900; ++i) points.push_back(i < 600 ? random.Uniform() : 0.5);  // a third of them one point
    const NeighborTree tree(points);
    for (Index p = 0; p < 300; p += 7) {
        std::vector<NeighborTree::Neighbor> all;
        for (Index q = 0; q < 300; ++q) {
            const Vec3 d = PointAt(points, q) - PointAt(points, p);
            all.push_back({Internal::Dot(d, d), q});
        }
        std::sort(all.begin(), all.end());
        all.resize(9);
        EXPECT_EQ(tree.Find(PointAt(points, p), 9), all) << p;
    }
    EXPECT_EQ(tree.Find({0, 0, 0}, 1000).size(), 300u);
}

TEST(NeighborTree, SpacingOfASquareGridIsItsOwn) {
    std::vector<double> points;
    for (int i = 0; i < 30; ++i) {
        for (int j = 0; j < 30; ++j) points.insert(points.end(), {0.25 * i, 0.25 * j, 7});
    }
    // The sixth neighbour is sqrt(2) away where the measure expects sqrt(6 / pi) = 1.38.
    EXPECT_NEAR(Internal::SpacingOf(points, NeighborTree(points)), 0.25, 0.01);
}

TEST(CloudShape, ClosesASphereAndLooksOutwards) {
    SOLIDSUBDIV_LONG_TEST();
    const std::vector<double> points = Sphere(2000);
    for (const double unit : {1.0, 1e-9, 1e9}) {
        SCOPED_TRACE(unit);
        std::vector<double> scaled = points;
        for (double& x : scaled) x *= unit;
        const CloudShape shape = ShapeOfCloud(scaled, {});
        EXPECT_EQ(EulerOf(shape), 2);
        EXPECT_TRUE(shape.has_estimated_normals);
        // 2000 points on 4 pi.
        EXPECT_NEAR(shape.spacing / unit, std::sqrt(4 * kPi / 2000), 0.01);
        for (Index p = 0; p < 2000; ++p) {
            const Vec3 out = PointAt(points, p) - Vec3{3, 2, 1};
            // Planes through 12 neighbours of a sphere lean by a part of their width, a tenth of the radius.
            EXPECT_GT(Internal::Dot(PointAt(shape.normals, p), out), 0.99) << p;
        }
        for (Index v = 0; static_cast<std::size_t>(v) < shape.positions.size() / 3; ++v) {
            // A voxel is a 64th of the diameter.
            EXPECT_NEAR(RadiusOf(1 / unit * PointAt(shape.positions, v)), 1, 2 * 2.0 / 64) << v;
        }
    }
}

TEST(CloudShape, BridgesAHole) {
    const CloudShape shape = ShapeOfCloud(SphereWithHole(2000), {});
    EXPECT_EQ(EulerOf(shape), 2);
    double highest = 0;
    for (std::size_t i = 2; i < shape.positions.size(); i += 3) highest = std::max(highest, shape.positions[i]);
    // The cut is at 1.8; the bridge is no bowl that sinks to the middle.
    EXPECT_GT(highest, 1.6);
}

TEST(CloudShape, KeepsTheHoleOfATorus) {
    std::vector<double> points;
    for (int i = 0; i < 80; ++i) {
        for (int j = 0; j < 30; ++j) {
            const double a = 2 * kPi * i / 80, b = 2 * kPi * j / 30, r = 1 + 0.4 * std::cos(b);
            points.insert(points.end(), {r * std::cos(a), r * std::sin(a), 0.4 * std::sin(b)});
        }
    }
    EXPECT_EQ(EulerOf(ShapeOfCloud(points, {})), 0);
}

TEST(CloudShape, TurnsNormalsThatLookInwards) {
    SOLIDSUBDIV_LONG_TEST();
    const std::vector<double> points = Sphere(1000);
    std::vector<double> outwards = points;
    for (std::size_t i = 0; i < outwards.size(); ++i) outwards[i] = 5 * (points[i] - std::array{3, 2, 1}[i % 3]);
    std::vector<double> inwards = outwards;
    for (double& x : inwards) x = -x;
    outwards[0] = outwards[1] = outwards[2] = inwards[0] = inwards[1] = inwards[2] = 0;  // unknown
    const CloudShape kept = ShapeOfCloud(points, outwards), turned = ShapeOfCloud(points, inwards);
    EXPECT_FALSE(kept.has_turned_normals);
    EXPECT_TRUE(turned.has_turned_normals);
    for (std::size_t i = 0; i < points.size(); ++i) {
        EXPECT_NEAR(kept.normals[i], i < 3 ? 0 : outwards[i] / 5, 1e-12);  // round-off
        EXPECT_NEAR(turned.normals[i], kept.normals[i], 1e-12);
    }
}

TEST(CloudShape, FindsNothingWhereNothingIsEnclosed) {
    std::vector<double> line;
    for (int i = 0; i < 50; ++i) line.insert(line.end(), {1.0 * i, 2.0 * i, 0});
    const CloudShape shape = ShapeOfCloud(line, {});
    EXPECT_TRUE(shape.triangles.empty());
    // No plane through points of a line: nothing is known of normals.
    EXPECT_TRUE(std::all_of(shape.normals.begin(), shape.normals.end(), [](double x) { return x == 0; }));
}

TEST(CloudShape, RefusesWhatIsNoCloud) {
    const auto error_of = [](const std::vector<double>& points, const std::vector<double>& normals) -> std::string {
        try {
            ShapeOfCloud(points, normals);
        } catch (const InvalidInput& error) {
            return error.what();
        }
        return "none";
    };
    EXPECT_THAT(error_of({1, 2, 3}, {}), testing::HasSubstr("has 1 point; a shape needs four at least"));
    EXPECT_THAT(error_of(std::vector<double>(30, 2), {}), testing::HasSubstr("all points are one"));
    std::vector<double> points = Sphere(10);
    EXPECT_THAT(error_of(points, {1, 0, 0}), testing::HasSubstr("has 10 points and 1 normals"));
    points[7] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THAT(error_of(points, {}), testing::HasSubstr("point 2 is not finite"));
}

/// Fits a solid to points of the sphere. Largest and mean distance of its limit from the sphere itself.
struct SphereErrors {
    double largest = 0, rms = 0;
    int n_folded = 0;
};
SphereErrors FitSphere(const std::vector<double>& points, double robust) {
    const CloudShape shape = ShapeOfCloud(points, {});
    const ControlMesh start =
        MakeSolidStart({.positions = shape.positions, .triangles = shape.triangles}, {.n_control = 100});
    const Problem problem =
        MakeProblem(start, Sdc::CatmullClarkSolid{}, {.positions = points, .normals = shape.normals});
    const Result result = FitControlPoints(problem, {.max_rounds = 20, .robust = robust});
    SphereErrors errors{.n_folded = result.n_folded};
    for (Index v = 0; static_cast<std::size_t>(v) < result.vertices.size() / 3; ++v) {
        const double d = std::abs(RadiusOf(PointAt(result.vertices, v)) - 1);
        errors.largest = std::max(errors.largest, d);
        errors.rms += d * d;
    }
    errors.rms = std::sqrt(3 * errors.rms / static_cast<double>(result.vertices.size()));
    return errors;
}

TEST(CloudFit, IsNearerToTheSphereThanItsPointsToEachOther) {
    SOLIDSUBDIV_LONG_TEST();
    // Points are 0.11 apart. Planes lean by some 0.01; 100 control points alone reach 0.002 on a mesh.
    const SphereErrors errors = FitSphere(Sphere(1000), 0);
    EXPECT_LT(errors.rms, 0.01);
    EXPECT_LT(errors.largest, 0.03);
    EXPECT_EQ(errors.n_folded, 0);
}

TEST(CloudFit, AcrossAHoleGoesOnAsAroundIt) {
    SOLIDSUBDIV_LONG_TEST();
    // The hole is 1.2 wide; a flat lid would be 0.2 below the sphere, vertices drawn to its rim farther.
    const SphereErrors errors = FitSphere(SphereWithHole(1000), 0);
    EXPECT_LT(errors.largest, 0.2);
    EXPECT_LT(errors.rms, 0.05);
}

TEST(CloudFit, AveragesNoiseAndForgetsOutliers) {
    SOLIDSUBDIV_LONG_TEST();
    TestShapes::Random random(11);
    std::vector<double> points = Sphere(1000);
    for (double& x : points) x += 0.015 * random.Uniform();  // 0.5 % of the diagonal
    EXPECT_LT(FitSphere(points, 0).rms, 0.01);
    for (int i = 0; i < 50; ++i) {
        for (const double middle : {3.0, 2.0, 1.0}) points.push_back(middle + 1.5 * random.Uniform());
    }
    const double robust = FitSphere(points, 3).rms;
    EXPECT_LT(robust, 0.02);
    EXPECT_LT(robust, FitSphere(points, 0).rms);
}

}  // namespace
}  // namespace SolidSubdiv::Fit
