// SPDX-License-Identifier: Apache-2.0
// Pieces of surfaces: spheres, tori, discs and what is no manifold are told apart.
#include <gtest/gtest.h>
#include <solidsubdiv/kit/geometry/surface_components.h>

namespace SolidSubdiv::Geometry {
namespace {

const std::vector<Index> kTetrahedron = {0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2};

/// An m by n grid of squares cut in two, closed in both directions if asked to.
std::vector<Index> Grid(int m, int n, bool closed, Index first = 0) {
    const int rows = closed ? m : m + 1, columns = closed ? n : n + 1;
    const auto at = [&](int i, int j) { return static_cast<Index>(first + (i % rows) * columns + j % columns); };
    std::vector<Index> triangles;
    for (int i = 0; i < m; ++i) {
        for (int j = 0; j < n; ++j) {
            triangles.insert(triangles.end(), {at(i, j), at(i + 1, j), at(i + 1, j + 1)});
            triangles.insert(triangles.end(), {at(i, j), at(i + 1, j + 1), at(i, j + 1)});
        }
    }
    return triangles;
}

TEST(SurfaceComponents, SphereHasCharacteristicTwoAndNoHandle) {
    const auto pieces = SurfaceComponents(kTetrahedron, 4);
    ASSERT_EQ(pieces.size(), 1u);
    EXPECT_EQ(pieces[0].n_vertices, 4);
    EXPECT_EQ(pieces[0].n_edges, 6);
    EXPECT_EQ(pieces[0].n_faces, 4);
    EXPECT_EQ(pieces[0].EulerCharacteristic(), 2);
    EXPECT_TRUE(pieces[0].IsManifold());
    EXPECT_TRUE(pieces[0].IsClosed());
    EXPECT_EQ(pieces[0].Genus(), 0);
}

TEST(SurfaceComponents, TorusHasCharacteristicZeroAndOneHandle) {
    const auto pieces = SurfaceComponents(Grid(4, 5, true), 20);
    ASSERT_EQ(pieces.size(), 1u);
    EXPECT_EQ(pieces[0].EulerCharacteristic(), 0);
    EXPECT_TRUE(pieces[0].IsClosed());
    EXPECT_EQ(pieces[0].Genus(), 1);
}

TEST(SurfaceComponents, DiscHasOneBorderAndARingTwo) {
    const auto disc = SurfaceComponents(Grid(3, 3, false), 16);
    ASSERT_EQ(disc.size(), 1u);
    EXPECT_EQ(disc[0].EulerCharacteristic(), 1);
    EXPECT_EQ(disc[0].n_border_edges, 12);
    EXPECT_EQ(disc[0].n_border_loops, 1);
    EXPECT_EQ(disc[0].Genus(), 0);

    std::vector<Index> ring = Grid(3, 3, false);
    ring.erase(ring.begin() + 24, ring.begin() + 30);  // the square in the middle
    const auto pieces = SurfaceComponents(ring, 16);
    ASSERT_EQ(pieces.size(), 1u);
    EXPECT_EQ(pieces[0].EulerCharacteristic(), 0);
    EXPECT_EQ(pieces[0].n_border_loops, 2);
    EXPECT_EQ(pieces[0].Genus(), 0);
}

TEST(SurfaceComponents, LargestPieceComesFirstAndUnusedVerticesDoNotCount) {
    std::vector<Index> triangles = kTetrahedron;
    const std::vector<Index> torus = Grid(3, 3, true, 10);
    triangles.insert(triangles.end(), torus.begin(), torus.end());
    const auto pieces = SurfaceComponents(triangles, 30);
    ASSERT_EQ(pieces.size(), 2u);
    EXPECT_EQ(pieces[0].n_faces, 18);
    EXPECT_EQ(pieces[0].n_vertices, 9);
    EXPECT_EQ(pieces[0].Genus(), 1);
    EXPECT_EQ(pieces[1].n_faces, 4);
    EXPECT_EQ(pieces[1].n_vertices, 4);
}

TEST(SurfaceComponents, TwoTetsThatTouchInAVertexAreOnePieceThatIsNoManifoldThere) {
    std::vector<Index> triangles = kTetrahedron;
    for (Index v : kTetrahedron) triangles.push_back(v == 0 ? 0 : v + 3);
    const auto pieces = SurfaceComponents(triangles, 7);
    ASSERT_EQ(pieces.size(), 1u);
    EXPECT_EQ(pieces[0].n_non_manifold_vertices, 1);
    EXPECT_EQ(pieces[0].n_non_manifold_edges, 0);
    EXPECT_FALSE(pieces[0].Genus().has_value());
}

TEST(SurfaceComponents, ThreeTrianglesAtAnEdgeAreCounted) {
    const auto pieces = SurfaceComponents(std::vector<Index>{0, 1, 2, 1, 0, 3, 0, 1, 4}, 5);
    ASSERT_EQ(pieces.size(), 1u);
    EXPECT_EQ(pieces[0].n_non_manifold_edges, 1);
    EXPECT_EQ(pieces[0].n_edges, 7);
    EXPECT_FALSE(pieces[0].Genus().has_value());
}

TEST(SurfaceComponents, ATurnedTriangleFlipsItsEdgesAndIsNoFanOfItsOwn) {
    std::vector<Index> triangles = kTetrahedron;
    std::swap(triangles[0], triangles[1]);
    const auto pieces = SurfaceComponents(triangles, 4);
    ASSERT_EQ(pieces.size(), 1u);
    EXPECT_EQ(pieces[0].n_flipped_edges, 3);
    EXPECT_EQ(pieces[0].n_non_manifold_vertices, 0);
    EXPECT_TRUE(pieces[0].IsManifold());
    EXPECT_FALSE(pieces[0].Genus().has_value());
}

TEST(SurfaceComponents, PolygonsAreFacesOfAnySize) {
    // A prism over a pentagon; then without its lid.
    std::vector<Offset> offsets{0, 5, 10};
    std::vector<Index> corners{4, 3, 2, 1, 0, 5, 6, 7, 8, 9};
    for (Index i = 0; i < 5; ++i) {
        const Index next = (i + 1) % 5;
        corners.insert(corners.end(), {i, next, next + 5, i + 5});
        offsets.push_back(static_cast<Offset>(corners.size()));
    }
    const auto prism = SurfaceComponents(offsets, corners, 10);
    ASSERT_EQ(prism.size(), 1u);
    EXPECT_EQ(prism[0].n_faces, 7);
    EXPECT_EQ(prism[0].n_edges, 15);
    EXPECT_EQ(prism[0].EulerCharacteristic(), 2);
    EXPECT_EQ(prism[0].Genus(), 0);
    EXPECT_TRUE(prism[0].IsClosed());

    offsets.erase(offsets.begin() + 1);
    for (Offset& offset : offsets) offset = std::max<Offset>(0, offset - 5);
    corners.erase(corners.begin(), corners.begin() + 5);
    const auto open = SurfaceComponents(offsets, corners, 10);
    ASSERT_EQ(open.size(), 1u);
    EXPECT_EQ(open[0].n_border_edges, 5);
    EXPECT_EQ(open[0].EulerCharacteristic(), 1);
    EXPECT_EQ(open[0].n_border_loops, 1);
}

TEST(SurfaceComponents, NothingHasNoPieces) { EXPECT_TRUE(SurfaceComponents(std::vector<Index>{}, 3).empty()); }

}  // namespace
}  // namespace SolidSubdiv::Geometry
