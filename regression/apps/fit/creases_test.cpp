// SPDX-License-Identifier: Apache-2.0
// Sharp edges of targets, and creases along them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <solidsubdiv/apps/fit/creases.h>
#include <solidsubdiv/apps/fit/start.h>
#include <solidsubdiv/sdc/errors.h>

#include <algorithm>

#include "apps/fit/start_testing.h"

namespace SolidSubdiv::Fit {
namespace {

TEST(SharpEdges, OfACubeAreItsTwelveInAnyUnit) {
    for (double size : {1e-9, 1.0, 1e9}) {
        EXPECT_EQ(SharpEdges(Cube(4, size).View(), 50).size(), 2u * 12 * 4) << size;
        EXPECT_EQ(SharpEdges(Cube(4, size).View(), 89).size(), 2u * 12 * 4) << size;
        EXPECT_TRUE(SharpEdges(Cube(4, size).View(), 91).empty()) << size;
    }
}

TEST(SharpEdges, DoNotDependOnTheOrderOfTriangles) {
    Surface cube = Cube(3);
    const std::vector<Index> edges = SharpEdges(cube.View(), 50);
    std::reverse(cube.triangles.begin(), cube.triangles.end());  // looks inwards, too
    EXPECT_EQ(SharpEdges(cube.View(), 50), edges);
}

TEST(SharpAngle, PartsHaveOneScansHaveNone) {
    EXPECT_EQ(SharpAngle(Cube(4).View()), 50);
    EXPECT_EQ(SharpAngle(SphereAt({0, 0, 0}, 1).View()), 0);
    ASSERT_FALSE(SharpEdges(Bunny().View(), 50).empty());
    EXPECT_EQ(SharpAngle(Bunny().View()), 0);
}

TEST(MarkCreases, AlongTheEdgesOfACube_AndNowhereElse) {
    const Surface target = Cube(6);
    const Surface coarse = Cube(2);
    ControlMesh cage{.positions = coarse.positions, .triangles = coarse.triangles};
    EXPECT_EQ(MarkCreases(cage, target.View(), {}), 12 * 2);
    ASSERT_EQ(cage.crease_edges.size(), 2u * 24);
    EXPECT_THAT(cage.crease_sharpness, testing::Each(10.f));
    for (std::size_t i = 0; i < cage.crease_edges.size(); i += 2) {
        // Both ends have two coordinates of the cube's sides in common.
        int n_common = 0;
        for (std::size_t c = 0; c < 3; ++c) {
            const double a = cage.positions[3 * static_cast<std::size_t>(cage.crease_edges[i]) + c];
            const double b = cage.positions[3 * static_cast<std::size_t>(cage.crease_edges[i + 1]) + c];
            n_common += a == b && (a == 0 || a == 1);
        }
        EXPECT_EQ(n_common, 2) << i;
    }
    ControlMesh ball = MakeCage(SphereAt({0, 0, 0}, 1).View(), {.n_control = 40});
    EXPECT_EQ(MarkCreases(ball, SphereAt({0, 0, 0}, 1).View(), {}), 0);
}

TEST(MarkCreases, OptionsOutOfRangeAreRefused) {
    ControlMesh cage{.positions = Cube(1).positions, .triangles = Cube(1).triangles};
    for (double degrees : {0.0, 180.0, -1.0}) EXPECT_THROW(MarkCreases(cage, {}, {.degrees = degrees}), InvalidInput);
    for (double near : {0.0, 2.0}) EXPECT_THROW(MarkCreases(cage, {}, {.near = near}), InvalidInput);
}

}  // namespace
}  // namespace SolidSubdiv::Fit
