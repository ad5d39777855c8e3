// SPDX-License-Identifier: Apache-2.0
// Laws of locating points: places give back their points, shared faces have one owner, distances are least.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <solidsubdiv/kit/geometry/locator.h>
#include <solidsubdiv/sdc/parallel.h>

#include <cstring>

#include "kit/geometry/place_testing.h"

namespace SolidSubdiv::Geometry {
namespace {

/// Every place in range, every point within the tolerance of its place's; none outside.
void ExpectFound(const TestSolid& s, const Locator& locator, const std::vector<double>& points, const Location& found) {
    ASSERT_EQ(found.places.size(), points.size() / 3) << s.name;
    EXPECT_TRUE(found.outside.empty()) << s.name << ": point " << found.outside.front().point << " is said to be "
                                       << found.outside.front().distance << " off";
    const std::vector<double> there = PointsOf(s, found.places);
    for (std::size_t i = 0; i < found.places.size(); ++i) {
        EXPECT_TRUE(IsWithin(CoordinatesOf(s, found.places[i].element), found.places[i].at)) << s.name << ": " << i;
        // Twice: the test's own sums round too.
        EXPECT_LE(DistanceOf(points, there, i, i), 2 * locator.round_off()) << s.name << ": point " << i;
    }
}

TEST(Locator, PlacesOfPointsOfPlaces_HaveTheSamePoints) {
    for (const TestSolid& s : TestSolids()) {
        const Locator locator(s.refiner, s.level, s.positions);
        const auto places = RandomPlaces(s, 2000, 1);
        const auto points = PointsOf(s, places);
        const Location found = locator.Locate(points);
        ExpectFound(s, locator, points, found);
        for (std::size_t i = 0; i < places.size(); ++i) {
            EXPECT_LE(found.places[i].element, places[i].element) << s.name << ": the lowest cell holds point " << i;
        }
    }
}

TEST(Locator, PointsInsideCellsOfABlock_AreInTheirCellsAlone) {
    TestShapes::Shape tets = TestShapes::KuhnBlock(3);
    TestShapes::PolyhedralShape hexes = TestShapes::HexBlock(3);
    TestShapes::Random random(3);
    for (double& x : tets.positions) x += 0.05 * random.Uniform();
    for (double& x : hexes.positions) x += 0.05 * random.Uniform();
    for (int level = 0; level <= 2; ++level) {
        for (const TestSolid& s : {TetSolid("tets", tets, level), PolyhedralSolid("hexes", hexes, level)}) {
            const Locator locator(s.refiner, s.level, s.positions);
            const auto places = RandomPlaces(s, 3000, 4);
            const Location found = locator.Locate(PointsOf(s, places));
            for (std::size_t i = 0; i < places.size(); ++i) {
                if (!IsWithin(CoordinatesOf(s, places[i].element), places[i].at, 1e-9)) continue;
                EXPECT_EQ(found.places[i].element, places[i].element) << s.name;
                for (std::size_t k = 0; k < 3; ++k) {
                    // Points agree to 1e-14; cells of level 2 are 1/10 wide and not very flat.
                    EXPECT_NEAR(found.places[i].at[k], places[i].at[k], 1e-11) << s.name;
                }
            }
        }
    }
}

/// Vertices, middles of edges and of faces, with the lowest cell that has each.
TEST(Locator, SharedVerticesEdgesAndFaces_BelongToTheLowestCell) {
    TestShapes::Shape block = TestShapes::KuhnBlock(3);
    TestShapes::Jitter(block, 0.05, 5);
    for (int turn = 0; turn < 3; ++turn) {  // other axes, another layout of the hierarchy
        for (std::size_t v = 0; v < block.positions.size(); v += 3) {
            std::rotate(&block.positions[v], &block.positions[v] + 1, &block.positions[v] + 3);
        }
        const TestSolid s = TetSolid("block", block, 0);
        std::map<std::vector<Index>, Index> lowest;  // of each set of one to three vertices of a cell
        for (Index t = 0; t < s.refiner.level(0).n_tets; ++t) {
            const auto v = s.refiner.level(0).TetVertices(t);
            for (unsigned set = 1; set < 15; ++set) {
                std::vector<Index> key;
                for (std::size_t i = 0; i < 4; ++i) {
                    if (set >> i & 1) key.push_back(v[i]);
                }
                std::sort(key.begin(), key.end());
                lowest.try_emplace(key, t);
            }
        }
        std::vector<double> points;
        std::vector<Index> expected;
        for (const auto& [vertices, cell] : lowest) {
            for (std::size_t c = 0; c < 3; ++c) {
                double sum = 0;
                for (Index v : vertices) sum += s.positions[3 * static_cast<std::size_t>(v) + c];
                points.push_back(sum / static_cast<double>(vertices.size()));
            }
            expected.push_back(cell);
        }
        const Location found = Locator(s.refiner, 0, s.positions).Locate(points);
        EXPECT_TRUE(found.outside.empty());
        for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_EQ(found.places[i].element, expected[i]);
    }
}

TEST(Locator, BoundaryPointsMovedByRoundOff_AreInside_MovedFurtherAreOutside) {
    for (const double offset : {0.0, 1e6}) {  // far from the origin coordinates are known less well
        TestShapes::PolyhedralShape block = TestShapes::HexBlock(2);
        for (double& x : block.positions) x += offset;
        const TestSolid s = PolyhedralSolid("block", block, 0);
        const Locator locator(s.refiner, 0, s.positions);
        TestShapes::Random random(6);
        std::vector<double> on, near, off;
        for (int i = 0; i < 600; ++i) {
            std::array<double, 3> p{1 + random.Uniform(), 1 + random.Uniform(), 1 + random.Uniform()};
            const auto axis = static_cast<std::size_t>(i % 3);
            p[axis] = i % 2 == 0 ? 0 : 2;
            const double outward = i % 2 == 0 ? -1 : 1;
            for (std::size_t k = 0; k < 3; ++k) {
                const double x = p[k] + offset, way = k == axis ? outward : 0;
                on.push_back(x);
                near.push_back(x + way * 0.5 * locator.round_off());
                off.push_back(x + way * 10 * locator.round_off());
            }
        }
        EXPECT_TRUE(locator.Locate(on).outside.empty());
        EXPECT_TRUE(locator.Locate(near).outside.empty());
        const Location outside = locator.Locate(off);
        ASSERT_EQ(outside.outside.size(), 600u);
        for (const OutsidePoint& p : outside.outside) {
            EXPECT_NEAR(p.distance, 10 * locator.round_off(), locator.round_off());
        }
        EXPECT_TRUE(locator.Locate(off, {.tolerance = 20 * locator.round_off()}).outside.empty());
    }
}

TEST(Locator, OutsideABlock_DistancesAreThoseFromItsBox) {
    for (const TestSolid& s :
         {TetSolid("tets", TestShapes::KuhnBlock(3), 0), PolyhedralSolid("hexes", TestShapes::HexBlock(3), 0)}) {
        TestShapes::Random random(7);
        std::vector<double> points;
        for (int i = 0; i < 3000; ++i) points.push_back(1.5 + 5 * random.Uniform());
        const Location found = Locator(s.refiner, 0, s.positions).Locate(points);
        std::size_t k = 0;
        for (std::size_t i = 0; i < points.size() / 3; ++i) {
            double square = 0;
            for (std::size_t c = 0; c < 3; ++c) {
                const double x = points[3 * i + c], gap = std::max({0.0, -x, x - 3});
                square += gap * gap;
            }
            if (square == 0) continue;
            ASSERT_LT(k, found.outside.size()) << s.name;
            EXPECT_EQ(found.outside[k].point, static_cast<Index>(i)) << s.name;
            EXPECT_NEAR(found.outside[k++].distance, std::sqrt(square), 1e-12)
                << s.name;  // rounding of numbers below 10
        }
        EXPECT_EQ(k, found.outside.size()) << s.name;
    }
}

TEST(Locator, OutsideAnySolid_DistancesAreReachedAndNoOtherPlaceIsNearer) {
    for (const TestSolid& s : TestSolids()) {
        if (s.level == 2) continue;  // brute force
        TestShapes::Random random(8);
        std::vector<double> points;
        for (int i = 0; i < 60; ++i) points.push_back(1 + 4 * random.Uniform());
        const Location found = Locator(s.refiner, s.level, s.positions).Locate(points);
        const std::vector<double> nearest = PointsOf(s, found.places), samples = PointsOf(s, RandomPlaces(s, 20000, 9));
        for (const OutsidePoint& p : found.outside) {
            const auto i = static_cast<std::size_t>(p.point);
            EXPECT_TRUE(IsWithin(CoordinatesOf(s, found.places[i].element), found.places[i].at)) << s.name;
            EXPECT_NEAR(DistanceOf(points, nearest, i, i), p.distance, 1e-13) << s.name;
            for (std::size_t k = 0; k < samples.size() / 3; ++k) {
                EXPECT_GE(DistanceOf(points, samples, i, k), p.distance * (1 - 2e-6)) << s.name << ": point " << i;
            }
        }
    }
}

TEST(Locator, BitsDependOnNeitherThreadsNorTheOrderOfPoints) {
    const TestSolid s = TetSolid("block", TestShapes::KuhnBlock(4), 1);
    TestShapes::Random random(10);
    std::vector<double> points;
    for (int i = 0; i < 30000; ++i) points.push_back(2 + 2.2 * random.Uniform());
    const auto locate = [&](int n_threads, const std::vector<double>& p) {
        const Sdc::ThreadLimit limit(n_threads);
        return Locator(s.refiner, s.level, s.positions).Locate(p);
    };
    const auto is_same = [](const Far::Place& a, const Far::Place& b) {
        return a.element == b.element && a.part == b.part && std::memcmp(a.at.data(), b.at.data(), sizeof a.at) == 0;
    };
    const Location one = locate(1, points), four = locate(4, points);
    ASSERT_GT(one.outside.size(), 100u);
    ASSERT_EQ(one.outside.size(), four.outside.size());
    for (std::size_t i = 0; i < one.places.size(); ++i) EXPECT_TRUE(is_same(one.places[i], four.places[i]));
    for (std::size_t i = 0; i < one.outside.size(); ++i) {
        EXPECT_EQ(one.outside[i].point, four.outside[i].point);
        EXPECT_EQ(one.outside[i].distance, four.outside[i].distance);
    }
    std::vector<double> backwards;
    for (std::size_t i = points.size(); i > 0; i -= 3) {
        backwards.insert(backwards.end(), &points[i - 3], &points[i - 3] + 3);
    }
    const Location turned = locate(3, backwards);
    for (std::size_t i = 0; i < one.places.size(); ++i) {
        EXPECT_TRUE(is_same(one.places[i], turned.places[one.places.size() - 1 - i]));
    }
}

TEST(Locator, WithoutNearestPlaces_OutsidePointsHaveNone) {
    const TestSolid s = TetSolid("tet", TestShapes::SingleTet(), 0);
    const Location found =
        Locator(s.refiner, 0, s.positions).Locate(std::vector<double>{.1, .1, .1, 2, 2, 2}, {.wants_nearest = false});
    EXPECT_EQ(found.places[0].element, 0);
    EXPECT_EQ(found.places[1].element, kNoIndex);
    ASSERT_EQ(found.outside.size(), 1u);
    EXPECT_EQ(found.outside[0].point, 1);
}

TEST(Locator, StopsWhenProgressSaysSo) {
    const TestSolid s = TetSolid("tet", TestShapes::SingleTet(), 0);
    const Locator locator(s.refiner, 0, s.positions);
    std::vector<std::string> stages;
    const auto note = [&](std::string_view stage, double) {
        stages.emplace_back(stage);
        return stage != "nearest places";
    };
    EXPECT_THROW(locator.Locate(std::vector<double>{2, 2, 2}, {.progress = note}), Cancelled);
    EXPECT_EQ(stages, (std::vector<std::string>{"locate", "nearest places"}));
}

/// The text of the InvalidInput that a step throws.
template <class Step>
std::string Refusal(Step&& step) {
    try {
        step();
    } catch (const InvalidInput& error) {
        return error.what();
    }
    return "nothing was refused";
}

TEST(Locator, RefusesWhatItCannotUse_ByName) {
    const TestSolid s = TetSolid("tet", TestShapes::SingleTet(), 0);
    const Locator locator(s.refiner, 0, s.positions);
    const double nan = std::nan("");
    using testing::HasSubstr;
    EXPECT_THAT(Refusal([&] {
                    locator.Locate(std::vector<double>{0, 0, 0, 0, nan, 0});
                }),
                HasSubstr("point 1: coordinate 1 is nan"));
    EXPECT_THAT(Refusal([&] { locator.Locate(std::vector<double>{1e80, 0, 0}); }), HasSubstr("point 0: coordinate 0"));
    EXPECT_THAT(Refusal([&] { locator.Locate(std::vector<double>{0, 0}); }), HasSubstr("2 numbers"));
    EXPECT_THAT(Refusal([&] { locator.Locate(s.positions, {.tolerance = nan}); }), HasSubstr("tolerance"));
    EXPECT_THAT(Refusal([&] { Locator(s.refiner, 1, s.positions); }), HasSubstr("level 1"));
    EXPECT_THAT(Refusal([&] { Locator(s.refiner, 0, std::span(s.positions).first(9)); }), HasSubstr("9 numbers"));
    std::vector<double> bad = s.positions;
    bad[5] = -HUGE_VAL;
    EXPECT_THAT(Refusal([&] { Locator(s.refiner, 0, bad); }), HasSubstr("vertex 1: coordinate 2 is -inf"));
    const TestSolid surface = TetSolid("surface", TestShapes::OctahedronSurface(), 0);
    EXPECT_THAT(Refusal([&] { Locator(surface.refiner, 0, surface.positions); }), HasSubstr("no cells"));
}

}  // namespace
}  // namespace SolidSubdiv::Geometry
