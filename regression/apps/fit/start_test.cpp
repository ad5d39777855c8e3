// SPDX-License-Identifier: Apache-2.0
// Laws of starting lattices: cells are positive, the boundary is a manifold of the target's topology.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <solidsubdiv/sdc/errors.h>
#include <solidsubdiv/sdc/parallel.h>

#include "apps/fit/start_testing.h"
#include "sanitized.h"

namespace SolidSubdiv::Fit {
namespace {

struct Case {
    std::string name;
    Surface target;
    Offset n_components, euler;
    StartOptions options{};
};

std::vector<Case> Cases() {
    Surface two = SphereAt({0, 0, 0}, 1);
    two.Add(SphereAt({3, 1, 0}, 1));
    Surface hollow = SphereAt({0, 0, 0}, 2);
    hollow.Add(SphereAt({.2, 0, 0}, 1).InsideOut());
    return {{"sphere", SphereAt({0, 0, 0}, 1), 1, 2},
            {"inside out", SphereAt({5, 0, 0}, 1).InsideOut(), 1, 2},
            {"torus", Torus(24), 1, 0, {.n_control = 400}},
            {"two spheres", two, 2, 4, {.n_control = 400}},
            {"hollow sphere", hollow, 2, 4, {.n_control = 500}},
            {"bunny", Bunny(), 1, 2}};
}

TEST(SolidStart, IsPositiveAndHasTheTopologyOfItsTarget) {
    SOLIDSUBDIV_LONG_TEST();
    for (const Case& c : Cases()) {
        if (kIsSanitized && c.options.n_control > 300) continue;
        StartReport report;
        const ControlMesh mesh = MakeSolidStart(c.target.View(), c.options, &report);
        const auto boundary = BoundaryOf(mesh);
        EXPECT_EQ(static_cast<Offset>(boundary.size()), c.n_components) << c.name;
        EXPECT_EQ(EulerOf(boundary), c.euler) << c.name;
        for (const auto& b : boundary) EXPECT_TRUE(b.IsManifold() && b.IsClosed() && b.n_flipped_edges == 0) << c.name;
        EXPECT_GT(LeastDeterminant(mesh), 0) << c.name;
        EXPECT_TRUE(report.has_target_topology) << c.name;
        EXPECT_EQ(report.euler, c.euler) << c.name;
        EXPECT_EQ(report.target_euler, c.euler) << c.name;
        EXPECT_GT(report.least_quality, 0) << c.name;
    }
}

TEST(SolidStart, HasAboutAsManyControlPointsAsAskedFor) {
    const Surface bunny = Bunny();
    for (Index n : {100, 300, 500}) {
        if (kIsSanitized && n > 100) break;
        const ControlMesh mesh = MakeSolidStart(bunny.View(), {.n_control = n});
        EXPECT_NEAR(mesh.n_vertices(), n, .15 * n);
        EXPECT_GT(LeastDeterminant(mesh), 0) << n;
    }
}

/// The layer: what is one smooth surface must not have two faces of one cell.
TEST(SolidStart, HexahedraHaveAtMostOneFaceOnTheBoundary) {
    SOLIDSUBDIV_LONG_TEST();
    const ControlMesh mesh = MakeSolidStart(Bunny().View(), {.n_control = 200});
    std::map<Index, int> on_boundary;
    const auto refiner = Far::TopologyRefiner::Create(mesh.View(), Sdc::Split::Polyhedral);
    const auto& level = refiner.polyhedral_level(0);
    std::vector<bool> is_boundary(static_cast<std::size_t>(mesh.n_vertices()), false);
    for (Index v : level.boundary_vertices) is_boundary[static_cast<std::size_t>(v)] = true;
    for (std::size_t c = 0; c < mesh.hexes.size(); c += 8) {
        const auto n = std::count_if(&mesh.hexes[c], &mesh.hexes[c] + 8,
                                     [&](Index v) { return is_boundary[static_cast<std::size_t>(v)]; });
        EXPECT_THAT(n, testing::AnyOf(0, 4)) << "cell " << c / 8;
    }
}

/// Powers of two: no rounding differs.
TEST(SolidStart, DoesNotDependOnTheUnit) {
    SOLIDSUBDIV_LONG_TEST();
    const Surface torus = Torus(16);
    const ControlMesh mesh = MakeSolidStart(torus.View(), {.n_control = 250});
    for (double unit : {std::ldexp(1., -30), std::ldexp(1., 30)}) {
        Surface scaled = torus;
        for (double& x : scaled.positions) x *= unit;
        ControlMesh other = MakeSolidStart(scaled.View(), {.n_control = 250});
        for (double& x : other.positions) x /= unit;
        EXPECT_EQ(other.hexes, mesh.hexes) << unit;
        EXPECT_EQ(other.positions, mesh.positions) << unit;
    }
}

TEST(SolidStart, DoesNotDependOnTheNumberOfThreads) {
    SOLIDSUBDIV_LONG_TEST();
    const Surface torus = Torus(16);
    const ControlMesh mesh = MakeSolidStart(torus.View(), {.n_control = 200});
    const Sdc::ThreadLimit one(1);
    const ControlMesh other = MakeSolidStart(torus.View(), {.n_control = 200});
    EXPECT_EQ(other.hexes, mesh.hexes);
    EXPECT_EQ(other.positions, mesh.positions);
}

/// Its boundary lies nearer to the target than cubes do: every vertex but few within a tenth of a cube, about.
TEST(SolidStart, BoundaryOfASphereLiesOnIt) {
    const ControlMesh mesh = MakeSolidStart(SphereAt({0, 0, 0}, 1).View(), {.n_control = 300});
    const auto refiner = Far::TopologyRefiner::Create(mesh.View(), Sdc::Split::Polyhedral);
    for (Index v : refiner.polyhedral_level(0).boundary_vertices) {
        const double* const p = &mesh.positions[3 * static_cast<std::size_t>(v)];
        // The sphere is one of triangles, 2 % inside of the round one at most; shape of cells may cost as much.
        EXPECT_NEAR(std::hypot(p[0], p[1], p[2]), 1, .04);
    }
}

std::string MessageOf(const Surface& target, const StartOptions& options = {}) {
    try {
        MakeSolidStart(target.View(), options);
    } catch (const InvalidInput& error) {
        return error.what();
    }
    return "no error";
}

TEST(SolidStart, BadTargetsAreNamed) {
    using testing::HasSubstr;
    EXPECT_THAT(MessageOf({}), HasSubstr("empty"));
    Surface open = SphereAt({0, 0, 0}, 1);
    open.triangles.resize(open.triangles.size() - 3);
    EXPECT_THAT(MessageOf(open), HasSubstr("open: 3 border edges"));
    Surface unknown = SphereAt({0, 0, 0}, 1);
    unknown.triangles[7] = 123456;
    EXPECT_THAT(MessageOf(unknown), HasSubstr("triangle 2 of the target names point 123456"));
    Surface twice = SphereAt({0, 0, 0}, 1);
    twice.triangles[0] = twice.triangles[1];
    EXPECT_THAT(MessageOf(twice), HasSubstr("triangle 0 of the target has point"));
    Surface nan = SphereAt({0, 0, 0}, 1);
    nan.positions[4] = std::nan("");
    EXPECT_THAT(MessageOf(nan), HasSubstr("point 1 of the target has the coordinate nan"));
    EXPECT_THAT(MessageOf(SphereAt({0, 0, 0}, 1e76)), HasSubstr("must be finite and at most 1e75"));
    EXPECT_THAT(MessageOf(SphereAt({0, 0, 0}, 1e-160)), HasSubstr("within 1e-75"));
    EXPECT_THAT(MessageOf(SphereAt({1, 0, 0}, 0)), HasSubstr("all at one place"));
    Surface flat = SphereAt({0, 0, 0}, 1);
    for (std::size_t i = 2; i < flat.positions.size(); i += 3) flat.positions[i] = 0;
    EXPECT_THAT(MessageOf(flat), HasSubstr("encloses nothing that is thicker than 1/128"));
    EXPECT_THAT(MessageOf(SphereAt({0, 0, 0}, 1), {.n_control = 7}), HasSubstr("n_control is 7"));
}

TEST(SolidStart, StopsWhenAsked) {
    StartOptions options;
    options.progress = [](std::string_view, double) { return false; };
    EXPECT_THROW(MakeSolidStart(SphereAt({0, 0, 0}, 1).View(), options), Cancelled);
}

}  // namespace
}  // namespace SolidSubdiv::Fit
