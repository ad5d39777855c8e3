// SPDX-License-Identifier: Apache-2.0
// The butterfly oracle against its own masks written out, and against laws: it interpolates, its rows sum to 1, it
// reproduces cubics, and it does not see how vertices are numbered.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <random>
#include <stdexcept>

#include "validation/butterfly_oracle.h"
#include "validation/cone_surfaces.h"
#include "validation/or_skip.h"
#include "validation/solid_shapes.h"
#include "validation/split_levels_oracle.h"
#include "validation/surface_compare.h"
#include "validation/surface_shapes.h"

namespace SolidSubdiv::Validation {
namespace {

/// Weights are below 1 and a row has at most two dozen: sums are exact to a few units of 1e-16; a hundred times that.
constexpr double kRoundOff = 1e-13;

const ButterflyRule kRules[] = {ButterflyRule::Plain(), ButterflyRule::Plain(0.05), ButterflyRule::Modified(),
                                ButterflyRule::Modified(1.0 / 64)};

class ButterflyOracle : public testing::Test {
  protected:
    void SetUp() override {
        OrSkip([&] { RefineByButterflyOracle(MakeCone(3, true, 1).surface, ButterflyRule(), 1); });
    }
};

/// Every kind of surface: closed, open, meeting itself in vertices and edges.
std::vector<SurfaceShape> AllShapes() {
    std::vector<SurfaceShape> shapes = AllSurfaces();
    for (SurfaceShape& shape : shapes) {
        const auto own = TakeSurface(shape.triangles, shape.positions);
        shape = {shape.name, own.surface.triangles, own.surface.positions};
    }
    return shapes;
}

ControlSurface SurfaceOf(const SurfaceShape& shape) {
    return {static_cast<int>(shape.positions.size() / 3), shape.triangles, shape.positions};
}

/// The row of the new vertex on an edge, by place in a cone.
std::map<ConePlace, double> RowOfEdge(const Cone& cone, const ButterflyRefinement& refined, ConePlace a, ConePlace b) {
    const SurfaceLevel& level = refined.levels[0];
    for (std::size_t e = 0; e < level.edges.size(); ++e) {
        const ConePlace &p = cone.places[level.edges[e][0]], &q = cone.places[level.edges[e][1]];
        if (!((p == a && q == b) || (p == b && q == a))) continue;
        std::map<ConePlace, double> row;
        const SparseRows& step = refined.steps[0];
        const int v = level.children_of_edges[e];
        for (std::int64_t k = step.offsets[v]; k < step.offsets[v + 1]; ++k) {
            row[cone.places[step.indices[k]]] += step.weights[k];
        }
        return row;
    }
    throw std::runtime_error("no such edge");
}

void ExpectRow(const std::map<ConePlace, double>& row, const std::map<ConePlace, double>& expected) {
    EXPECT_EQ(row.size(), expected.size());
    for (const auto& [place, weight] : expected) {
        const auto found = row.find(place);
        ASSERT_NE(found, row.end()) << place[0] << " " << place[1] << " " << place[2];
        EXPECT_NEAR(found->second, weight, kRoundOff) << place[0] << " " << place[1] << " " << place[2];
    }
}

TEST_F(ButterflyOracle, RegularEdgesHaveEightAndTenPoints) {
    const Cone cone = MakeCone(6, true, 4);
    const ControlSurface surface = cone.surface;
    const ConePlace apex = {0, 0, 0}, end = {0, 1, 0};
    const double v = 0.05, w = 1.0 / 64;
    const ConePlace wings[] = {{2, 1, 0}, {4, 1, 0}, {0, 1, 1}, {5, 1, 1}}, opposite[] = {{1, 1, 0}, {5, 1, 0}};
    std::map<ConePlace, double> eight = {{apex, 0.5}, {end, 0.5}}, ten = {{apex, 0.5 - w}, {end, 0.5 - w}};
    for (const ConePlace& place : opposite) {
        eight[place] = 2 * v;
        ten[place] = 1.0 / 8 + 2 * w;
    }
    for (const ConePlace& place : wings) {
        eight[place] = -v;
        ten[place] = -1.0 / 16 - w;
    }
    ten[{3, 1, 0}] = ten[{0, 2, 0}] = w;
    ExpectRow(RowOfEdge(cone, RefineByButterflyOracle(surface, ButterflyRule::Plain(v), 1), apex, end), eight);
    ExpectRow(RowOfEdge(cone, RefineByButterflyOracle(surface, ButterflyRule::Modified(w), 1), apex, end), ten);
    EXPECT_EQ(RowOfEdge(cone, RefineByButterflyOracle(surface, ButterflyRule::Plain(), 1), apex, end),
              RowOfEdge(cone, RefineByButterflyOracle(surface, ButterflyRule::Modified(), 1), apex, end));
}

TEST_F(ButterflyOracle, ExtraordinaryVerticesHaveMasksOfTheirOwn) {
    const ConePlace apex = {0, 0, 0}, end = {0, 1, 0};
    const auto row = [&](int n) {
        const Cone cone = MakeCone(n, true, 3);
        return RowOfEdge(cone, RefineByButterflyOracle(cone.surface, ButterflyRule::Modified(1.0 / 64), 1), apex, end);
    };
    ExpectRow(row(3), {{apex, 3.0 / 4}, {end, 5.0 / 12}, {{1, 1, 0}, -1.0 / 12}, {{2, 1, 0}, -1.0 / 12}});
    ExpectRow(row(4), {{apex, 3.0 / 4}, {end, 3.0 / 8}, {{2, 1, 0}, -1.0 / 8}});
    for (const int n : {5, 7, 8, 12}) {
        std::map<ConePlace, double> expected = {{apex, 3.0 / 4}};
        for (int i = 0; i < n; ++i) {
            const double angle = 2 * std::numbers::pi * i / n;
            const double weight = (0.25 + std::cos(angle) + 0.5 * std::cos(2 * angle)) / n;
            if (weight != 0) expected[{i, 1, 0}] = weight;
        }
        ExpectRow(row(n), expected);
    }
}

TEST_F(ButterflyOracle, TwoExtraordinaryEndsTakeTheMean) {
    // A double pyramid over a pentagon: apexes of valence 5, vertices 1 to 5 of valence 4.
    ControlSurface surface{7, {}, std::vector<double>(21)};
    for (int i = 0; i < 5; ++i) {
        const int a = 1 + i, b = 1 + (i + 1) % 5;
        surface.triangles.push_back({0, a, b});
        surface.triangles.push_back({6, b, a});
    }
    const auto refined = RefineByButterflyOracle(surface, ButterflyRule::Modified(), 1);
    const auto s = [](int i) {
        const double angle = 2 * std::numbers::pi * i / 5;
        return (0.25 + std::cos(angle) + 0.5 * std::cos(2 * angle)) / 5;
    };
    const SurfaceLevel& level = refined.levels[0];
    const auto edge = std::find_if(level.edges.begin(), level.edges.end(), [](const auto& e) {
        return std::min(e[0], e[1]) == 0 && std::max(e[0], e[1]) == 1;
    });
    ASSERT_NE(edge, level.edges.end());
    std::vector<double> row(7);
    const int v = level.children_of_edges[edge - level.edges.begin()];
    for (std::int64_t k = refined.steps[0].offsets[v]; k < refined.steps[0].offsets[v + 1]; ++k) {
        row[refined.steps[0].indices[k]] = refined.steps[0].weights[k];
    }
    // Around vertex 1: 0, 2, 6, 5; the vertex across from 0 is 6.
    const std::vector<double> expected = {0.5 * (0.75 + 0.375), 0.5 * (s(0) + 0.75), 0.5 * s(1),    0.5 * s(2),
                                          0.5 * s(3),           0.5 * s(4),          0.5 * (-0.125)};
    for (std::size_t i = 0; i < 7; ++i) EXPECT_NEAR(row[i], expected[i], kRoundOff) << i;
}

TEST_F(ButterflyOracle, InterpolatesAndItsRowsSumToOne) {
    for (const SurfaceShape& shape : AllShapes()) {
        for (const ButterflyRule& rule : kRules) {
            const auto refined = RefineByButterflyOracle(SurfaceOf(shape), rule, 2);
            for (std::size_t l = 0; l < refined.steps.size(); ++l) {
                const SparseRows& step = refined.steps[l];
                const SurfaceLevel &coarse = refined.levels[l], &fine = refined.levels[l + 1];
                for (int r = 0; r < step.n_rows(); ++r) {
                    const auto first = step.weights.begin() + step.offsets[r];
                    const auto last = step.weights.begin() + step.offsets[r + 1];
                    EXPECT_NEAR(std::accumulate(first, last, 0.0), 1, kRoundOff) << shape.name << " row " << r;
                }
                for (int v = 0; v < coarse.n_vertices; ++v) {
                    const int child = coarse.children_of_vertices[v];
                    for (int i = 0; i < 3; ++i) {
                        EXPECT_EQ(fine.positions[3 * child + i], coarse.positions[3 * v + i]) << shape.name;
                    }
                }
            }
        }
    }
}

TEST_F(ButterflyOracle, ReproducesCubicsInTheRegularLattice) {
    const Cone cone = MakeCone(6, true, 5);
    // One polynomial a coordinate: together they have all monomials of degree 3.
    const auto cubics = [](double x, double y) {
        return std::array{1 + x - 2 * y + x * y + x * x * x, y * y - x * x + 2 * x * x * y - y * y * y,
                          3 * x * y * y + x * x - y};
    };
    const auto largest_error = [&](const ButterflyRule& rule) {
        ControlSurface surface = cone.surface;
        for (std::size_t v = 0; v < surface.positions.size(); v += 3) {
            const auto f = cubics(surface.positions[v], surface.positions[v + 1]);
            std::copy(f.begin(), f.end(), surface.positions.begin() + static_cast<std::ptrdiff_t>(v));
        }
        const auto refined = RefineByButterflyOracle(surface, rule, 1);
        double error = 0;
        for (std::size_t e = 0; e < refined.levels[0].edges.size(); ++e) {
            const auto [a, b] = refined.levels[0].edges[e];
            if (!cone.IsWithin(a, 3) || !cone.IsWithin(b, 3)) continue;  // all ten points are in the cone
            const auto& p = cone.surface.positions;
            const auto f = cubics((p[3 * a] + p[3 * b]) / 2, (p[3 * a + 1] + p[3 * b + 1]) / 2);
            const int v = refined.levels[0].children_of_edges[e];
            for (int i = 0; i < 3; ++i)
                error = std::max(error, std::abs(refined.levels[1].positions[3 * v + i] - f[i]));
        }
        return error;
    };
    constexpr double kOfValues = 1e-11;  // values of size 200 in place of 1
    EXPECT_LT(largest_error(ButterflyRule::Plain()), kOfValues);
    for (const double w : {0.0, 1.0 / 64, -1.0 / 32}) {
        EXPECT_LT(largest_error(ButterflyRule::Modified(w)), kOfValues) << w;
    }
    EXPECT_GT(largest_error(ButterflyRule::Plain(1.0 / 16 + 1e-6)), 1e-7);
}

TEST_F(ButterflyOracle, CompositeRowsGiveThePositions) {
    for (const SurfaceShape& shape : AllShapes()) {
        const auto refined = RefineByButterflyOracle(SurfaceOf(shape), ButterflyRule::Modified(), 3, 3);
        for (std::size_t l = 1; l < refined.levels.size(); ++l) {
            const SurfaceLevel& level = refined.levels[l];
            ASSERT_EQ(level.row_offsets.size(), static_cast<std::size_t>(level.n_vertices) + 1);
            const auto positions =
                Apply(SparseRows{level.row_offsets, level.row_indices, level.row_weights}, shape.positions);
            for (std::size_t i = 0; i < positions.size(); ++i) {
                ASSERT_NEAR(positions[i], level.positions[i], kRoundOff * 10) << shape.name;  // sizes up to 10
            }
        }
    }
}

TEST_F(ButterflyOracle, IsIndependentOfTheNumbering) {
    for (const SurfaceShape& shape : AllShapes()) {
        ControlSurface surface = SurfaceOf(shape);
        const auto first = RefineByButterflyOracle(surface, ButterflyRule::Modified(), 2);
        // Triangles come in another order and begin at another vertex; vertices keep their numbers, which match levels.
        std::mt19937 engine(7);
        for (std::size_t t = surface.triangles.size(); t-- > 1;) {
            std::swap(surface.triangles[t], surface.triangles[engine() % (t + 1)]);
        }
        for (Triangle& t : surface.triangles) std::rotate(t.begin(), t.begin() + engine() % 3, t.end());
        const auto second = RefineByButterflyOracle(surface, ButterflyRule::Modified(), 2);
        const Findings findings = CompareLevels(second.levels, first.levels);
        EXPECT_TRUE(findings.Passes(kRoundOff)) << shape.name << " " << findings.where << findings.largest_error;
    }
}

TEST_F(ButterflyOracle, RefusesTagsOnWhatIsNotThere) {
    const ControlSurface cone = MakeCone(3, true, 2).surface;
    EXPECT_THROW(RefineByButterflyOracle(WithCreases(cone, {{0, 9}}), ButterflyRule(), 1), std::runtime_error);
    ControlSurface faded = WithCreases(cone, {{0, 1}});
    faded.tags.crease_sharpness[0] = 2;
    EXPECT_THROW(RefineByButterflyOracle(faded, ButterflyRule(), 1), std::runtime_error);
    EXPECT_THROW(RefineByButterflyOracle(WithCreases(cone, {}, {cone.n_vertices}), ButterflyRule(), 1),
                 std::runtime_error);
}

TEST_F(ButterflyOracle, ComparisonOfLevelsCatchesFaults) {
    const ControlSurface cone = MakeCone(5, true, 2).surface;
    const auto oracle = RefineByButterflyOracle(cone, ButterflyRule::Modified(), 2).levels;
    EXPECT_TRUE(CompareLevels(oracle, oracle).Passes(0));

    auto moved = oracle;
    moved[1].positions[4] += 1e-6;
    EXPECT_FALSE(CompareLevels(moved, oracle).Passes(1e-12));
    auto swapped = oracle;
    std::swap(swapped[0].children_of_edges[2], swapped[0].children_of_edges[9]);
    EXPECT_THAT(CompareLevels(swapped, oracle).faults, testing::SizeIs(1));
    auto turned = oracle;
    std::swap(turned[2].triangles[3][0], turned[2].triangles[3][1]);
    EXPECT_THAT(CompareLevels(turned, oracle).faults, testing::ElementsAre(testing::HasSubstr("level 2")));
    auto short_of_one = oracle;
    short_of_one.pop_back();
    EXPECT_THAT(CompareLevels(short_of_one, oracle).faults, testing::SizeIs(1));
}

TEST_F(ButterflyOracle, ChildrenAreFoundFromTrianglesAndOddSplitsRefused) {
    // A tetrahedron split by hand: new vertices 4 to 9 on 01, 02, 03, 12, 13, 23.
    SurfaceLevel coarse, fine;
    coarse.n_vertices = 4;
    coarse.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
    fine.n_vertices = 10;
    const std::map<std::array<int, 2>, int> child = {{{0, 1}, 4}, {{0, 2}, 5}, {{0, 3}, 6},
                                                     {{1, 2}, 7}, {{1, 3}, 8}, {{2, 3}, 9}};
    const auto on = [&](int a, int b) { return child.at({std::min(a, b), std::max(a, b)}); };
    for (const auto& [a, b, c] : coarse.triangles) {
        const int ab = on(a, b), bc = on(b, c), ca = on(c, a);
        for (const Triangle& t : {Triangle{a, ab, ca}, Triangle{b, bc, ab}, Triangle{c, ca, bc}, Triangle{ab, bc, ca}})
            fine.triangles.push_back(t);
    }
    FindChildren(coarse, fine);
    ASSERT_EQ(coarse.edges.size(), 6U);
    for (std::size_t e = 0; e < 6; ++e) {
        EXPECT_EQ(coarse.children_of_edges[e], on(coarse.edges[e][0], coarse.edges[e][1]));
    }
    EXPECT_THAT(coarse.children_of_vertices, testing::ElementsAre(0, 1, 2, 3));

    SurfaceLevel turned = fine, missing = fine, joined = fine;
    std::swap(turned.triangles[5][0], turned.triangles[5][1]);
    missing.triangles.pop_back();
    for (Triangle& t : joined.triangles) std::replace(t.begin(), t.end(), 9, 8);
    for (const SurfaceLevel* odd : {&turned, &missing, &joined}) {
        EXPECT_THROW(FindChildren(coarse, *odd), std::runtime_error);
    }
}

}  // namespace
}  // namespace SolidSubdiv::Validation
