// SPDX-License-Identifier: Apache-2.0
// A refined level is the level that would be built from its own cells: tables, tags and relations.
#include <algorithm>
#include <map>

#include <gtest/gtest.h>
#include <solidsubdiv/sdc/parallel.h>
#include <solidsubdiv/vtr/base_level.h>
#include <solidsubdiv/vtr/refinement.h>

#include "test_shapes.h"

namespace {

using namespace SolidSubdiv;
using namespace SolidSubdiv::Vtr;
using TestShapes::Shape;

Level Base(const Shape& s) {
    BaseFindings findings;
    Level level = MakeBaseLevel({s.n_vertices, s.tets, s.octs, s.triangles, s.edges}, findings);
    EXPECT_TRUE(findings.IsUsable());
    return level;
}

/// What stays of a level when its edges and faces are found anew from cells, free triangles and free edges.
Level Rebuild(const Level& level) {
    Shape s;
    s.n_vertices = level.n_vertices;
    s.tets.assign(level.tet_vertices.begin(), level.tet_vertices.end());
    s.octs.assign(level.oct_vertices.begin(), level.oct_vertices.end());
    for (Index b = 0; b < level.n_boundary_faces; ++b) {
        if (level.face_tags[level.boundary_faces[b]].n_cells() > 0) continue;
        for (Index v : level.BoundaryVertices(b)) s.triangles.push_back(v);
    }
    for (Index e = 0; e < level.n_edges; ++e) {
        if (level.edge_faces.Count(e) > 0) continue;
        for (Index v : level.EdgeVertices(e)) s.edges.push_back(v);
    }
    return Base(s);
}

template <std::size_t N>
std::vector<std::array<Index, N>> Tuples(const Array<Index>& rows) {
    std::vector<std::array<Index, N>> tuples(rows.size() / N);
    for (std::size_t i = 0; i < tuples.size(); ++i)
        std::copy_n(rows.begin() + static_cast<long>(i * N), N, tuples[i].begin());
    return tuples;
}

/// For each tuple of `from`, its place in `to`.
template <std::size_t N>
std::vector<Index> Map(const Array<Index>& from, const Array<Index>& to) {
    std::map<std::array<Index, N>, Index> place;
    const auto targets = Tuples<N>(to);
    for (std::size_t i = 0; i < targets.size(); ++i) place[targets[i]] = static_cast<Index>(i);
    std::vector<Index> map;
    for (const auto& t : Tuples<N>(from)) {
        const auto found = place.find(t);
        map.push_back(found == place.end() ? kNoIndex : found->second);
    }
    EXPECT_EQ(std::count(map.begin(), map.end(), kNoIndex), 0);
    EXPECT_EQ(from.size(), to.size());
    return map;
}

Array<Index> Through(const std::vector<Index>& map, const Array<Index>& values) {
    Array<Index> out;
    for (Index v : values) out.push_back(map[v]);
    return out;
}

void ExpectSameRelation(const Relation& a, const Relation& b, const std::vector<Index>& rows,
                        const std::vector<Index>& items) {
    for (Index i = 0; i < static_cast<Index>(rows.size()); ++i) {
        std::vector<Index> mine;
        for (Index item : a[i]) mine.push_back(items.empty() ? item : items[item]);
        std::sort(mine.begin(), mine.end());
        const auto other = b[rows[i]];
        ASSERT_EQ(mine, std::vector<Index>(other.begin(), other.end()));
    }
}

void ExpectSameLevel(const Level& level, const Level& rebuilt) {
    ASSERT_EQ(CountsOf(level), CountsOf(rebuilt));
    const std::vector<Index> edges = Map<2>(level.edge_vertices, rebuilt.edge_vertices);
    const std::vector<Index> faces = Map<3>(level.face_vertices, rebuilt.face_vertices);
    EXPECT_EQ(Through(edges, level.tet_edges), rebuilt.tet_edges);
    EXPECT_EQ(Through(edges, level.oct_edges), rebuilt.oct_edges);
    EXPECT_EQ(Through(faces, level.tet_faces), rebuilt.tet_faces);
    EXPECT_EQ(Through(faces, level.oct_faces), rebuilt.oct_faces);
    for (Index f = 0; f < level.n_faces; ++f) {
        for (int k = 0; k < 3; ++k) ASSERT_EQ(edges[level.FaceEdges(f)[k]], rebuilt.FaceEdges(faces[f])[k]);
        ASSERT_EQ(level.face_tags[f].bits, rebuilt.face_tags[faces[f]].bits) << f;
    }
    for (Index e = 0; e < level.n_edges; ++e) {
        ASSERT_EQ(int{level.edge_tags[e].bits}, int{rebuilt.edge_tags[edges[e]].bits}) << "edge " << e;
    }
    for (Index v = 0; v < level.n_vertices; ++v) {
        ASSERT_EQ(int{level.vertex_tags[v].bits}, int{rebuilt.vertex_tags[v].bits}) << "vertex " << v;
    }

    std::vector<Index> vertices(level.n_vertices), octs(level.n_octs);
    std::iota(vertices.begin(), vertices.end(), 0);
    std::iota(octs.begin(), octs.end(), 0);
    ExpectSameRelation(level.vertex_edges, rebuilt.vertex_edges, vertices, edges);
    ExpectSameRelation(level.edge_faces, rebuilt.edge_faces, edges, faces);
    ExpectSameRelation(level.vertex_octs, rebuilt.vertex_octs, vertices, octs);
    ExpectSameRelation(level.edge_octs, rebuilt.edge_octs, edges, octs);

    // Boundaries: the same oriented triangles, up to where a triangle starts.
    const auto oriented = [](const Level& l) {
        auto tuples = Tuples<3>(l.boundary_vertices);
        for (auto& t : tuples) std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
        std::sort(tuples.begin(), tuples.end());
        return tuples;
    };
    EXPECT_EQ(oriented(level), oriented(rebuilt));
}

TEST(RefineTest, ARefinedLevelIsTheLevelBuiltFromItsCells) {
    for (const auto& [name, shape] : TestShapes::AllShapes()) {
        SCOPED_TRACE(name);
        Level level = Base(shape);
        for (int i = 1; i <= 2; ++i) {
            level = Refine(level, true);
            SCOPED_TRACE(i);
            ExpectSameLevel(level, Rebuild(level));
        }
    }
}

TEST(RefineTest, APlantedSwapOfChildrenIsCaught) {
    Level level = Refine(Base(TestShapes::KuhnBlock(1)), true);
    Level rebuilt = Rebuild(level);
    std::swap(level.tet_edges[0], level.tet_edges[1]);
    EXPECT_NE(Through(Map<2>(level.edge_vertices, rebuilt.edge_vertices), level.tet_edges), rebuilt.tet_edges);
}

TEST(RefineTest, AThinLevelHasTheCellsAndBoundaryOfTheFullOne) {
    for (const auto& [name, shape] : TestShapes::AllShapes()) {
        SCOPED_TRACE(name);
        const Level base = Base(shape);
        const Level full = Refine(base, true), thin = Refine(base, false);
        EXPECT_EQ(full.tet_vertices, thin.tet_vertices);
        EXPECT_EQ(full.oct_vertices, thin.oct_vertices);
        EXPECT_EQ(full.boundary_vertices, thin.boundary_vertices);
        EXPECT_TRUE(thin.boundary_faces.empty());
        EXPECT_EQ(CountsOf(full), CountsOf(thin));
        EXPECT_FALSE(thin.is_full);
    }
}

TEST(RefineTest, EstimatedBytesAreThoseTaken) {
    for (const auto& [name, shape] : TestShapes::AllShapes()) {
        const Level base = Base(shape);
        for (bool full : {false, true}) {
            const Level child = Refine(base, full);
            EXPECT_EQ(EstimateBytes(CountsOf(child), full), child.Bytes()) << name;
        }
    }
}

TEST(RefineTest, GivesTheSameBitsForAnyNumberOfThreads) {
    const Shape shape = TestShapes::RandomSubset(TestShapes::KuhnBlock(8), 70, 3);
    std::vector<Level> levels;
    for (int threads : {1, 2, 5}) {
        const Sdc::ThreadLimit limit(threads);
        levels.push_back(Refine(Base(shape), true));
    }
    for (std::size_t i = 1; i < levels.size(); ++i) {
        EXPECT_EQ(levels[0].tet_edges, levels[i].tet_edges);
        EXPECT_EQ(levels[0].oct_faces, levels[i].oct_faces);
        EXPECT_EQ(levels[0].face_vertices, levels[i].face_vertices);
        EXPECT_EQ(levels[0].face_edges, levels[i].face_edges);
        EXPECT_EQ(levels[0].edge_vertices, levels[i].edge_vertices);
        EXPECT_EQ(levels[0].boundary_vertices, levels[i].boundary_vertices);
        EXPECT_TRUE(levels[0].vertex_tags == levels[i].vertex_tags && levels[0].edge_tags == levels[i].edge_tags);
        for (auto relation : {&Level::vertex_edges, &Level::edge_faces, &Level::vertex_octs, &Level::edge_octs}) {
            EXPECT_EQ((levels[0].*relation).items, (levels[i].*relation).items);
            EXPECT_EQ((levels[0].*relation).locals, (levels[i].*relation).locals);
        }
    }
}

// rules.md section 1, on a block with every kind of child.
TEST(CountsTest, FollowTheFormulas) {
    const Level a = Refine(Base(TestShapes::KuhnBlock(2)), true), b = Refine(a, true);
    EXPECT_EQ(b.n_tets, 4 * a.n_tets + 8 * a.n_octs);
    EXPECT_EQ(b.n_octs, a.n_tets + 6 * a.n_octs);
    EXPECT_EQ(b.n_vertices, a.n_vertices + a.n_edges + a.n_octs);
    EXPECT_EQ(b.n_vertices - b.n_edges + b.n_faces - b.n_cells(), 1) << "a ball has Euler characteristic 1";
    EXPECT_EQ(a.n_cells(), 48 * 5);
}

}  // namespace
