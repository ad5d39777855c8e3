// SPDX-License-Identifier: Apache-2.0
// Valences and links in the tetrahedral view and of polyhedra, on cells whose neighbourhoods are known.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <solidsubdiv/far/topology_refiner.h>
#include <solidsubdiv/kit/geometry/compact_surface.h>
#include <solidsubdiv/kit/geometry/valence.h>

#include <numeric>

#include "polyhedral_shapes.h"

namespace SolidSubdiv::Geometry {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

Far::TopologyRefiner Refined(const std::vector<Index>& tets, Index n_vertices, int levels) {
    auto refiner = Far::TopologyRefiner::Create({.n_vertices = n_vertices, .tets = tets}, Sdc::Split::TetOct);
    refiner.RefineUniform({.max_level = levels, .full_topology_in_last_level = true});
    return refiner;
}

Offset Total(const Histogram& h) { return std::accumulate(h.begin(), h.end(), Offset{0}); }

TEST(Valence, OfOneTet) {
    const auto refiner = Refined({0, 1, 2, 3}, 4, 0);
    const ValenceHistograms h = MeasureValences(refiner.level(0));
    EXPECT_THAT(h.vertex_edges, ElementsAre(0, 0, 0, 4));
    EXPECT_THAT(h.surface_edges, ElementsAre(0, 0, 0, 4));
    EXPECT_THAT(h.solid_adjacent, IsEmpty());
    EXPECT_THAT(h.links, IsEmpty());
}

TEST(Valence, OfFourTetsAroundAPointInside) {
    const auto refiner = Refined({0, 1, 2, 4, 0, 3, 1, 4, 1, 3, 2, 4, 0, 2, 3, 4}, 5, 0);
    const ValenceHistograms h = MeasureValences(refiner.level(0));
    EXPECT_THAT(h.solid_adjacent, ElementsAre(0, 0, 0, 0, 1)) << "vertex 4";
    EXPECT_THAT(h.surface_edges, ElementsAre(0, 0, 0, 4)) << "edges to the point inside don't count";
    EXPECT_THAT(h.links, ElementsAre(0, 0, 0, 4)) << "four inner edges with three tets each";
}

TEST(Valence, InsideATetRefinedTwiceIsThatOfTheOctetTruss) {
    const auto refiner = Refined({0, 1, 2, 3}, 4, 2);
    const Vtr::Level& level = refiner.level(2);
    const ValenceHistograms h = MeasureValences(level);
    // The only vertex inside is the centre of the level-1 octahedron, whose neighbours are all regular.
    ASSERT_EQ(h.solid_adjacent.size(), 15u);
    EXPECT_EQ(h.solid_adjacent[14], 1);
    EXPECT_EQ(Total(h.solid_adjacent), 1);
    // Links inside the truss: 4 or 6 only, diagonals among those of 4.
    EXPECT_EQ(h.links[4] + h.links[6], Total(h.links));
    EXPECT_GE(h.links[4], level.n_octs);
    EXPECT_GT(h.links[6], 0);
    EXPECT_EQ(Total(h.vertex_edges), level.n_vertices);
}

TEST(Valence, OfHexahedraAndOfThreeWedgesAroundAnEdge) {
    const auto block = TestShapes::HexBlock(3);
    const auto hexes =
        Far::TopologyRefiner::Create({.n_vertices = block.n_vertices, .hexes = block.hexes}, Sdc::Split::Polyhedral);
    const ValenceHistograms h = MeasureValences(hexes.polyhedral_level(0));
    EXPECT_THAT(h.solid_adjacent, ElementsAre(0, 0, 0, 0, 0, 0, 8));
    EXPECT_THAT(h.surface_edges, ElementsAre(0, 0, 0, 8, 48));
    EXPECT_THAT(h.links, ElementsAre(0, 0, 0, 0, 3 * 4 * 3));

    // Vertices 0 and 4 are the axis.
    const std::vector<Index> wedges{0, 1, 2, 4, 5, 6, 0, 2, 3, 4, 6, 7, 0, 3, 1, 4, 7, 5};
    const auto prism = Far::TopologyRefiner::Create({.n_vertices = 8, .wedges = wedges}, Sdc::Split::Polyhedral);
    const ValenceHistograms around = MeasureValences(prism.polyhedral_level(0));
    EXPECT_THAT(around.links, ElementsAre(0, 0, 0, 1));
    EXPECT_THAT(around.surface_edges, ElementsAre(0, 0, 0, 2, 6)) << "the axis is no edge of the surface";
    EXPECT_THAT(around.vertex_edges, ElementsAre(0, 0, 0, 0, 8));
    EXPECT_THAT(around.solid_adjacent, IsEmpty());
}

TEST(CompactSurface, BoundaryOfALevelKeepsItsTrianglesOverItsOwnVertices) {
    const auto refiner = Refined({0, 1, 2, 4, 0, 3, 1, 4, 1, 3, 2, 4, 0, 2, 3, 4}, 6, 1);  // vertex 5 is isolated
    const Vtr::Level& level = refiner.level(1);
    const CompactSurface surface = ExtractBoundary(level);
    EXPECT_EQ(surface.corners.size(), 3u * 16u);
    EXPECT_EQ(surface.vertices.size(), 10u);
    EXPECT_TRUE(std::is_sorted(surface.vertices.begin(), surface.vertices.end()));
    std::vector<double> positions(3 * static_cast<std::size_t>(level.n_vertices));
    std::iota(positions.begin(), positions.end(), 0.0);
    const std::vector<double> own = GatherRows(positions, 3, surface.vertices);
    for (std::size_t i = 0; i < surface.corners.size(); ++i) {
        EXPECT_EQ(surface.vertices[surface.corners[i]], level.boundary_vertices[i]);
        for (int axis = 0; axis < 3; ++axis) {
            EXPECT_EQ(own[3 * surface.corners[i] + axis], positions[3 * level.boundary_vertices[i] + axis]);
        }
    }
}

TEST(CompactSurface, BoundaryWithoutSomeOfItsFaces) {
    // A pentagon and two triangles in a row, of which the first triangle is left out.
    const std::vector<Offset> offsets{0, 5};
    const std::vector<Index> pentagon{0, 1, 2, 3, 4}, triangles{1, 0, 5, 0, 6, 5};
    const auto refiner = Far::TopologyRefiner::Create(
        {.n_vertices = 7, .triangles = triangles, .polygon_offsets = offsets, .polygon_vertices = pentagon},
        Sdc::Split::Polyhedral);
    const Vtr::PolyhedralLevel& level = refiner.polyhedral_level(0);
    std::vector<bool> is_left_out;
    for (Index b = 0; b < level.n_boundary_faces; ++b) {
        const auto v = level.BoundaryVertices(b);
        is_left_out.push_back(std::count(v.begin(), v.end(), 1) > 0 && v.size() == 3);
    }
    const BoundarySurface surface = ExtractBoundary(level, is_left_out);
    EXPECT_THAT(surface.vertices, ElementsAre(0, 1, 2, 3, 4, 5, 6)) << "both faces that stay have all of them";
    ASSERT_EQ(surface.rows.offsets.size(), 3u);
    EXPECT_EQ(surface.corners.size(), 5u + 3u);
    EXPECT_EQ(surface.rows.Count(0) + surface.rows.Count(1), 8);
    const BoundarySurface whole = ExtractBoundary(level);
    EXPECT_EQ(whole.corners.size(), 5u + 3u + 3u);
    EXPECT_EQ(whole.rows.offsets.size(), 4u);
}

}  // namespace
}  // namespace SolidSubdiv::Geometry
