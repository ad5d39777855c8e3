// SPDX-License-Identifier: Apache-2.0
// Laws of starting cages, and of lattices of tets: topology is kept, numbers are near, shapes are good.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <solidsubdiv/sdc/errors.h>

#include "apps/fit/start_testing.h"
#include "sanitized.h"
#include "test_shapes.h"

namespace SolidSubdiv::Fit {
namespace {

/// A sphere without the triangles around two of its poles.
Surface Tube() {
    Surface s = SphereAt({0, 0, 0}, 1), tube{s.positions, {}};
    for (std::size_t t = 0; t < s.triangles.size(); t += 3) {
        double z = 0;
        for (std::size_t k = 0; k < 3; ++k) z += s.positions[3 * static_cast<std::size_t>(s.triangles[t + k]) + 2] / 3;
        if (std::abs(z) > .8) continue;
        tube.triangles.insert(tube.triangles.end(), &s.triangles[t], &s.triangles[t] + 3);
    }
    return tube;
}

TEST(Cage, KeepsComponentsHandlesAndBorders) {
    Surface two = SphereAt({0, 0, 0}, 1);
    two.Add(Torus(20));
    struct Case {
        std::string name;
        Surface target;
    };
    for (const Case& c : {Case{"torus", Torus(30)}, Case{"two", two}, Case{"tube", Tube()}, Case{"bunny", Bunny()}}) {
        const auto wanted =
            Geometry::SurfaceComponents(c.target.triangles, static_cast<Index>(c.target.positions.size() / 3));
        StartReport report;
        const ControlMesh cage = MakeCage(c.target.View(), {.n_control = 120}, &report);
        const auto made = BoundaryOf(cage);
        ASSERT_EQ(made.size(), wanted.size()) << c.name;
        EXPECT_EQ(EulerOf(made), EulerOf(wanted)) << c.name;
        Offset n_loops = 0, n_wanted_loops = 0;
        for (const auto& m : made) {
            EXPECT_TRUE(m.IsManifold() && m.n_flipped_edges == 0) << c.name;
            n_loops += m.n_border_loops;
        }
        for (const auto& w : wanted) n_wanted_loops += w.n_border_loops;
        EXPECT_EQ(n_loops, n_wanted_loops) << c.name;
        EXPECT_NEAR(cage.n_vertices(), 120, 6) << c.name;  // 5 %
        EXPECT_TRUE(report.has_target_topology) << c.name;
    }
}

/// Flips leave few vertices far from regular, on what is smooth.
TEST(Cage, ValencesAreNearSix) {
    const ControlMesh cage = MakeCage(Bunny().View(), {.n_control = 300});
    std::vector<int> valences(static_cast<std::size_t>(cage.n_vertices()), 0);
    for (Index v : cage.triangles) ++valences[static_cast<std::size_t>(v)];  // closed: as many triangles as edges
    const auto n_near = std::count_if(valences.begin(), valences.end(), [](int n) { return n >= 5 && n <= 7; });
    EXPECT_GT(n_near, .9 * cage.n_vertices());
    EXPECT_GE(*std::min_element(valences.begin(), valences.end()), 3);
}

TEST(Cage, OfQuadrilateralsIsAClosedManifoldOfTheTargetsTopology) {
    SOLIDSUBDIV_LONG_TEST();
    StartReport report;
    const ControlMesh cage = MakeCage(Torus(24).View(), {.n_control = 200, .quads = true}, &report);
    EXPECT_TRUE(cage.triangles.empty());
    const auto made = BoundaryOf(cage);
    ASSERT_EQ(made.size(), 1u);
    EXPECT_TRUE(made[0].IsManifold() && made[0].IsClosed() && made[0].n_flipped_edges == 0);
    EXPECT_EQ(made[0].EulerCharacteristic(), 0);
    EXPECT_TRUE(report.has_target_topology);
    EXPECT_NEAR(cage.n_vertices(), 200, .15 * 200);
}

TEST(Cage, BadTargetsAreNamed) {
    const auto message_of = [](const Surface& target, const StartOptions& options) {
        try {
            MakeCage(target.View(), options);
        } catch (const InvalidInput& error) {
            return std::string(error.what());
        }
        return std::string("no error");
    };
    EXPECT_THAT(message_of(Tube(), {.quads = true}), testing::HasSubstr("the target is open"));
    Surface fins = SphereAt({0, 0, 0}, 1);
    fins.positions.insert(fins.positions.end(), {3, 3, 3});
    fins.triangles.insert(fins.triangles.end(),
                          {fins.triangles[0], fins.triangles[1], static_cast<Index>(fins.positions.size() / 3) - 1});
    EXPECT_THAT(message_of(fins, {}), testing::HasSubstr("no oriented manifold: 1 edges of more than two triangles"));
    Surface turned = SphereAt({0, 0, 0}, 1);
    std::swap(turned.triangles[0], turned.triangles[1]);
    EXPECT_THAT(message_of(turned, {}), testing::HasSubstr("3 edges whose triangles look against each other"));
}

/// Points of a long tilted box: no start has triangles to go by.
TEST(CloudStart, IsOneClosedPieceOfAboutAsManyControlPoints) {
    SOLIDSUBDIV_LONG_TEST();
    TestShapes::Random random(5);
    Surface cloud;
    for (int i = 0; i < 500; ++i) {
        const double x = 3 * random.Uniform(), y = random.Uniform(), z = random.Uniform();
        cloud.positions.insert(cloud.positions.end(), {x - .5 * y, y + .5 * x, z});
    }
    for (bool is_solid : {true, false}) {
        StartReport report;
        const StartOptions options{.n_control = 150};
        const ControlMesh mesh =
            is_solid ? MakeSolidStart(cloud.View(), options, &report) : MakeCage(cloud.View(), options, &report);
        const auto boundary = BoundaryOf(mesh);
        ASSERT_EQ(boundary.size(), 1u);
        EXPECT_EQ(boundary[0].EulerCharacteristic(), 2);
        EXPECT_TRUE(report.has_target_topology);
        EXPECT_NEAR(mesh.n_vertices(), 150, .15 * 150);
        // Of a cage there is no cell: infinite.
        EXPECT_GT(LeastDeterminant(mesh), 0);
    }
}

TEST(TetStart, IsPositiveAndHasTheTopologyOfItsTarget) {
    SOLIDSUBDIV_LONG_TEST();
    StartReport report;
    const ControlMesh mesh = MakeSolidStart(Torus(24).View(), {.n_control = 250, .tets = true}, &report);
    EXPECT_TRUE(mesh.hexes.empty());
    EXPECT_FALSE(mesh.tets.empty());
    const auto boundary = BoundaryOf(mesh);
    ASSERT_EQ(boundary.size(), 1u);
    EXPECT_TRUE(boundary[0].IsManifold() && boundary[0].IsClosed());
    EXPECT_EQ(boundary[0].EulerCharacteristic(), 0);
    EXPECT_GT(LeastDeterminant(mesh), 0);
    EXPECT_TRUE(report.has_target_topology);
    EXPECT_NEAR(mesh.n_vertices(), 250, .15 * 250);
}

}  // namespace
}  // namespace SolidSubdiv::Fit
