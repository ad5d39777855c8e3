// SPDX-License-Identifier: Apache-2.0
// Surfaces with holes, and parts that a start lacks.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <solidsubdiv/apps/fit/find_start.h>
#include <solidsubdiv/apps/fit/fit_solid.h>
#include <solidsubdiv/apps/fit/internal/coverage.h>
#include <solidsubdiv/apps/fit/open_surface.h>
#include <solidsubdiv/kit/geometry/surface_components.h>
#include <solidsubdiv/sdc/errors.h>

#include <cmath>

#include "apps/fit/fit_testing.h"
#include "apps/fit/start_testing.h"
#include "sanitized.h"

namespace SolidSubdiv::Fit {
namespace {

using Internal::Coverage;
using Internal::PointAt;
using testing::HasSubstr;

/// Around the origin, of radius 1, without what is above z = 0.8.
Surface OpenSphere() {
    const Surface whole = SphereAt({0, 0, 0}, 1);
    Surface open{whole.positions, {}};
    for (std::size_t t = 0; t < whole.triangles.size(); t += 3) {
        double z = 0;
        for (std::size_t k = 0; k < 3; ++k) z += PointAt(whole.positions, whole.triangles[t + k]).z / 3;
        if (z > 0.8) continue;
        for (std::size_t k = 0; k < 3; ++k) open.triangles.push_back(whole.triangles[t + k]);
    }
    return open;
}

TEST(CloseSurface, BridgesTheHoleAndTellsWhichWayItLooks) {
    SOLIDSUBDIV_LONG_TEST();
    const Surface open = OpenSphere(), inwards = open.InsideOut();
    for (const Surface* surface : {&open, &inwards}) {
        const CloudShape shape = CloseSurface(surface->positions, surface->triangles);
        const auto pieces =
            Geometry::SurfaceComponents(shape.triangles, static_cast<Index>(shape.positions.size() / 3));
        ASSERT_EQ(pieces.size(), 1u);
        EXPECT_TRUE(pieces[0].IsClosed());
        EXPECT_EQ(pieces[0].EulerCharacteristic(), 2);
        EXPECT_EQ(shape.has_turned_normals, surface == &inwards);
        double highest = 0;
        for (std::size_t i = 2; i < shape.positions.size(); i += 3) highest = std::max(highest, shape.positions[i]);
        EXPECT_GT(highest, 0.6);
    }
}

TEST(CloseSurface, FindsNothingInAFlatSheet_AndRefusesWhatIsNoSurface) {
    const std::vector<double> square = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
    EXPECT_TRUE(CloseSurface(square, std::vector<Index>{0, 1, 2, 0, 2, 3}).triangles.empty());
    EXPECT_THROW(CloseSurface(square, std::vector<Index>{0, 1, 9}), InvalidInput);
    const std::vector<double> line = {0, 0, 0, 1, 0, 0, 2, 0, 0};
    EXPECT_THROW(CloseSurface(line, std::vector<Index>{0, 1, 2}), InvalidInput);
}

TEST(Coverage, EndsAtBordersAndWhereTheTargetLooksElsewhere) {
    // A square of two triangles.
    const std::vector<double> square = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
    const std::vector<Index> triangles = {0, 1, 2, 0, 2, 3};
    const TargetSurface target{.positions = square, .triangles = triangles};
    const Geometry::ClosestPoints nearest(square, triangles);
    const Coverage coverage(target);
    const auto covers = [&](const std::array<double, 3>& p, const Internal::Vec3& normal) {
        return coverage.Covers(nearest.Find(p)[0], {p[0], p[1], p[2]}, normal);
    };
    EXPECT_TRUE(covers({.3, .4, 1}, {0, 0, 2}));
    EXPECT_TRUE(covers({.5, .5, 1}, {0, 0, 2})) << "between the triangles";
    EXPECT_FALSE(covers({1.3, .4, 0.1}, {0, 0, 2})) << "beyond the border";
    EXPECT_FALSE(covers({.3, .4, 1}, {2, 0, .5})) << "looks aside";
    EXPECT_FALSE(covers({.3, .4, 1}, {0, 0, -1})) << "looks back";

    // Closed: it says something everywhere.
    const Surface sphere = SphereAt({0, 0, 0}, 1);
    const Geometry::ClosestPoints on_sphere(sphere.positions, sphere.triangles);
    const std::array<double, 3> p{2, 0, 0};
    EXPECT_TRUE(Coverage(sphere.View()).Covers(on_sphere.Find(p)[0], {2, 0, 0}, {0, 0, 1}));
}

TEST(FitSolid, GoesOnOverHolesAsAroundThem) {
    const Surface open = OpenSphere();
    const CloudShape closed = CloseSurface(open.positions, open.triangles);
    const Sdc::Scheme scheme = Sdc::CatmullClarkSolid{};
    const ControlMesh start =
        MakeSolidStart({.positions = closed.positions, .triangles = closed.triangles}, {.n_control = 120});
    const SolidFit fit = FitSolid(start, scheme, open.View(), {});
    EXPECT_EQ(fit.n_folded, 0);
    EXPECT_GT(fit.result.to_target.left_out, 0.02);  // the cap is a tenth of the sphere
    EXPECT_LT(fit.result.to_target.left_out, 0.2);
    EXPECT_LT(fit.result.to_target.rms, 0.01);
    EXPECT_LT(fit.result.from_target.rms, 0.01);
    for (Index v = 0; static_cast<std::size_t>(v) < fit.result.vertices.size() / 3; ++v) {
        // A flat lid would be at 0.8.
        EXPECT_GT(Internal::Length(PointAt(fit.result.vertices, v)), 0.78) << v;
    }
}

TEST(FitControlPoints, SidesOfWhatTheSurfaceLacksDrawIt) {
    // A rod of eight radii, whose sides look across the way to a sphere in its middle.
    const ControlMesh start = SphereCage(2);
    Surface rod = SurfaceOf(MakeProblem(start, Sdc::LinearSurface{}, {}, 8));
    Map(rod.positions, [](std::array<double, 3> p) {
        const double length = std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
        for (double& x : p) x /= length;
        const double side = std::copysign(7., p[2]) * std::min(1., 4 * std::abs(p[2]));
        return std::array<double, 3>{p[0], p[1], p[2] + side};
    });
    const Result result = FitControlPoints(MakeProblem(start, Sdc::Loop{}, rod.View()), {.least_fairness = 1e-6});
    // Percent of the diagonal, 16.
    EXPECT_LT(result.from_target.most, 0.01 * 16);
}

}  // namespace
}  // namespace SolidSubdiv::Fit
