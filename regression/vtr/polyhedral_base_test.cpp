// SPDX-License-Identifier: Apache-2.0
// Level 0 of polyhedra: tags, independence of order, and what is wrong with cells.
#include <algorithm>

#include <gtest/gtest.h>
#include <solidsubdiv/vtr/polyhedral_base.h>
#include <solidsubdiv/vtr/polyhedral_refinement.h>

#include "polyhedral_shapes.h"

namespace SolidSubdiv {
namespace {

using TestShapes::PolyhedralShape;
using Vtr::PolyhedralLevel;

PolyhedralLevel Base(const PolyhedralShape& s, Vtr::PolyhedralFindings* out = nullptr) {
    Vtr::PolyhedralFindings findings;
    PolyhedralLevel level = Vtr::MakePolyhedralBaseLevel(s.Elements(), findings);
    EXPECT_TRUE(out != nullptr || findings.IsUsable());
    if (out) *out = findings;
    return level;
}

TEST(PolyhedralBase, DoesNotDependOnTheOrderOfCells) {
    const PolyhedralShape shape = TestShapes::TouchingCubes();
    PolyhedralShape shuffled = shape;
    std::vector<std::array<Index, 8>> cells(shape.hexes.size() / 8);
    for (std::size_t c = 0; c < cells.size(); ++c) std::copy_n(shape.hexes.begin() + 8 * c, 8, cells[c].begin());
    TestShapes::Random(5).Shuffle(cells);
    shuffled.hexes.clear();
    for (const auto& c : cells) shuffled.hexes.insert(shuffled.hexes.end(), c.begin(), c.end());
    const PolyhedralLevel a = Base(shape), b = Base(shuffled);
    EXPECT_EQ(a.edge_vertices, b.edge_vertices);
    EXPECT_EQ(a.face_vertices, b.face_vertices);
    EXPECT_EQ(a.boundary_vertices, b.boundary_vertices);
    EXPECT_EQ(a.edge_tags, b.edge_tags);
    EXPECT_EQ(a.vertex_tags, b.vertex_tags);
}

TEST(PolyhedralBase, TagsCornersEdgesAndTouchingPlaces) {
    const PolyhedralLevel level = Base(TestShapes::HexBlock(2));
    int corners = 0, sharp = 0, inner = 0;
    for (Vtr::Tag t : level.vertex_tags) {
        corners += t.one_cell();
        inner += t.rule() == Vtr::Rule::Solid;
        EXPECT_FALSE(t.non_manifold());
    }
    for (Vtr::Tag t : level.edge_tags) sharp += t.one_cell();
    EXPECT_EQ(corners, 8);
    EXPECT_EQ(sharp, 24);
    EXPECT_EQ(inner, 1);

    // Two cubes that touch in an edge: it follows the curve rule, its ends stay; in a vertex: it stays.
    const auto touching = [](int x, int y, int z) { return x == y && z < 1; };
    const PolyhedralLevel by_edge = Base(TestShapes::HexBlock(2, 2, 1, touching));
    const Index edge = by_edge.FindEdge(4, 13);
    ASSERT_NE(edge, kNoIndex);
    EXPECT_EQ(by_edge.edge_tags[edge].rule(), Vtr::Rule::Curve);
    EXPECT_TRUE(by_edge.edge_tags[edge].non_manifold());
    EXPECT_EQ(by_edge.vertex_tags[4].rule(), Vtr::Rule::Corner);
    const PolyhedralLevel by_vertex =
        Base(TestShapes::HexBlock(2, 2, 2, [](int x, int y, int z) { return x == y && y == z; }));
    EXPECT_EQ(by_vertex.vertex_tags[13].rule(), Vtr::Rule::Corner);
    EXPECT_TRUE(by_vertex.vertex_tags[13].non_manifold());
}

TEST(PolyhedralBase, FindsWhatIsWrong) {
    const auto findings_of = [](const PolyhedralShape& s) {
        Vtr::PolyhedralFindings findings;
        Base(s, &findings);
        return findings;
    };
    PolyhedralShape three = TestShapes::HexBlock(1);
    for (int i = 0; i < 2; ++i) {
        const Index apex = three.AddVertex(0.5, 0.5, 2 + i);
        three.AddCell(Sdc::Pyramid::faces, std::array<Index, 5>{4, 5, 7, 6, apex});
    }
    EXPECT_EQ(findings_of(three).faces_in_three_cells.size(), 1u);

    PolyhedralShape twice = TestShapes::HexBlock(1);
    twice.hexes.insert(twice.hexes.end(), {0, 1, 3, 2, 4, 5, 7, 6});
    EXPECT_EQ(findings_of(twice).duplicate_cells, std::vector<Index>{1});

    PolyhedralShape open;
    for (int i = 0; i < 5; ++i) open.AddVertex(i % 2, i / 2, i == 4);
    open.AddCell(std::vector<std::vector<Index>>{{0, 2, 3, 1}, {0, 1, 4}, {1, 3, 4}, {3, 2, 4}},
                 std::array<Index, 5>{0, 1, 2, 3, 4});
    EXPECT_EQ(findings_of(open).open_cells, std::vector<Index>{0});

    PolyhedralShape pinched;  // two tets that share a vertex, given as one cell
    for (int i = 0; i < 7; ++i) pinched.AddVertex(i, i * i, i * i * i);
    pinched.AddCell(
        std::vector<std::vector<Index>>{
            {1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}, {4, 5, 6}, {0, 6, 5}, {0, 4, 6}, {0, 5, 4}},
        std::array<Index, 7>{0, 1, 2, 3, 4, 5, 6});
    EXPECT_EQ(findings_of(pinched).open_cells, std::vector<Index>{0});

    PolyhedralShape nothing, pillow;
    nothing.AddCell(std::vector<std::vector<Index>>{}, std::span<const Index>());
    EXPECT_EQ(findings_of(nothing).open_cells, std::vector<Index>{0});
    for (int i = 0; i < 4; ++i) pillow.AddVertex(i, i * i, 0);
    pillow.AddCell(std::vector<std::vector<Index>>{{0, 1, 2, 3}, {3, 2, 1, 0}}, std::array<Index, 4>{0, 1, 2, 3});
    EXPECT_EQ(findings_of(pillow).open_cells, std::vector<Index>{0});

    PolyhedralShape twisted = TestShapes::HexBlock(1);
    twisted.AddPolygon({4, 5, 6, 7});  // around the face they stand in the order 4 5 7 6
    EXPECT_EQ(findings_of(twisted).twisted_faces.size(), 1u);

    PolyhedralShape tags = TestShapes::HexBlock(1);
    tags.AddPolygon({4, 5, 7, 6});
    tags.edges = {0, 1};
    EXPECT_EQ(findings_of(tags).coincident_polygons, std::vector<Index>{0});
    EXPECT_EQ(findings_of(tags).coincident_edges, std::vector<Index>{0});
    EXPECT_TRUE(findings_of(tags).IsUsable());
    tags.AddPolygon({5, 4, 6, 7});
    tags.edges = {0, 3, 3, 0};
    EXPECT_EQ(findings_of(tags).duplicate_polygons, std::vector<Index>{1});
    EXPECT_EQ(findings_of(tags).duplicate_edges, std::vector<Index>{1});

    PolyhedralShape flipped = TestShapes::HexBlock(2, 1, 1, [](int, int, int) { return true; });
    for (int i = 0; i < 4; ++i) std::swap(flipped.hexes[8 + i], flipped.hexes[12 + i]);
    EXPECT_EQ(findings_of(flipped).flipped_faces.size(), 1u);
    EXPECT_TRUE(findings_of(flipped).IsUsable());
    Vtr::PolyhedralFindings ignored;  // it refines like any other
    EXPECT_EQ(Refine(Base(flipped, &ignored), true).n_hexes, 16);
}

}  // namespace
}  // namespace SolidSubdiv
