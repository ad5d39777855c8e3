// SPDX-License-Identifier: Apache-2.0
// Which rule governs where: rules.md section 7, case by case.
#include <gtest/gtest.h>
#include <solidsubdiv/vtr/base_level.h>

#include "test_shapes.h"

namespace {

using namespace SolidSubdiv;
using namespace SolidSubdiv::Vtr;

Level Base(Index n_vertices, const std::vector<Index>& tets, const std::vector<Index>& triangles = {},
           const std::vector<Index>& edges = {}, BaseFindings* out = nullptr) {
    BaseFindings findings;
    Level level = MakeBaseLevel({n_vertices, tets, {}, triangles, edges}, findings);
    EXPECT_TRUE(findings.IsUsable());
    if (out) *out = findings;
    return level;
}

Rule EdgeRuleOf(const Level& l, Index a, Index b) { return l.edge_tags[l.FindEdge(a, b)].rule(); }

TEST(RulesTest, InsideABlockIsSolidAndItsBoundaryIsASurface) {
    const auto block = TestShapes::KuhnBlock(2);
    const Level l = Base(block.n_vertices, block.tets);
    for (Index v = 0; v < l.n_vertices; ++v) {
        EXPECT_EQ(l.vertex_tags[v].rule(), v == 13 ? Rule::Solid : Rule::Surface) << v;
        EXPECT_FALSE(l.vertex_tags[v].non_manifold());
    }
    EXPECT_EQ(EdgeRuleOf(l, 0, 13), Rule::Solid);
    EXPECT_EQ(EdgeRuleOf(l, 0, 1), Rule::Surface);
}

TEST(RulesTest, ASingleTetIsAClosedSurface) {
    const Level l = Base(4, {0, 1, 2, 3});
    for (Index v = 0; v < 4; ++v) {
        EXPECT_EQ(l.vertex_tags[v].rule(), Rule::Surface);
        EXPECT_TRUE(l.vertex_tags[v].one_cell());
    }
    for (Index e = 0; e < 6; ++e) EXPECT_EQ(l.edge_tags[e].rule(), Rule::Surface);
}

TEST(RulesTest, WhereTetsMeetInAVertexItIsACorner) {
    const Level l = Base(7, {0, 1, 2, 3, 0, 4, 5, 6});
    EXPECT_EQ(l.vertex_tags[0].rule(), Rule::Corner);
    EXPECT_TRUE(l.vertex_tags[0].non_manifold());
    EXPECT_EQ(l.vertex_tags[1].rule(), Rule::Surface);
}

TEST(RulesTest, WhereTetsMeetInAnEdgeItIsACrease) {
    const Level l = Base(6, {0, 1, 2, 3, 0, 1, 4, 5});
    EXPECT_EQ(EdgeRuleOf(l, 0, 1), Rule::Curve);
    EXPECT_TRUE(l.edge_tags[l.FindEdge(0, 1)].non_manifold());
    // One crease ends at each of its ends: not two, so a corner.
    EXPECT_EQ(l.vertex_tags[0].rule(), Rule::Corner);
}

TEST(RulesTest, ASurfacesBorderIsACurve) {
    const Level l = Base(4, {}, {0, 1, 2, 0, 2, 3});
    EXPECT_EQ(EdgeRuleOf(l, 0, 2), Rule::Surface);
    EXPECT_EQ(EdgeRuleOf(l, 0, 1), Rule::Curve);
    for (Index v = 0; v < 4; ++v) {
        EXPECT_EQ(l.vertex_tags[v].rule(), Rule::Curve);
        EXPECT_FALSE(l.vertex_tags[v].non_manifold());
    }
}

TEST(RulesTest, AnEdgeInThreeFacesIsACurve) {
    const Level l = Base(5, {}, {0, 1, 2, 0, 1, 3, 0, 1, 4});
    EXPECT_EQ(EdgeRuleOf(l, 0, 1), Rule::Curve);
    EXPECT_TRUE(l.edge_tags[l.FindEdge(0, 1)].non_manifold());
    EXPECT_EQ(l.vertex_tags[0].rule(), Rule::Corner) << "four creases meet";
    EXPECT_EQ(l.vertex_tags[2].rule(), Rule::Curve);
}

TEST(RulesTest, TwoFansInAVertexAreACorner) {
    const Level l = Base(5, {}, {0, 1, 2, 0, 3, 4});
    EXPECT_EQ(l.vertex_tags[0].rule(), Rule::Corner);
    EXPECT_TRUE(l.vertex_tags[0].non_manifold());
}

TEST(RulesTest, CurvesAreCurvesAndEndsAndForksAreCorners) {
    const Level l = Base(6, {}, {}, {0, 1, 1, 2, 2, 3, 2, 4});
    EXPECT_EQ(l.vertex_tags[0].rule(), Rule::Corner);
    EXPECT_EQ(l.vertex_tags[1].rule(), Rule::Curve);
    EXPECT_EQ(l.vertex_tags[2].rule(), Rule::Corner);
    EXPECT_EQ(l.vertex_tags[5].rule(), Rule::Corner) << "isolated";
    EXPECT_EQ(EdgeRuleOf(l, 0, 1), Rule::Curve);
}

TEST(RulesTest, TheHighestDimensionGovernsAVertex) {
    const auto s = TestShapes::MixedDimensions();
    BaseFindings findings;
    const Level l = Base(s.n_vertices, s.tets, s.triangles, s.edges, &findings);
    EXPECT_EQ(l.vertex_tags[0].rule(), Rule::Surface) << "a sheet at the solid's surface";
    EXPECT_TRUE(l.vertex_tags[0].non_manifold());
    EXPECT_EQ(EdgeRuleOf(l, 0, 9), Rule::Curve) << "three surface faces";
    EXPECT_EQ(l.vertex_tags[13].rule(), Rule::Solid) << "a sheet at an inner vertex";
    EXPECT_TRUE(l.vertex_tags[13].non_manifold());
    EXPECT_EQ(l.vertex_tags[26].rule(), Rule::Surface) << "a rod at the solid's surface";
}

TEST(RulesTest, ATriangleOnACellIsATagAndNotAPart) {
    BaseFindings findings;
    const Level l = Base(4, {0, 1, 2, 3}, {2, 1, 0}, {3, 0}, &findings);
    EXPECT_EQ(findings.coincident_triangles.size(), 1u);
    EXPECT_EQ(findings.coincident_edges.size(), 1u);
    EXPECT_EQ(l.n_faces, 4);
    EXPECT_EQ(l.n_boundary_faces, 4);
    for (Index v = 0; v < 4; ++v) EXPECT_FALSE(l.vertex_tags[v].non_manifold());
}

TEST(RulesTest, NeighborsOrientedAgainstEachOtherAreFound) {
    BaseFindings findings;
    Base(5, {0, 1, 2, 3, 1, 2, 3, 4}, {}, {}, &findings);
    const std::size_t one_way = findings.flipped_faces.size();
    findings = {};
    Base(5, {0, 1, 2, 3, 2, 1, 3, 4}, {}, {}, &findings);
    EXPECT_EQ(one_way + findings.flipped_faces.size(), 1u);
}

TEST(RulesTest, AFaceInThreeCellsIsFound) {
    BaseFindings findings;
    MakeBaseLevel({6, std::vector<Index>{0, 1, 2, 3, 0, 1, 2, 4, 0, 1, 2, 5}, {}, {}, {}}, findings);
    EXPECT_EQ(findings.faces_in_three_cells.size(), 1u);
}

TEST(RulesTest, NumbersOfEdgesAndFacesDoNotDependOnTheOrderOfCells) {
    auto s = TestShapes::KuhnBlock(2);
    const Level a = Base(s.n_vertices, s.tets);
    std::vector<std::array<Index, 4>> cells(s.tets.size() / 4);
    for (std::size_t i = 0; i < cells.size(); ++i)
        std::copy_n(s.tets.begin() + static_cast<long>(4 * i), 4, cells[i].begin());
    TestShapes::Random(5).Shuffle(cells);
    std::vector<Index> shuffled;
    for (const auto& c : cells) shuffled.insert(shuffled.end(), c.begin(), c.end());
    const Level b = Base(s.n_vertices, shuffled);
    EXPECT_EQ(a.face_vertices, b.face_vertices);
    EXPECT_EQ(a.edge_vertices, b.edge_vertices);
    EXPECT_EQ(a.boundary_faces, b.boundary_faces);
}

}  // namespace
