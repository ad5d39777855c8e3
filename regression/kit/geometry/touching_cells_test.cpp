// SPDX-License-Identifier: Apache-2.0
// Cells that meet in an edge or a vertex only, under both splits.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <solidsubdiv/far/topology_refiner.h>
#include <solidsubdiv/kit/geometry/touching_cells.h>

#include "polyhedral_shapes.h"

namespace SolidSubdiv::Geometry {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// Edges as pairs of ends, and vertices.
struct Places {
    std::vector<std::pair<Index, Index>> edges;
    std::vector<Index> vertices;
};

template <class AnyLevel>
Places Find(const AnyLevel& level) {
    const TouchingCells found = FindTouchingCells(level);
    Places places{{}, found.vertices};
    for (Index e : found.edges) places.edges.emplace_back(level.EdgeVertices(e)[0], level.EdgeVertices(e)[1]);
    return places;
}

Places OfTets(Index n_vertices, const std::vector<Index>& tets, const std::vector<Index>& triangles = {}) {
    const auto refiner = Far::TopologyRefiner::Create({.n_vertices = n_vertices, .tets = tets, .triangles = triangles},
                                                      Sdc::Split::TetOct);
    return Find(refiner.level(0));
}

template <class Keep>
Places OfCubes(int n, Keep&& keep) {
    const auto shape = TestShapes::HexBlock(n, n, n, keep);
    const auto refiner =
        Far::TopologyRefiner::Create({.n_vertices = shape.n_vertices, .hexes = shape.hexes}, Sdc::Split::Polyhedral);
    return Find(refiner.polyhedral_level(0));
}

TEST(TouchingCells, TetsThatShareAFaceTouchNowhere) {
    const Places places = OfTets(5, {0, 1, 2, 3, 1, 2, 3, 4});
    EXPECT_THAT(places.edges, IsEmpty());
    EXPECT_THAT(places.vertices, IsEmpty());
}

TEST(TouchingCells, TetsInAnEdgeAndInAVertex) {
    const Places edge = OfTets(6, {0, 1, 2, 3, 0, 1, 4, 5});
    EXPECT_THAT(edge.edges, ElementsAre(std::pair<Index, Index>{0, 1}));
    EXPECT_THAT(edge.vertices, IsEmpty());
    const Places vertex = OfTets(7, {0, 1, 2, 3, 0, 4, 5, 6});
    EXPECT_THAT(vertex.edges, IsEmpty());
    EXPECT_THAT(vertex.vertices, ElementsAre(0));
}

TEST(TouchingCells, ASheetJoinsNoCells) {
    // The triangle has an edge of each tet.
    const Places places = OfTets(7, {0, 1, 2, 3, 0, 4, 5, 6}, {0, 1, 4});
    EXPECT_THAT(places.edges, IsEmpty());
    EXPECT_THAT(places.vertices, ElementsAre(0));
}

TEST(TouchingCells, CubesInEveryWay) {
    // A block with a hole, a cube at its outer edge from (3, 3, 1) to (3, 3, 2), one at the vertex (4, 4, 2) of that.
    const auto shape = TestShapes::TouchingCubes();
    const auto refiner =
        Far::TopologyRefiner::Create({.n_vertices = shape.n_vertices, .hexes = shape.hexes}, Sdc::Split::Polyhedral);
    const auto id = [](int x, int y, int z) { return static_cast<Index>(x + 6 * (y + 6 * z)); };
    const Places places = Find(refiner.polyhedral_level(0));
    EXPECT_THAT(places.edges, ElementsAre(std::pair{id(3, 3, 1), id(3, 3, 2)}));
    EXPECT_THAT(places.vertices, ElementsAre(id(4, 4, 2)));
}

TEST(TouchingCells, ABoardOfCubesTouchesInAllItsInnerEdges) {
    const Places places = OfCubes(2, [](int x, int y, int z) { return (x + y + z) % 2 == 0; });
    EXPECT_EQ(places.edges.size(), 6u);
    EXPECT_THAT(places.vertices, IsEmpty()) << "the edges join them in the middle";
}

}  // namespace
}  // namespace SolidSubdiv::Geometry
