// SPDX-License-Identifier: Apache-2.0
// Laws of octree lattices: which cells there are, how levels hang together, what models they take.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <solidsubdiv/sdc/parallel.h>

#include <set>

#include "apps/deform/octree_testing.h"

namespace SolidSubdiv::Deform {
namespace {

using Geometry::BoxKind;
using Place = std::array<Index, 3>;
using Point = std::array<double, 3>;
constexpr BoxKind kBoxes[] = {BoxKind::AxisAligned, BoxKind::Oriented, BoxKind::Minimum};
constexpr Cut kCuts[] = {Cut::None, Cut::Vertices, Cut::Triangles, Cut::Outside};

LatticeHierarchy Make(const Model& model, const OctreeOptions& options) {
    return MakeOctreeLattices(model.points, model.triangles, options);
}

std::set<Place> CellsOf(const LatticeLevel& level) { return {level.cells.begin(), level.cells.end()}; }

/// Points in cells of the grid of a level.
std::vector<Point> InGrid(const LatticeHierarchy& h, int level, const std::vector<double>& points) {
    std::vector<Point> at;
    for (std::size_t i = 0; i < points.size(); i += 3) {
        at.push_back(h.box.CoordinatesOf(std::span(points).subspan(i).first<3>()));
        for (std::size_t k = 0; k < 3; ++k) at.back()[k] *= std::ldexp(1., level) / h.box.lengths[k];
    }
    return at;
}

/// Whether anything is left of a triangle when all that lies beyond the six sides of a cell is cut off. The cell is
/// grown by `margin` on every side.
bool ReachesInto(std::vector<Point> polygon, const Place& cell, double margin) {
    for (std::size_t k = 0; k < 3; ++k) {
        for (int side = 0; side < 2; ++side) {
            const auto depth = [&](const Point& p) {
                return side == 0 ? p[k] - (cell[k] - margin) : cell[k] + 1 + margin - p[k];
            };
            std::vector<Point> rest;
            for (std::size_t i = 0; i < polygon.size(); ++i) {
                const Point &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
                if (depth(a) >= 0) rest.push_back(a);
                if ((depth(a) < 0) == (depth(b) < 0)) continue;
                const double t = depth(a) / (depth(a) - depth(b));
                rest.push_back({a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])});
            }
            polygon = rest;
        }
    }
    return !polygon.empty();
}

TEST(OctreeLattices, OneCellBecomesEightAgainAndAgain) {
    const auto h = Make(Torus(4), {.levels = 5, .cut = Cut::None});
    Index cells = 1, side = 2;
    for (const LatticeLevel& level : h.levels) {
        EXPECT_EQ(level.lattice.n_cells(), cells);
        EXPECT_EQ(level.cells.size(), static_cast<std::size_t>(cells));
        EXPECT_EQ(level.lattice.n_control_points(), side * side * side);
        cells *= 8;
        side = 2 * side - 1;
    }
    EXPECT_EQ(cells, 8 * 32768);
}

TEST(OctreeLattices, CellsAreHalvesOfTheirParentsAndFollowEachOther) {
    for (Cut cut : kCuts) {
        const auto h = Make(Torus(24), {.levels = 4, .cut = cut});
        EXPECT_TRUE(h.levels[0].parents.empty());
        for (std::size_t i = 1; i < h.levels.size(); ++i) {
            const LatticeLevel& level = h.levels[i];
            ASSERT_EQ(level.parents.size(), level.cells.size());
            EXPECT_TRUE(std::is_sorted(level.parents.begin(), level.parents.end()));
            std::set<Index> parents;
            for (std::size_t c = 0; c < level.cells.size(); ++c) {
                const Place& parent = h.levels[i - 1].cells[static_cast<std::size_t>(level.parents[c])];
                for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(level.cells[c][k] / 2, parent[k]);
                parents.insert(level.parents[c]);
            }
            EXPECT_EQ(parents.size(), h.levels[i - 1].cells.size());  // no cell without a child
            EXPECT_EQ(CellsOf(level).size(), level.cells.size());     // none twice
        }
    }
}

TEST(OctreeLattices, HexahedraLieWhereTheirPlacesAre) {
    for (BoxKind box : kBoxes) {
        const auto h = Make(Torus(24), {.box = box, .levels = 3});
        for (int i = 0; i <= 3; ++i) {
            const LatticeLevel& level = h.levels[static_cast<std::size_t>(i)];
            const auto at = InGrid(h, i, level.lattice.positions);
            for (std::size_t c = 0; c < level.cells.size(); ++c) {
                for (std::size_t k = 0; k < 3; ++k) {
                    double low = 1e9, high = -1e9;
                    for (std::size_t j = 0; j < 8; ++j) {
                        const double x = at[static_cast<std::size_t>(level.lattice.hexes[8 * c + j])][k];
                        low = std::min(low, x);
                        high = std::max(high, x);
                    }
                    EXPECT_NEAR(low, level.cells[c][k], 1e-13);  // rounding of coordinates near 4
                    EXPECT_NEAR(high, level.cells[c][k] + 1, 1e-13);
                }
            }
            EXPECT_EQ(CountBadCells(level.lattice), 0u);
        }
    }
}

TEST(OctreeLattices, ControlPointsAreTheOctreeRuleOfTheLevelBefore) {
    for (Cut cut : kCuts) {
        const auto h = Make(Torus(24), {.box = BoxKind::Oriented, .levels = 4, .cut = cut});
        EXPECT_EQ(h.levels[0].octree_rule.n_rows(), 0);
        for (std::size_t i = 1; i < h.levels.size(); ++i) {
            const auto& rule = h.levels[i].octree_rule;
            ASSERT_EQ(rule.n_rows(), h.levels[i].lattice.n_control_points());
            ASSERT_EQ(rule.n_sources, h.levels[i - 1].lattice.n_control_points());
            for (Index v = 0; v < rule.n_rows(); ++v) {
                const auto indices = rule.Indices(v);
                const auto weights = rule.Weights(v);
                EXPECT_TRUE(indices.size() == 1 || indices.size() == 2 || indices.size() == 4 || indices.size() == 8);
                EXPECT_TRUE(std::is_sorted(indices.begin(), indices.end()));
                for (std::size_t c = 0; c < 3; ++c) {
                    double x = 0;
                    for (std::size_t k = 0; k < indices.size(); ++k) {
                        EXPECT_EQ(weights[k], 1. / static_cast<double>(indices.size()));
                        x += weights[k] *
                             h.levels[i - 1].lattice.positions[3 * static_cast<std::size_t>(indices[k]) + c];
                    }
                    EXPECT_NEAR(x, h.levels[i].lattice.positions[3 * static_cast<std::size_t>(v) + c], 4e-15);
                }
            }
        }
    }
}

TEST(OctreeLattices, CutsByVerticesLeaveTheCellsWithVertices) {
    for (const Model& model : Models()) {
        for (BoxKind box : kBoxes) {
            const auto h = Make(model, {.box = box, .levels = 4});
            for (int i = 0; i <= 4; ++i) {
                std::set<Place> expected;
                const double last = std::ldexp(1., i) - 1;
                for (const Point& p : InGrid(h, i, model.points)) {
                    Place cell;
                    for (std::size_t k = 0; k < 3; ++k)
                        cell[k] = static_cast<Index>(std::clamp(std::floor(p[k]), 0., last));
                    expected.insert(cell);
                }
                EXPECT_EQ(CellsOf(h.levels[static_cast<std::size_t>(i)]), expected) << model.name << ", level " << i;
            }
        }
    }
}

TEST(OctreeLattices, CutsByTrianglesLeaveTheCellsThatTheyReachInto) {
    for (const Model& model : {Torus(9), Models()[5], Models()[6], Models()[8]}) {
        for (BoxKind box : {BoxKind::AxisAligned, BoxKind::Oriented}) {
            const int level = 3;
            const auto h = Make(model, {.box = box, .levels = level, .cut = Cut::Triangles});
            const auto at = InGrid(h, level, model.points);
            const std::set<Place> cells = CellsOf(h.levels.back()),
                                  by_vertices = CellsOf(Make(model, {.box = box, .levels = level}).levels.back());
            EXPECT_TRUE(std::includes(cells.begin(), cells.end(), by_vertices.begin(), by_vertices.end()));
            for (int i = 0; i < 512; ++i) {
                const Place cell{i % 8, i / 8 % 8, i / 64};
                bool surely = by_vertices.contains(cell), perhaps = surely;
                for (std::size_t t = 0; t < model.triangles.size(); t += 3) {
                    std::vector<Point> triangle;
                    for (std::size_t k = 0; k < 3; ++k)
                        triangle.push_back(at[static_cast<std::size_t>(model.triangles[t + k])]);
                    surely = surely || ReachesInto(triangle, cell, 0);
                    perhaps = perhaps || ReachesInto(triangle, cell, 1e-6);
                }
                if (surely) {
                    EXPECT_TRUE(cells.contains(cell)) << model.name << ": missing";
                }
                if (!perhaps) {
                    EXPECT_FALSE(cells.contains(cell)) << model.name << ": too many";
                }
            }
        }
    }
}

TEST(OctreeLattices, EveryModelGetsLatticesThatHoldIt) {
    for (const Model& model : Models()) {
        for (BoxKind box : kBoxes) {
            for (Cut cut : kCuts) {
                const auto h = Make(model, {.box = box, .levels = 3, .cut = cut});
                for (const LatticeLevel& level : h.levels) {
                    EXPECT_EQ(CountOutside(level.lattice, model.points), 0u) << model.name;
                    EXPECT_EQ(CountBadCells(level.lattice), 0u) << model.name;
                }
            }
        }
    }
}

TEST(OctreeLattices, PlantedFaultsAreFoundByTheLawsAbove) {
    auto h = Make(Torus(24), {.levels = 3});
    ControlLattice without = h.levels[3].lattice;
    without.hexes.erase(without.hexes.begin(), without.hexes.begin() + 8);
    EXPECT_GT(CountOutside(without, Torus(24).points), 0u);
    ControlLattice folded = h.levels[3].lattice;
    folded.positions[3 * static_cast<std::size_t>(folded.hexes[6])] -= 2 * h.box.lengths[0] / 8;
    EXPECT_GT(CountBadCells(folded), 0u);
    auto other = h;
    other.levels[2].lattice.positions[0] = std::nextafter(other.levels[2].lattice.positions[0], 9);
    EXPECT_FALSE(SameHierarchy(h, other));
}

TEST(OctreeLattices, NeitherTheOrderOfTheModelNorThreadsMatterByABit) {
    const Model model = Torus(60);
    const std::size_t n = model.points.size() / 3;
    std::vector<Index> order(n), place(n);
    for (std::size_t i = 0; i < n; ++i) order[i] = static_cast<Index>(i);
    TestShapes::Random random(9);
    random.Shuffle(order);
    Model other{"shuffled", {}, {}};
    for (std::size_t i = 0; i < n; ++i) {
        const auto from = model.points.begin() + 3 * std::ptrdiff_t{order[i]};
        other.points.insert(other.points.end(), from, from + 3);
        place[static_cast<std::size_t>(order[i])] = static_cast<Index>(i);
    }
    for (std::size_t t = model.triangles.size(); t > 0; t -= 3) {
        for (std::size_t k : {2, 3, 1})
            other.triangles.push_back(place[static_cast<std::size_t>(model.triangles[t - k])]);
    }
    for (BoxKind box : kBoxes) {
        for (Cut cut : kCuts) {
            OctreeOptions options{.box = box, .levels = 4, .cut = cut};
            options.shrink = cut == Cut::Vertices || cut == Cut::Outside;
            const auto h = Make(model, options);
            EXPECT_TRUE(SameHierarchy(h, Make(other, options)));
            const Sdc::ThreadLimit one(1);
            EXPECT_TRUE(SameHierarchy(h, Make(model, options)));
        }
    }
}

TEST(OctreeLattices, ThinBoxesAreWidenedAroundTheirMiddle) {
    const auto box = [](const std::vector<double>& points, double padding = 0) {
        return MakeOctreeLattices(points, {}, {.levels = 0, .padding = padding}).box;
    };
    EXPECT_EQ(box({3, 4, 5}).lengths, (Point{1, 1, 1}));
    EXPECT_EQ(box({3, 4, 5}).corner, (Point{2.5, 3.5, 4.5}));
    EXPECT_EQ(box({3e7, 4, 5}).lengths[0], 30);  // a millionth of the largest coordinate
    EXPECT_THAT(box({0, 0, 0, 4, 0, 0}).lengths, testing::ElementsAre(4, .04, .04));
    EXPECT_THAT(box({0, 0, 0, 4, 2, 0}).lengths, testing::ElementsAre(4, 2, .04));
    EXPECT_THAT(box({0, 0, 0, 4, 2, 0}).corner, testing::ElementsAre(0, 0, -.02));
    EXPECT_THAT(box({0, 0, 0, 4, 2, 1}, .25).lengths, testing::ElementsAre(6, 4, 3));
    EXPECT_THAT(box({0, 0, 0, 4, 2, 1}, .25).corner, testing::ElementsAre(-1, -1, -1));
}

TEST(OctreeLattices, ARegionLeavesOutWhatLiesElsewhere) {
    const Model model = Torus(40);
    const Geometry::Box region{{.5, -1, -2}, {3, 1.5, 2}};
    std::vector<double> in;
    for (std::size_t i = 0; i < model.points.size(); i += 3) {
        const double* p = &model.points[i];
        if (p[0] >= .5 && p[0] <= 3 && p[1] >= -1 && p[1] <= 1.5 && p[2] >= -2 && p[2] <= 2)
            in.insert(in.end(), p, p + 3);
    }
    ASSERT_FALSE(in.empty());
    OctreeOptions options{.levels = 4, .region = region};
    EXPECT_EQ(Make(model, options).box.corner, region.low);
    for (BoxKind box : {BoxKind::Oriented, BoxKind::Minimum}) {
        options.box = box;
        EXPECT_TRUE(SameHierarchy(Make(model, options), MakeOctreeLattices(in, {}, {.box = box, .levels = 4})));
    }
    options.cut = Cut::Triangles;
    const auto h = Make(model, options);
    EXPECT_EQ(CountOutside(h.levels.back().lattice, in), 0u);
    EXPECT_GT(h.levels.back().cells.size(), MakeOctreeLattices(in, {}, options).levels.back().cells.size());
}

TEST(OctreeLattices, BadInputIsNamed) {
    const auto message = [](const Model& model, const OctreeOptions& options) -> std::string {
        try {
            Make(model, options);
        } catch (const InvalidInput& e) {
            return e.what();
        }
        return {};
    };
    const Model good{"", {0, 0, 0, 1, 1, 1}, {}};
    using testing::HasSubstr;
    EXPECT_THAT(message({}, {}), HasSubstr("there is no point"));
    EXPECT_THAT(message({"", {1, 2}, {}}, {}), HasSubstr("2 numbers"));
    EXPECT_THAT(message({"", {1, 2, 3, 4, NAN, 6}, {}}, {}), HasSubstr("point 1: coordinate 1"));
    EXPECT_THAT(message({"", {1, 2, 3}, {0, 0, 1}}, {}), HasSubstr("triangle 0 names point 1 of 1"));
    EXPECT_THAT(message(good, {.levels = 11}), HasSubstr("levels is 11"));
    EXPECT_THAT(message(good, {.padding = -1}), HasSubstr("padding"));
    EXPECT_THAT(message(good, {.offset = NAN}), HasSubstr("offset"));
    EXPECT_THAT(message(good, {.region = Geometry::Box{}}), HasSubstr("region"));
    EXPECT_THAT(message(good, {.region = Geometry::Box{{5, 5, 5}, {6, 6, 6}}}), HasSubstr("no point lies in"));
    // Refused before anything is made.
    EXPECT_THAT(message(good, {.levels = 10, .cut = Cut::None}), HasSubstr("1073741824 cells, would take"));
    EXPECT_THAT(message(Torus(24), {.levels = 4, .max_bytes = 1000}), HasSubstr("would take"));
    EXPECT_THROW(Make(good, {.progress = [](std::string_view, double) { return false; }}), Cancelled);
}

}  // namespace
}  // namespace SolidSubdiv::Deform
