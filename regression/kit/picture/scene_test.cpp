// SPDX-License-Identifier: Apache-2.0
// What a scene refuses, and the normals of smooth shading.
#include "kit/picture/picture_testing.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <solidsubdiv/kit/picture/internal/corner_normals.h>
#include <solidsubdiv/sdc/errors.h>

#include <string>

namespace SolidSubdiv::Picture {
namespace {

using Internal::CornerNormals;
using Internal::Vec3d;
using Internal::Vec3f;
using testing::HasSubstr;

template <class Added>
std::string Refusal(const Added& added) {
    Scene scene;
    try {
        scene.Add(added);
    } catch (const InvalidInput& error) {
        EXPECT_TRUE(scene.IsEmpty());
        return error.what();
    }
    return "taken";
}

TEST(SceneTest, BadInputIsRefusedByNameAndPlace) {
    const std::vector<double> p = {0, 0, 0, 1, 0, 0, 0, 1, 0}, broken = {0, 0, 0, 1, 0, 0, 0, NAN, 0};
    const std::vector<Index> t = {0, 1, 2}, outside = {0, 1, 2, 0, 3, 1}, negative = {0, -1, 2};
    const std::vector<double> two = {1, 2};
    const std::vector<Color> colors(2);
    EXPECT_EQ(Refusal(Surface{.positions = p, .triangles = t}), "taken");
    EXPECT_THAT(Refusal(Surface{.positions = p, .triangles = outside}), HasSubstr("triangle 1 names point 3 of 3"));
    EXPECT_THAT(Refusal(Surface{.positions = p, .triangles = negative}), HasSubstr("triangle 0 names point -1 of 3"));
    EXPECT_THAT(Refusal(Surface{.positions = broken, .triangles = t}), HasSubstr("point 2, coordinate 1: nan"));
    EXPECT_THAT(Refusal(Surface{.positions = two, .triangles = {}}), HasSubstr("2 numbers are not triples"));
    EXPECT_THAT(Refusal(Surface{.positions = p, .triangles = std::span(t).first(2)}),
                HasSubstr("2 indices are not rows of 3"));
    EXPECT_THAT(Refusal(Surface{.positions = p, .triangles = t, .values = two}), HasSubstr("values: 2 for 3 points"));
    EXPECT_THAT(Refusal(Surface{.positions = p, .triangles = t, .triangle_colors = colors}),
                HasSubstr("2 for 1 triangles"));
    EXPECT_THAT(Refusal(Surface{.positions = p, .triangles = t, .material = {.crease_angle = 181}}),
                HasSubstr("crease_angle: 181"));
    EXPECT_THAT(Refusal(Surface{.positions = p, .triangles = t, .material = {.gloss = -1}}), HasSubstr("gloss: -1"));
    EXPECT_THAT(Refusal(Surface{.positions = p, .triangles = t, .material = {.stripes = 1001}}),
                HasSubstr("stripes: 1001"));
    EXPECT_THAT(Refusal(Surface{.positions = p, .triangles = t, .low = NAN}), HasSubstr("range of values"));
    EXPECT_THAT(Refusal(Lines{.positions = p, .edges = std::span(outside).subspan(2)}),
                HasSubstr("edge 1 names point 3 of 3"));
    EXPECT_THAT(Refusal(Lines{.positions = p, .edges = {}, .width = 0}), HasSubstr("line width: 0 pixels"));
    EXPECT_THAT(Refusal(Points{.positions = broken}), HasSubstr("point 2"));
    EXPECT_THAT(Refusal(Points{.positions = p, .diameter = NAN}), HasSubstr("point diameter"));
}

TEST(SceneTest, ArraysAreCopied) {
    Scene scene;
    {
        Triangles square = MakeSquare(0);
        scene.Add(Surface{.positions = square.positions, .triangles = square.triangles});
        for (double& x : square.positions) x = 1e9;
    }
    const Triangles same = MakeSquare(0);
    Scene fresh;
    fresh.Add(Surface{.positions = same.positions, .triangles = same.triangles});
    const RenderOptions options{.width = 40, .height = 40};
    EXPECT_EQ(Render(scene, View{}, options), Render(fresh, View{}, options));
}

std::vector<Vec3d> Points3(const std::vector<double>& p) {
    std::vector<Vec3d> points;
    for (std::size_t i = 0; i < p.size(); i += 3) points.push_back({p[i], p[i + 1], p[i + 2]});
    return points;
}

/// The cube [-1, 1]^3, each side cut by one or the other diagonal.
Triangles Cube() {
    Triangles cube;
    for (int i = 0; i < 8; ++i) {
        for (int bit : {1, 2, 4}) cube.positions.push_back((i & bit) != 0 ? 1 : -1);
    }
    cube.triangles = {0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4,
                      2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5};
    return cube;
}

TEST(CornerNormalsTest, ACubeKeepsItsSidesBelowTheCreaseAngleAndRoundsItsCornersAbove) {
    const Triangles cube = Cube();
    const std::vector<Vec3d> points = Points3(cube.positions);
    const std::vector<Vec3f> sharp = CornerNormals(points, cube.triangles, 89),
                             round = CornerNormals(points, cube.triangles, 91);
    for (std::size_t c = 0; c < cube.triangles.size(); ++c) {
        const std::size_t t = c - c % 3;
        const auto corner = [&](std::size_t i) { return points[static_cast<std::size_t>(cube.triangles[i])]; };
        const Vec3d side = Unit(Cross(corner(t + 1) - corner(t), corner(t + 2) - corner(t)));
        EXPECT_GT(Dot(side, corner(t)), 0.9);  // the cube faces outwards
        EXPECT_NEAR(Dot(static_cast<Vec3d>(sharp[c]), side), 1, 1e-6);
        // By angles, not triangles: the corner's diagonal, however the sides are cut.
        EXPECT_NEAR(Dot(static_cast<Vec3d>(round[c]), Unit(corner(c))), 1, 1e-6);
    }
}

TEST(CornerNormalsTest, ASpheresNormalsPointOutFromItsCentre) {
    const Triangles sphere = MakeSphere(4);
    const std::vector<Vec3d> points = Points3(sphere.positions);
    const std::vector<Vec3f> normals = CornerNormals(points, sphere.triangles, 40);
    for (std::size_t c = 0; c < normals.size(); ++c) {
        // Second order in the triangles' size, which is about 0.1.
        EXPECT_GT(Dot(static_cast<Vec3d>(normals[c]), points[static_cast<std::size_t>(sphere.triangles[c])]), 1 - 1e-4);
    }
}

TEST(CornerNormalsTest, TrianglesWithoutAreaDoNoHarm) {
    const std::vector<Vec3d> points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.5, 0, 0}};
    const std::vector<Index> triangles = {0, 1, 2, 0, 1, 3, 2, 2, 2};
    const std::vector<Vec3f> normals = CornerNormals(points, triangles, 40);
    for (std::size_t c = 0; c < 3; ++c) EXPECT_EQ(normals[c].z, 1.f);
    for (const Vec3f& n : normals) EXPECT_TRUE(std::isfinite(n.x) && std::isfinite(n.y) && std::isfinite(n.z));
}

}  // namespace
}  // namespace SolidSubdiv::Picture
