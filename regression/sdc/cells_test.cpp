// SPDX-License-Identifier: Apache-2.0
// The reference cells and their splits, checked by geometry.
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <vector>

#include <gtest/gtest.h>
#include <solidsubdiv/sdc/cell_split.h>

namespace {

using namespace SolidSubdiv::Sdc;
using Point = std::array<double, 3>;

Point operator-(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
double Det(const Point& a, const Point& b, const Point& c) {
    return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
}
Point Mean(const std::vector<Point>& points) {
    Point m{};
    for (const Point& p : points) {
        for (int k = 0; k < 3; ++k) m[k] += p[k] / static_cast<double>(points.size());
    }
    return m;
}

template <class Cell>
std::vector<Point> Corners() {
    if constexpr (Cell::kVertices == 4) {
        return {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    } else {
        return {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, -1}, {0, 0, 1}};
    }
}

/// The points of a split cell, by the linear rule.
template <class Cell>
std::vector<Point> SplitPoints() {
    std::vector<Point> points = Corners<Cell>();
    for (const auto& e : Cell::edges) points.push_back(Mean({points[e[0]], points[e[1]]}));
    if constexpr (CellSplit<Cell>::kIsOct) points.push_back({0, 0, 0});
    return points;
}

double TetVolume(const Point& a, const Point& b, const Point& c, const Point& d) {
    return Det(b - a, c - a, d - a) / 6;
}
template <class Row>
double OctVolume(const Row& v, const std::vector<Point>& p) {
    double sum = 0;
    for (const auto& t : Oct::tets) sum += TetVolume(p[v[t[0]]], p[v[t[1]]], p[v[t[2]]], p[v[t[3]]]);
    return sum;
}

template <class Cell>
class CellTest : public testing::Test {};
using Cells = testing::Types<Tet, Oct>;
TYPED_TEST_SUITE(CellTest, Cells);

TYPED_TEST(CellTest, FacesLookOutwardAndEdgesAreTheirEdges) {
    const auto p = Corners<TypeParam>();
    const Point centre = Mean(p);
    std::map<std::set<int>, int> faces_of_edge;
    for (const auto& f : TypeParam::faces) {
        EXPECT_GT(Det(p[f[0]] - centre, p[f[1]] - centre, p[f[2]] - centre), 0);
        for (int k = 0; k < 3; ++k) ++faces_of_edge[{f[k], f[(k + 1) % 3]}];
    }
    EXPECT_EQ(faces_of_edge.size(), TypeParam::edges.size());
    for (const auto& e : TypeParam::edges) EXPECT_EQ((faces_of_edge[{e[0], e[1]}]), 2);
}

TYPED_TEST(CellTest, ChildrenArePositiveAndFillTheCell) {
    constexpr auto& split = SplitOf<TypeParam>();
    const auto p = SplitPoints<TypeParam>();
    double whole;
    if constexpr (CellSplit<TypeParam>::kIsOct) {
        whole = OctVolume(std::array<Local, 6>{0, 1, 2, 3, 4, 5}, p);
    } else {
        whole = TetVolume(p[0], p[1], p[2], p[3]);
    }
    double sum = 0;
    for (const auto& t : split.tets) {
        const double volume = TetVolume(p[t[0]], p[t[1]], p[t[2]], p[t[3]]);
        EXPECT_GT(volume, 0);
        sum += volume;
    }
    for (const auto& o : split.octs) {
        const Point c = Mean({p[o[0]], p[o[1]], p[o[2]], p[o[3]], p[o[4]], p[o[5]]});
        EXPECT_LT(Det(p[o[0]] - c, p[o[2]] - c, p[o[4]] - c), 0);
        const double volume = OctVolume(o, p);
        EXPECT_GT(volume, 0);
        sum += volume;
    }
    EXPECT_NEAR(sum, whole, 1e-15);
    EXPECT_GT(whole, 0);
}

TYPED_TEST(CellTest, ChildrensEdgesAndFacesAreThoseOfTheTables) {
    constexpr auto& split = SplitOf<TypeParam>();
    for (std::size_t c = 0; c < split.tets.size(); ++c) {
        for (int e = 0; e < Tet::kEdges; ++e) {
            const auto& ends = split.edge_points[split.tet_edges[c][e]];
            EXPECT_EQ((std::set<int>{ends[0], ends[1]}),
                      (std::set<int>{split.tets[c][Tet::edges[e][0]], split.tets[c][Tet::edges[e][1]]}));
        }
    }
    std::map<int, int> cells_of_face;
    for (const auto& faces : split.tet_faces) {
        for (Local f : faces) ++cells_of_face[f];
    }
    for (const auto& faces : split.oct_faces) {
        for (Local f : faces) ++cells_of_face[f];
    }
    // Inner faces lie between two children, the others on the cell's own faces.
    for (int f = 0; f < CellSplit<TypeParam>::kChildFaces; ++f) {
        EXPECT_EQ(cells_of_face[f], f < CellSplit<TypeParam>::kFirstInnerFace ? 1 : 2) << f;
    }
}

// Children's major diagonals, and the pairs of their tets, are parallel to the parent's (rules.md section 1).
TYPED_TEST(CellTest, DiagonalsOfChildrenAreParallelToTheParents) {
    constexpr auto& split = SplitOf<TypeParam>();
    const auto p = SplitPoints<TypeParam>();
    Point diagonal;
    if constexpr (CellSplit<TypeParam>::kIsOct) {
        diagonal = p[0] - p[1];
    } else {
        diagonal = Mean({p[0], p[1]}) - Mean({p[2], p[3]});
    }
    const auto is_parallel = [&](const Point& d) {
        double cross = 0, dot = 0;
        for (int k = 0; k < 3; ++k) {
            const int i = (k + 1) % 3, j = (k + 2) % 3;
            cross += std::abs(d[i] * diagonal[j] - d[j] * diagonal[i]);
            dot += d[k] * diagonal[k];
        }
        return cross < 1e-15 && std::abs(dot) > 1e-3;
    };
    for (const auto& o : split.octs) EXPECT_TRUE(is_parallel(p[o[0]] - p[o[1]]));
    for (const auto& t : split.tets) EXPECT_TRUE(is_parallel(Mean({p[t[0]], p[t[1]]}) - Mean({p[t[2]], p[t[3]]})));
}

TEST(OctTest, TheFirstEightEdgesTouchTheMajorDiagonal) {
    for (int e = 0; e < Oct::kEdges; ++e) {
        EXPECT_EQ(Oct::edges[e][0] < 2, e < Oct::kDiagonalEdges);
        EXPECT_GE(Oct::edges[e][1], 2);
    }
}

}  // namespace
