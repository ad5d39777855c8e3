// SPDX-License-Identifier: Apache-2.0
// The butterfly oracle at boundaries and creases: curve rules, missing wings, planes, sides that do not see each
// other, darts, edges of three triangles.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

#include "validation/butterfly_oracle.h"
#include "validation/cone_surfaces.h"
#include "validation/findings.h"
#include "validation/or_skip.h"

namespace SolidSubdiv::Validation {
namespace {

/// Weights are below 1 and a row has at most two dozen: sums are exact to a few units of 1e-16; a hundred times that.
constexpr double kRoundOff = 1e-13;

using Edge = std::array<int, 2>;
using Row = std::map<int, double>;

class ButterflyBoundary : public testing::Test {
  protected:
    void SetUp() override {
        OrSkip([&] { RefineByButterflyOracle(MakeCone(3, true, 1).surface, ButterflyRule(), 1); });
    }
};

/// The row of the new vertex on an edge of the control surface.
Row RowOfEdge(const ControlSurface& surface, const ButterflyRule& rule, int a, int b) {
    const auto refined = RefineByButterflyOracle(surface, rule, 1);
    const SurfaceLevel& level = refined.levels[0];
    for (std::size_t e = 0; e < level.edges.size(); ++e) {
        if (level.edges[e] != Edge{a, b} && level.edges[e] != Edge{b, a}) continue;
        Row row;
        const int v = level.children_of_edges[e];
        for (std::int64_t k = refined.steps[0].offsets[v]; k < refined.steps[0].offsets[v + 1]; ++k) {
            row[refined.steps[0].indices[k]] = refined.steps[0].weights[k];
        }
        return row;
    }
    throw std::runtime_error("no such edge");
}

/// Weight by weight; one that is not there is 0.
void ExpectRow(Row row, const Row& expected) {
    for (const auto& [v, weight] : expected) row[v] -= weight;
    for (const auto& [v, difference] : row) EXPECT_NEAR(difference, 0, kRoundOff) << "vertex " << v;
}

/// columns x rows rhombs of the regular lattice in the plane, from column `first` on. Vertex (i, j) is at i + j/2,
/// j sqrt(3)/2; its triangles lean to the right.
struct Sheet {
    int n_columns, n_rows, first = 0;
    ControlSurface surface;

    Sheet(int columns, int rows, int first_column = 0) : n_columns(columns), n_rows(rows), first(first_column) {
        for (int j = 0; j <= rows; ++j) {
            for (int i = first; i <= first + columns; ++i) {
                surface.positions.insert(surface.positions.end(), {i + 0.5 * j, std::sqrt(0.75) * j, 0});
            }
        }
        surface.n_vertices = (columns + 1) * (rows + 1);
        for (int j = 0; j < rows; ++j) {
            for (int i = first; i < first + columns; ++i) {
                surface.triangles.push_back({At(i, j), At(i + 1, j), At(i, j + 1)});
                surface.triangles.push_back({At(i + 1, j), At(i + 1, j + 1), At(i, j + 1)});
            }
        }
    }
    int At(int i, int j) const { return j * (n_columns + 1) + i - first; }
    /// The four corners of the sheet, where its border turns.
    std::vector<int> Corners() const {
        return {At(first, 0), At(first + n_columns, 0), At(first, n_rows), At(first + n_columns, n_rows)};
    }
    /// The lattice line from (i, j) on, by n steps of (di, dj).
    std::vector<Edge> Line(int i, int j, int di, int dj, int n) const {
        std::vector<Edge> edges;
        for (int k = 0; k < n; ++k)
            edges.push_back({At(i + k * di, j + k * dj), At(i + (k + 1) * di, j + (k + 1) * dj)});
        return edges;
    }
};

/// The largest distance of a new vertex of any level from the middle of its edge.
double DistanceFromMiddles(const std::vector<SurfaceLevel>& levels) {
    double largest = 0;
    for (std::size_t l = 0; l + 1 < levels.size(); ++l) {
        const auto& p = levels[l].positions;
        for (std::size_t e = 0; e < levels[l].edges.size(); ++e) {
            const auto [a, b] = levels[l].edges[e];
            const int v = levels[l].children_of_edges[e];
            for (int i = 0; i < 3; ++i) {
                const double middle = (p[3 * a + i] + p[3 * b + i]) / 2;
                largest = std::max(largest, std::abs(levels[l + 1].positions[3 * v + i] - middle));
            }
        }
    }
    return largest;
}

TEST_F(ButterflyBoundary, BordersFollowTheFourPointRule) {
    const Sheet sheet(5, 5);
    const Row four = {{sheet.At(1, 0), -1.0 / 16},
                      {sheet.At(2, 0), 9.0 / 16},
                      {sheet.At(3, 0), 9.0 / 16},
                      {sheet.At(4, 0), -1.0 / 16}};
    for (const ButterflyRule& rule : {ButterflyRule::Plain(0.01), ButterflyRule::Modified(0.01)}) {
        ExpectRow(RowOfEdge(sheet.surface, rule, sheet.At(2, 0), sheet.At(3, 0)), four);
    }
    ButterflyRule slack;
    slack.curve_tension = 1.0 / 32;
    ExpectRow(RowOfEdge(sheet.surface, slack, sheet.At(2, 0), sheet.At(3, 0)), {{sheet.At(1, 0), -1.0 / 32},
                                                                                {sheet.At(2, 0), 17.0 / 32},
                                                                                {sheet.At(3, 0), 17.0 / 32},
                                                                                {sheet.At(4, 0), -1.0 / 32}});
}

TEST_F(ButterflyBoundary, CurvesEndInCorners) {
    const Sheet sheet(5, 5);
    const int a = sheet.At(2, 0), b = sheet.At(3, 0), c = sheet.At(4, 0);
    ExpectRow(RowOfEdge(WithCreases(sheet.surface, {}, {a}), {}, a, b), {{a, 3.0 / 8}, {b, 6.0 / 8}, {c, -1.0 / 8}});
    ExpectRow(RowOfEdge(WithCreases(sheet.surface, {}, {a, b}), {}, a, b), {{a, 0.5}, {b, 0.5}});
    // A crease that meets the border ends there, and ends the border's curve; the corner of a triangle does not.
    ExpectRow(RowOfEdge(WithCreases(sheet.surface, sheet.Line(2, 0, 0, 1, 1)), {}, a, b),
              {{a, 3.0 / 8}, {b, 6.0 / 8}, {c, -1.0 / 8}});
    const ControlSurface triangle{3, {{0, 1, 2}}, std::vector<double>(9)};
    ExpectRow(RowOfEdge(triangle, {}, 0, 1), {{0, 9.0 / 16}, {1, 9.0 / 16}, {2, -1.0 / 8}});
}

TEST_F(ButterflyBoundary, MissingWingsAreReflected) {
    const Sheet sheet(6, 6);
    const double w = 0.05;
    // a = (2, 0) is on the border, b = (2, 1); opposite (1, 1) and (3, 0); the wing across (2, 0) (3, 0) is missing.
    const Row expected = {{sheet.At(2, 0), 0.5 - w},   {sheet.At(2, 1), 0.5 + w}, {sheet.At(1, 1), 2 * w},
                          {sheet.At(3, 0), 2 * w - w}, {sheet.At(1, 0), -w},      {sheet.At(1, 2), -w},
                          {sheet.At(3, 1), -w}};
    ExpectRow(RowOfEdge(sheet.surface, ButterflyRule::Plain(w), sheet.At(2, 0), sheet.At(2, 1)), expected);
    // Both ends are regular for the modified rule too, and its far points drop out with the missing one.
    const ControlSurface surface = sheet.surface;
    EXPECT_EQ(RowOfEdge(surface, ButterflyRule::Modified(1.0 / 64), sheet.At(2, 0), sheet.At(2, 1)),
              RowOfEdge(surface, ButterflyRule::Plain(), sheet.At(2, 0), sheet.At(2, 1)));
}

TEST_F(ButterflyBoundary, PlanesAreReproducedAlongBordersAndCreases) {
    const Sheet sheet(6, 5);
    const std::vector<std::vector<Edge>> creases = {
        {},
        sheet.Line(0, 2, 1, 0, 6),   // right through, in the three directions
        sheet.Line(3, 0, 0, 1, 5),   //
        sheet.Line(5, 0, -1, 1, 5),  //
        sheet.Line(0, 2, 1, 0, 3),   // ends inside: a dart
        sheet.Line(2, 2, 1, 0, 2),   // two darts
        sheet.Line(3, 2, 1, 0, 1),   // of one edge
    };
    for (const auto& crease : creases) {
        for (const ButterflyRule& rule : {ButterflyRule::Plain(), ButterflyRule::Plain(0.03), ButterflyRule::Modified(),
                                          ButterflyRule::Modified(1.0 / 64)}) {
            const auto refined = RefineByButterflyOracle(WithCreases(sheet.surface, crease, sheet.Corners()), rule, 3);
            EXPECT_LT(DistanceFromMiddles(refined.levels), kRoundOff * 10) << crease.size();  // sizes up to 10
        }
    }
    // The check sees a corner that is none: the border's curve runs through it.
    EXPECT_GT(DistanceFromMiddles(RefineByButterflyOracle(sheet.surface, {}, 1).levels), 0.01);
}

TEST_F(ButterflyBoundary, ACreaseIsABoundaryForBothSides) {
    Sheet whole(6, 4), left(3, 4), right(3, 4, 3);
    for (Sheet* sheet : {&whole, &left, &right}) {  // out of the plane, by place
        for (int v = 0; v < sheet->surface.n_vertices; ++v) {
            double* p = &sheet->surface.positions[3 * v];
            p[2] = std::sin(3 * p[0] + 1) * std::cos(2 * p[1]);
        }
    }
    const auto crease = whole.Line(3, 0, 0, 1, 4);
    for (const ButterflyRule& rule : {ButterflyRule::Plain(), ButterflyRule::Modified()}) {
        const auto levels = RefineByButterflyOracle(WithCreases(whole.surface, crease), rule, 3).levels;
        std::size_t n_found = 0;
        for (const Sheet* half : {&left, &right}) {
            // The crease meets the border in two vertices, which end all curves.
            const std::vector<int> ends = {half->At(3, 0), half->At(3, 4)};
            const auto halves = RefineByButterflyOracle(WithCreases(half->surface, {}, ends), rule, 3).levels;
            std::map<int, int> match;  // of the half's vertices: by place at level 0, then by children
            for (int j = 0; j <= 4; ++j) {
                for (int i = half->first; i <= half->first + 3; ++i) match[half->At(i, j)] = whole.At(i, j);
            }
            for (std::size_t l = 0; l < 4; ++l) {
                for (const auto& [v, w] : match) {
                    for (int i = 0; i < 3; ++i) {
                        ASSERT_NEAR(halves[l].positions[3 * v + i], levels[l].positions[3 * w + i], kRoundOff * 10);
                    }
                }
                n_found = match.size();
                if (l == 3) break;
                std::map<Edge, int> child;
                for (std::size_t e = 0; e < levels[l].edges.size(); ++e) {
                    auto ends_of = levels[l].edges[e];
                    std::sort(ends_of.begin(), ends_of.end());
                    child[ends_of] = levels[l].children_of_edges[e];
                }
                std::map<int, int> next;
                for (const auto& [v, w] : match) {
                    next[halves[l].children_of_vertices[v]] = levels[l].children_of_vertices[w];
                }
                for (std::size_t e = 0; e < halves[l].edges.size(); ++e) {
                    const int a = match.at(halves[l].edges[e][0]), b = match.at(halves[l].edges[e][1]);
                    next[halves[l].children_of_edges[e]] = child.at({std::min(a, b), std::max(a, b)});
                }
                match = next;
            }
        }
        EXPECT_EQ(n_found, 25U * 33U);  // all of a half
    }
}

TEST_F(ButterflyBoundary, ADartKeepsItsRing) {
    const Cone cone = MakeCone(5, true, 3);  // vertices 1 to 5 are around vertex 0
    const ControlSurface plain = cone.surface, dart = WithCreases(cone.surface, {{0, 2}});
    const auto at = [&](const ControlSurface& surface, int b) { return RowOfEdge(surface, {}, 0, b); };
    for (const int b : {1, 3, 4, 5}) ExpectRow(at(dart, b), at(plain, b));
    ExpectRow(at(dart, 2), {{0, 0.5}, {2, 0.5}});  // the crease itself, of one edge: both its ends end the curve
    // A second crease makes two sectors of it, of two and of three triangles.
    const ControlSurface crease = WithCreases(cone.surface, {{0, 2}, {0, 4}});
    ExpectRow(at(crease, 3), {{0, 0.5}, {3, 0.5}});
    EXPECT_EQ(at(crease, 1).count(3), 0U);
}

TEST_F(ButterflyBoundary, EdgesOfThreeTrianglesAreCreases) {
    // Four pages of two squares each on the spine 0 1 2; page p has vertices 3p + 3 to 3p + 5.
    ControlSurface book{15, {}, std::vector<double>(45)};
    for (int p = 0; p < 4; ++p) {
        const int a = 3 * p + 3;
        for (const Triangle& t :
             {Triangle{0, 1, a}, Triangle{1, a + 1, a}, Triangle{1, 2, a + 1}, Triangle{2, a + 2, a + 1}}) {
            book.triangles.push_back(t);
        }
    }
    ExpectRow(RowOfEdge(book, {}, 0, 1), {{0, 3.0 / 8}, {1, 6.0 / 8}, {2, -1.0 / 8}});
    for (const ButterflyRule& rule : {ButterflyRule::Plain(), ButterflyRule::Modified()}) {
        const Row row = RowOfEdge(book, rule, 1, 4);
        for (const auto& entry : row) EXPECT_LT(entry.first, 6);  // the other pages are not seen
    }
    // Two triangles that meet in vertex 0 only: their curves end there.
    const ControlSurface bow_tie{5, {{0, 1, 2}, {0, 3, 4}}, std::vector<double>(15)};
    ExpectRow(RowOfEdge(bow_tie, {}, 0, 1), {{0, 3.0 / 8}, {1, 6.0 / 8}, {2, -1.0 / 8}});
}

}  // namespace
}  // namespace SolidSubdiv::Validation
