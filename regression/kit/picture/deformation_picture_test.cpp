// SPDX-License-Identifier: Apache-2.0
// The picture of a deformation: panels that compare, lattices with what is inside them, clouds of points.
#include <gtest/gtest.h>
#include <solidsubdiv/kit/picture/cut.h>
#include <solidsubdiv/kit/picture/deformation_picture.h>
#include <solidsubdiv/sdc/errors.h>

#include "kit/picture/picture_testing.h"
#include "kit/picture/solid_testing.h"

namespace SolidSubdiv::Picture {
namespace {

constexpr int kWidth = 120, kHeight = 100;
const DeformationPictureOptions kSmall{.render = {.width = kWidth, .height = kHeight, .samples = 4, .light_rays = 0},
                                       .panels = {.gap = 0}};

Io::Mesh Ball(double radius) {
    const Triangles sphere = MakeSphere(2, radius);
    Io::Mesh mesh;
    mesh.positions = sphere.positions;
    mesh.topology.n_vertices = static_cast<Index>(sphere.positions.size() / 3);
    mesh.topology.triangles = sphere.triangles;
    return mesh;
}

Io::Mesh Box(double half) {
    Io::Mesh mesh;
    for (int i = 0; i < 8; ++i) {
        const bool right = i % 4 == 1 || i % 4 == 2, far = i % 4 >= 2, high = i >= 4;
        for (bool is_high : {right, far, high}) mesh.positions.push_back(is_high ? half : -half);
    }
    mesh.topology.n_vertices = 8;
    mesh.topology.hexes = {0, 1, 2, 3, 4, 5, 6, 7};
    return mesh;
}

/// Pixels of a part of the picture for which is(color) holds.
template <class Is>
int Count(const Image& image, int left, int top, int width, int height, Is&& is) {
    int n = 0;
    for (int y = top; y < top + height; ++y) {
        for (int x = left; x < left + width; ++x) n += is(image.At(x, y)) ? 1 : 0;
    }
    return n;
}
bool IsRed(Color c) { return c.r > c.b + 0.15f && c.r > c.g + 0.15f; }
bool IsDrawn(Color c) { return c.g < 0.98f; }

TEST(DeformationPictureTest, PanelsStandSideBySideUnderOneCamera) {
    const Io::Mesh ball = Ball(1), small = Ball(0.5), box = Box(1.2);
    const DeformationState states[] = {{&ball, &box, "at rest"}, {&small, &box, "small"}, {&ball, nullptr, "alone"}};
    const Image image = DeformationPicture(states, kSmall);
    ASSERT_EQ(image.width(), 3 * kWidth);
    ASSERT_GT(image.height(), kHeight);  // captions
    EXPECT_GT(Count(image, 0, 0, kWidth, kHeight, IsRed), 200);
    EXPECT_GT(Count(image, kWidth, 0, kWidth, kHeight, IsRed), 200);
    EXPECT_EQ(Count(image, 2 * kWidth, 0, kWidth, kHeight, IsRed), 0);
    // Half the radius, a quarter of the area: where no lattice hides it.
    const DeformationState bare[] = {{&ball, nullptr, ""}, {&small, nullptr, ""}};
    const Image balls = DeformationPicture(bare, kSmall);
    const auto no_shadow = [](Color c) { return IsDrawn(c) && c.b > c.r + 0.02f; };  // of which the light has no colour
    const double whole = Count(balls, 0, 0, kWidth, kHeight, no_shadow);
    EXPECT_NEAR(Count(balls, kWidth, 0, kWidth, kHeight, no_shadow) / whole, 0.25, 0.03);  // pixels at the rim
}

TEST(DeformationPictureTest, EdgesInsideTheLatticeAreSeen) {
    Io::Mesh lattice;  // an octahedron, and the same cut into four tets along its upright diagonal
    lattice.positions = {0, -1, 0, 0, 1, 0, 1, 0, 0, -1, 0, 0, 0, 0, 1, 0, 0, -1};
    lattice.topology.n_vertices = 6;
    lattice.topology.octs = {0, 1, 2, 3, 4, 5};
    Io::Mesh cut = lattice, corners = lattice;
    cut.topology.octs.clear();
    cut.topology.tets = {0, 1, 2, 4, 0, 1, 4, 3, 0, 1, 3, 5, 0, 1, 5, 2};
    corners.topology.octs.clear();
    const auto n_in_the_middle = [&](const Io::Mesh& shown) {
        const DeformationState state[] = {{&corners, &shown, ""}};
        return Count(DeformationPicture(state, kSmall), kWidth / 2 - 3, kHeight / 2 - 3, 6, 6, IsRed);
    };
    EXPECT_EQ(n_in_the_middle(lattice), 0);
    EXPECT_GT(n_in_the_middle(cut), 8);
}

TEST(DeformationPictureTest, LatticesOfManyEdgesAreSeenFromOutside) {
    const auto looks_like_its_boundary = [](int n) {
        const Io::Mesh block = TetBlock(n);
        Io::Mesh boundary = block, model = block;
        boundary.topology.tets.clear();
        boundary.topology.triangles = SolidBoundary(block).triangles;
        model.topology.tets.clear();
        const DeformationState whole[] = {{&model, &block, ""}}, outside[] = {{&model, &boundary, ""}};
        return DifferentPixels(DeformationPicture(whole, kSmall), DeformationPicture(outside, kSmall)) == 0;
    };
    EXPECT_FALSE(looks_like_its_boundary(2));  // 98 edges
    EXPECT_TRUE(looks_like_its_boundary(4));   // 604
}

TEST(DeformationPictureTest, PointsWithoutFacesAreBalls) {
    Io::Mesh cloud = Ball(1);
    cloud.topology.triangles.clear();
    const DeformationState state[] = {{&cloud, nullptr, ""}};
    const int n_drawn = Count(DeformationPicture(state, kSmall), 0, 0, kWidth, kHeight, IsDrawn);
    EXPECT_GT(n_drawn, 66);  // a pixel for each of the 66
    EXPECT_LT(n_drawn, kWidth * kHeight / 3);
}

TEST(DeformationPictureTest, NothingToShowIsRefused) {
    const Io::Mesh ball = Ball(1);
    EXPECT_THROW(DeformationPicture({}, kSmall), InvalidInput);
    const DeformationState states[] = {{&ball, nullptr, ""}, {nullptr, &ball, ""}};
    EXPECT_THROW(DeformationPicture(states, kSmall), InvalidInput);
}

}  // namespace
}  // namespace SolidSubdiv::Picture
