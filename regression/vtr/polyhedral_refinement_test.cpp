// SPDX-License-Identifier: Apache-2.0
// A refined level of polyhedra is the level that would be built from its own cells.
#include <algorithm>
#include <functional>
#include <map>
#include <numeric>
#include <set>

#include <gtest/gtest.h>
#include <solidsubdiv/sdc/hex_split.h>
#include <solidsubdiv/sdc/parallel.h>
#include <solidsubdiv/vtr/polyhedral_base.h>
#include <solidsubdiv/vtr/polyhedral_refinement.h>

#include "polyhedral_shapes.h"

namespace SolidSubdiv {
namespace {

using TestShapes::PolyhedralShape;
using Vtr::PolyhedralLevel;

PolyhedralLevel Base(const PolyhedralShape& s) {
    Vtr::PolyhedralFindings findings;
    PolyhedralLevel level = Vtr::MakePolyhedralBaseLevel(s.Elements(), findings);
    EXPECT_TRUE(findings.IsUsable());
    EXPECT_TRUE(findings.flipped_faces.empty());
    return level;
}

PolyhedralLevel Rebuild(const PolyhedralLevel& level) {
    PolyhedralShape s;
    s.n_vertices = level.n_vertices;
    s.hexes.assign(level.hex_vertices.begin(), level.hex_vertices.end());
    const Vtr::Polyhedra& p = level.polyhedra;
    s.cell_offsets.assign(p.offsets.begin(), p.offsets.end());
    s.face_offsets.assign(p.face_vertex_offsets.begin(), p.face_vertex_offsets.end());
    s.face_vertices.assign(p.face_vertices.begin(), p.face_vertices.end());
    for (Index b = 0; b < level.n_boundary_faces; ++b) {
        if (level.NCells(level.boundary_faces[b]) > 0) continue;
        const auto v = level.BoundaryVertices(b);
        s.polygon_vertices.insert(s.polygon_vertices.end(), v.begin(), v.end());
        s.polygon_offsets.push_back(static_cast<Offset>(s.polygon_vertices.size()));
    }
    for (Index e = 0; e < level.n_edges; ++e) {
        if (level.edge_faces.Count(e) > 0) continue;
        for (Index v : level.EdgeVertices(e)) s.edges.push_back(v);
    }
    return Base(s);
}

/// Of each row of vertices of one level the place of the same row, in any order, in another.
template <class Row>
std::vector<Index> Map(Index n, Row&& from, Index n_to, Row&& to) {
    const auto key = [](auto row) {
        std::vector<Index> v(row.begin(), row.end());
        std::sort(v.begin(), v.end());
        return v;
    };
    std::map<std::vector<Index>, Index> place;
    for (Index i = 0; i < n_to; ++i) place[key(to(i))] = i;
    EXPECT_EQ(place.size(), static_cast<std::size_t>(n_to));
    EXPECT_EQ(n, n_to);
    std::vector<Index> map;
    for (Index i = 0; i < n; ++i) {
        const auto found = place.find(key(from(i)));
        EXPECT_TRUE(found != place.end()) << i;
        map.push_back(found == place.end() ? 0 : found->second);
    }
    return map;
}

std::vector<Index> Through(const std::vector<Index>& map, std::span<const Index> values, bool sorted) {
    std::vector<Index> out;
    for (Index v : values) out.push_back(v == kNoIndex ? kNoIndex : map.empty() ? v : map[v]);
    if (sorted) std::sort(out.begin(), out.end());
    return out;
}

std::vector<Index> Rotated(std::span<const Index> v) {
    std::vector<Index> out(v.begin(), v.end());
    std::rotate(out.begin(), std::min_element(out.begin(), out.end()), out.end());
    return out;
}

void ExpectSameRelation(const Vtr::Relation& a, const Vtr::Relation& b, const std::vector<Index>& rows,
                        const std::vector<Index>& items) {
    for (Index i = 0; i < static_cast<Index>(rows.size()); ++i) {
        ASSERT_EQ(Through(items, a[i], true), Through({}, b[rows[i]], true)) << i;
    }
}

void ExpectSameLevel(const PolyhedralLevel& level, const PolyhedralLevel& rebuilt) {
    ASSERT_EQ(CountsOf(level), CountsOf(rebuilt));
    using Row = std::function<std::span<const Index>(Index)>;
    const auto edges = Map<const Row&>(
        level.n_edges, [&](Index e) { return std::span<const Index>(level.EdgeVertices(e)); }, rebuilt.n_edges,
        [&](Index e) { return std::span<const Index>(rebuilt.EdgeVertices(e)); });
    const auto faces = Map<const Row&>(
        level.n_faces, [&](Index f) { return level.FaceVertices(f); }, rebuilt.n_faces,
        [&](Index f) { return rebuilt.FaceVertices(f); });
    for (Index f = 0; f < level.n_faces; ++f) {
        const auto mine = level.FaceVertices(f), theirs = rebuilt.FaceVertices(faces[f]);
        // The same way round with the same cells, or both turned.
        const auto cells = level.FaceCells(f), other_cells = rebuilt.FaceCells(faces[f]);
        std::vector<Index> turned(mine.rbegin(), mine.rend());
        if (cells[0] == other_cells[0] && cells[1] == other_cells[1]) {
            ASSERT_EQ(Rotated(mine), Rotated(theirs)) << f;
        } else {
            ASSERT_EQ(cells[0], other_cells[1]) << f;
            ASSERT_EQ(cells[1], other_cells[0]) << f;
            ASSERT_EQ(Rotated(turned), Rotated(theirs)) << f;
        }
        for (std::size_t k = 0; k < mine.size(); ++k) {
            const auto ends = level.EdgeVertices(level.FaceEdges(f)[k]);
            const Index a = mine[k], b = mine[(k + 1) % mine.size()];
            ASSERT_EQ(std::minmax(a, b), std::minmax(ends[0], ends[1])) << f << " " << k;
        }
    }
    for (Index c = 0; c < level.n_hexes; ++c) {
        ASSERT_EQ(Through(edges, level.CellEdges(c), false), Through({}, rebuilt.CellEdges(c), false));
        ASSERT_EQ(Through(faces, level.CellFaces(c), false), Through({}, rebuilt.CellFaces(c), false));
    }
    const Vtr::Polyhedra &p = level.polyhedra, &q = rebuilt.polyhedra;
    for (Index i = 0; i < p.size(); ++i) {
        const Index c = level.n_hexes + i;
        const auto vertices = level.CellVertices(c), others = rebuilt.CellVertices(c);
        ASSERT_EQ(Through(faces, level.CellFaces(c), false), Through({}, rebuilt.CellFaces(c), false));
        ASSERT_EQ(Through(edges, level.CellEdges(c), true), Through({}, rebuilt.CellEdges(c), true));
        ASSERT_EQ(Through({}, vertices, true), Through({}, others, true));
        for (std::size_t k = 0; k < vertices.size();
             ++k) {  // rings as edges and faces of the level, from the lowest edge
            const auto ring = [&](const PolyhedralLevel& l, const Vtr::Polyhedra& cells, Offset corner, const auto& e,
                                  const auto& f) {
                std::vector<std::pair<Index, Index>> out;
                for (Offset j = cells.ring_offsets[corner]; j < cells.ring_offsets[corner + 1]; ++j) {
                    out.emplace_back(e(l.CellEdges(c)[cells.ring_edges[j]]), f(l.CellFaces(c)[cells.ring_faces[j]]));
                }
                std::rotate(out.begin(), std::min_element(out.begin(), out.end()), out.end());
                return out;
            };
            const auto other = std::find(others.begin(), others.end(), vertices[k]) - others.begin();
            ASSERT_EQ(
                ring(
                    level, p, p.vertex_offsets[i] + static_cast<Offset>(k), [&](Index e) { return edges[e]; },
                    [&](Index f) { return faces[f]; }),
                ring(
                    rebuilt, q, q.vertex_offsets[i] + other, [](Index e) { return e; }, [](Index f) { return f; }));
        }
    }
    for (Index e = 0; e < level.n_edges; ++e) {
        ASSERT_EQ(int{level.edge_tags[e].bits}, int{rebuilt.edge_tags[edges[e]].bits}) << "edge " << e;
    }
    std::vector<Index> same(level.n_vertices);
    std::iota(same.begin(), same.end(), 0);
    for (Index v = 0; v < level.n_vertices; ++v) {
        ASSERT_EQ(int{level.vertex_tags[v].bits}, int{rebuilt.vertex_tags[v].bits}) << "vertex " << v;
    }
    ExpectSameRelation(level.vertex_edges, rebuilt.vertex_edges, same, edges);
    ExpectSameRelation(level.vertex_cells, rebuilt.vertex_cells, same, {});
    ExpectSameRelation(level.edge_faces, rebuilt.edge_faces, edges, faces);
    const auto boundary = [](const PolyhedralLevel& l) {
        std::set<std::vector<Index>> faces_of_level;
        for (Index b = 0; b < l.n_boundary_faces; ++b) {
            faces_of_level.insert(Rotated(l.BoundaryVertices(b)));
            EXPECT_EQ(Rotated(l.BoundaryVertices(b)), Rotated(l.FaceVertices(l.boundary_faces[b])));
        }
        return faces_of_level;
    };
    EXPECT_EQ(boundary(level), boundary(rebuilt));
}

struct Named {
    const char* name;
    PolyhedralShape shape;
};
std::vector<Named> Shapes() {
    PolyhedralShape l_shape =
        TestShapes::HexBlock(2, 2, 2, [](int x, int y, int z) { return x + y + z < 2 || (x == 1 && y == 0); });
    return {{"cube", TestShapes::HexBlock(1)},
            {"block", TestShapes::HexBlock(3)},
            {"l", l_shape},
            {"mixed", TestShapes::MixedCells()},
            {"touching", TestShapes::TouchingCubes()},
            {"sheets", TestShapes::CubeWithSheets()}};
}

TEST(PolyhedralRefinement, IsTheLevelBuiltFromItsOwnCells) {
    for (const auto& [name, shape] : Shapes()) {
        PolyhedralLevel level = Base(shape);
        Vtr::PolyhedralCounts counts = CountsOf(level);
        for (int i = 0; i < 2; ++i) {
            level = Refine(level, true);
            counts = Refine(counts);
            SCOPED_TRACE(std::string(name) + ", level " + std::to_string(i + 1));
            EXPECT_EQ(CountsOf(level), counts);
            ExpectSameLevel(level, Rebuild(level));
        }
    }
}

TEST(PolyhedralRefinement, ThinLevelsHaveTheSameCellsAndBoundary) {
    for (const auto& [name, shape] : Shapes()) {
        const PolyhedralLevel base = Base(shape);
        const PolyhedralLevel full = Refine(base, true), thin = Refine(base, false);
        EXPECT_EQ(full.hex_vertices, thin.hex_vertices) << name;
        EXPECT_EQ(full.polyhedra.face_vertices, thin.polyhedra.face_vertices) << name;
        EXPECT_EQ(full.polyhedra.offsets, thin.polyhedra.offsets) << name;
        EXPECT_EQ(full.boundary_vertices, thin.boundary_vertices) << name;
        EXPECT_FALSE(thin.is_full);
        const Offset estimate = EstimateBytes(Refine(CountsOf(base)), true);
        EXPECT_LE(full.Bytes(), estimate + 200) << name;
        EXPECT_GE(full.Bytes(), estimate * 9 / 10) << name;
    }
}

TEST(PolyhedralRefinement, IsTheSameForAnyNumberOfThreads) {
    const auto refine = [](int n_threads) {
        const Sdc::ThreadLimit limit(n_threads);
        return Refine(Refine(Base(TestShapes::TouchingCubes()), true), true);
    };
    const PolyhedralLevel a = refine(1), b = refine(5);
    EXPECT_EQ(a.hex_edges, b.hex_edges);
    EXPECT_EQ(a.hex_faces, b.hex_faces);
    EXPECT_EQ(a.face_vertices, b.face_vertices);
    EXPECT_EQ(a.face_cells, b.face_cells);
    EXPECT_EQ(a.vertex_cells.items, b.vertex_cells.items);
    EXPECT_EQ(a.edge_tags, b.edge_tags);
}

/// Means of the corners of everything: the octree rule.
std::vector<double> LinearPoints(const PolyhedralLevel& level, std::vector<double> positions) {
    const auto add_mean = [&](std::span<const Index> vertices) {
        for (int axis = 0; axis < 3; ++axis) {
            double sum = 0;
            for (Index v : vertices) sum += positions[3 * static_cast<std::size_t>(v) + static_cast<std::size_t>(axis)];
            positions.push_back(sum / static_cast<double>(vertices.size()));
        }
    };
    for (Index e = 0; e < level.n_edges; ++e) add_mean(level.EdgeVertices(e));
    for (Index f = 0; f < level.n_faces; ++f) add_mean(level.FaceVertices(f));
    for (Index c = 0; c < level.n_cells(); ++c) add_mean(level.CellVertices(c));
    return positions;
}

double Det(const std::vector<double>& x, Index o, Index a, Index b, Index c) {
    const auto d = [&](Index v, int axis) {
        return x[3 * static_cast<std::size_t>(v) + static_cast<std::size_t>(axis)] -
               x[3 * static_cast<std::size_t>(o) + static_cast<std::size_t>(axis)];
    };
    return d(a, 0) * (d(b, 1) * d(c, 2) - d(b, 2) * d(c, 1)) - d(a, 1) * (d(b, 0) * d(c, 2) - d(b, 2) * d(c, 0)) +
           d(a, 2) * (d(b, 0) * d(c, 1) - d(b, 1) * d(c, 0));
}

TEST(PolyhedralRefinement, ChildrenOfPositiveCellsArePositiveAndAsLargeTogether) {
    for (const auto& [name, shape] : Shapes()) {
        PolyhedralLevel level = Base(shape);
        std::vector<double> positions = shape.positions;
        std::vector<double> volumes;
        for (int i = 0; i <= 2; ++i) {
            if (i > 0) {
                positions = LinearPoints(level, positions);
                level = Refine(level, true);
            }
            double volume = 0;
            for (Index c = 0; c < level.n_cells(); ++c) {
                // Sum of the cones over the triangles from the faces' means, which the split's faces have as well.
                std::vector<double> x = positions;
                const auto point = [&](std::span<const Index> vertices) {
                    for (int axis = 0; axis < 3; ++axis) {
                        double sum = 0;
                        for (Index v : vertices)
                            sum += x[3 * static_cast<std::size_t>(v) + static_cast<std::size_t>(axis)];
                        x.push_back(sum / static_cast<double>(vertices.size()));
                    }
                    return static_cast<Index>(x.size() / 3) - 1;
                };
                const Index apex = point(level.CellVertices(c));
                double mine = 0;
                for (Index f : level.CellFaces(c)) {
                    const auto v = level.FaceVertices(f);
                    const Index middle = point(v);
                    const double sign = level.FaceCells(f)[0] == c ? 1 : -1;
                    for (std::size_t k = 0; k < v.size(); ++k) {
                        mine += sign * Det(x, apex, middle, v[k], v[(k + 1) % v.size()]) / 6;
                    }
                }
                EXPECT_GT(mine, 0) << name << ", level " << i << ", cell " << c;
                volume += mine;
            }
            for (Index c = 0; c < level.n_hexes; ++c) {
                const auto v = level.CellVertices(c);
                EXPECT_GT(Det(positions, v[0], v[1], v[3], v[4]), 0) << name << ", level " << i << ", cell " << c;
            }
            volumes.push_back(volume);
        }
        EXPECT_NEAR(volumes[1], volumes[2], 1e-12) << name;  // from level 1 on faces' triangles are those of the split
        EXPECT_NEAR(volumes[0], volumes[1], std::string(name) == "mixed" ? 0.1 : 1e-12) << name;
    }
}

TEST(PolyhedralRefinement, ChildrenOfAHexahedronLieAsItDoes) {
    const PolyhedralShape cube = TestShapes::HexBlock(1);
    const PolyhedralLevel base = Base(cube), child = Refine(base, false);
    const auto x = LinearPoints(base, cube.positions);
    const auto corner = [](int j, int axis) {
        return axis == 2 ? j / 4 : axis == 1 ? (j / 2) % 2 : (j % 4 == 1 || j % 4 == 2);
    };
    for (int i = 0; i < 8; ++i) {
        for (int j = 0; j < 8; ++j) {
            const Index v = child.hex_vertices[8 * i + j];
            for (int axis = 0; axis < 3; ++axis) {
                EXPECT_EQ(x[3 * v + axis], (corner(i, axis) + corner(j, axis)) / 2.0) << i << " " << j;
            }
        }
    }
}

TEST(PolyhedralRefinement, OddCornersKeepTheirNumberOfEdges) {
    PolyhedralLevel level = Base(TestShapes::MixedCells());
    EXPECT_EQ(level.n_hexes, 1);
    EXPECT_EQ(level.n_polyhedra(), 4);
    level = Refine(level, true);
    // The pyramid's apex and the octahedron's six corners have four edges each.
    EXPECT_EQ(level.n_polyhedra(), 7);
    EXPECT_EQ(level.n_hexes, 8 + 4 + 6 + 4);
    level = Refine(level, true);
    EXPECT_EQ(level.n_polyhedra(), 14);
}

}  // namespace
}  // namespace SolidSubdiv
