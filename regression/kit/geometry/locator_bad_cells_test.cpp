// SPDX-License-Identifier: Apache-2.0
// Points in cells that are flat, inverted, folded or lie over each other: none is lost.
#include <gtest/gtest.h>
#include <solidsubdiv/kit/geometry/internal/box_tree.h>
#include <solidsubdiv/kit/geometry/internal/nearest_in_hex.h>
#include <solidsubdiv/kit/geometry/locator.h>

#include "kit/geometry/place_testing.h"

namespace SolidSubdiv::Geometry {
namespace {

/// All random places of a solid are found again.
void ExpectNoneLost(const TestSolid& s, int n_places, std::uint64_t seed) {
    const Locator locator(s.refiner, s.level, s.positions);
    const auto points = PointsOf(s, RandomPlaces(s, n_places, seed));
    const Location found = locator.Locate(points);
    EXPECT_TRUE(found.outside.empty()) << s.name << ": " << found.outside.size() << " lost, the first "
                                       << found.outside.front().distance / locator.round_off() << " round-offs off";
    const auto there = PointsOf(s, found.places);
    for (std::size_t i = 0; i < found.places.size(); ++i) {
        // Twice: the test's own sums round too.
        EXPECT_LE(DistanceOf(points, there, i, i), 2 * locator.round_off()) << s.name << ": point " << i;
    }
}

TEST(LocatorBadCells, FlatAndInvertedTetsHoldTheirPoints) {
    TestShapes::Random random(1);
    for (int i = 0; i < 300; ++i) {
        TestShapes::Shape s = TestShapes::SingleTet();
        for (double& x : s.positions) x = random.Uniform();
        // Vertex 3 in the plane of the others, on a line with two, or on one of them; every other one inverted.
        const double a = i % 3 == 2 ? 0 : random.Uniform(), b = i % 3 == 0 ? random.Uniform() : 0;
        for (std::size_t c = 0; c < 3; ++c) {
            const double* p = s.positions.data() + c;
            s.positions[9 + c] = p[0] + a * (p[3] - p[0]) + b * (p[6] - p[0]);
            if (i % 7 == 0) s.positions[9 + c] += 1e-13 * random.Uniform();  // almost flat
        }
        if (i % 2 == 1) std::swap(s.tets[2], s.tets[3]);
        ExpectNoneLost(TetSolid("flat tet " + std::to_string(i), s, 0), 20, static_cast<std::uint64_t>(i));
    }
}

TEST(LocatorBadCells, FoldedOctahedraHoldTheirPoints) {
    TestShapes::Random random(2);
    for (int i = 0; i < 200; ++i) {
        TestShapes::Shape s = TestShapes::SingleOct();
        for (double& x : s.positions) x = random.Uniform();
        ExpectNoneLost(TetSolid("oct " + std::to_string(i), s, 0), 30, static_cast<std::uint64_t>(i));
    }
}

TEST(LocatorBadCells, HexahedraWithCornersAnywhereHoldTheirPoints) {
    TestShapes::Random random(3);
    for (int i = 0; i < 200; ++i) {
        TestShapes::PolyhedralShape s = TestShapes::HexBlock(1);
        for (double& x : s.positions) x = random.Uniform();  // folded, and again
        ExpectNoneLost(PolyhedralSolid("hex " + std::to_string(i), s, 0), 50, static_cast<std::uint64_t>(i));
    }
}

TEST(LocatorBadCells, HexahedraCollapsedToWedgesPyramidsTetsAndQuadsHoldTheirPoints) {
    // Vertices that become one, in HexBlock's order (bit 0 x, bit 1 y, bit 2 z).
    const std::vector<std::vector<std::array<Index, 2>>> collapses = {
        {{4, 5}, {6, 7}},                                  // a wedge
        {{4, 5}, {4, 6}, {4, 7}},                          // a pyramid
        {{4, 5}, {4, 6}, {4, 7}, {2, 3}},                  // a tet
        {{0, 4}, {1, 5}, {2, 6}, {3, 7}},                  // a quad without thickness
        {{0, 1}, {0, 2}, {0, 3}, {4, 5}, {4, 6}, {4, 7}},  // a segment
    };
    TestShapes::Random random(4);
    for (const auto& pairs : collapses) {
        for (int i = 0; i < 20; ++i) {
            TestShapes::PolyhedralShape s = TestShapes::HexBlock(1);
            for (double& x : s.positions) x += 0.2 * random.Uniform();
            for (const auto& [kept, moved] : pairs) {
                for (int c = 0; c < 3; ++c) s.positions[3 * moved + c] = s.positions[3 * kept + c];
            }
            ExpectNoneLost(PolyhedralSolid(std::to_string(pairs.size()) + " collapsed", s, 0), 50,
                           static_cast<std::uint64_t>(i));
        }
    }
}

TEST(LocatorBadCells, PointsOverAFoldAreOutsideAndTheirDistanceIsTold) {
    // The top of the cube is pushed through its bottom: z = t (1 - 1.5 (1-x)(1-y)) folds near the edge x = y = 0.
    TestShapes::PolyhedralShape s = TestShapes::HexBlock(1);
    s.positions[3 * 4 + 2] = -0.5;  // vertex (0, 0, 1)
    const TestSolid solid = PolyhedralSolid("folded", s, 0);
    const Locator locator(solid.refiner, 0, solid.positions);
    EXPECT_TRUE(locator.Locate(std::vector<double>{0, 0, -0.5, 0, 0, -0.25}).outside.empty());
    const Location above = locator.Locate(std::vector<double>{0, 0, 0.25, 0, 0, -0.75});
    ASSERT_EQ(above.outside.size(), 2u);
    EXPECT_NEAR(above.outside[1].distance, 0.25, 1e-6);  // the corner is the nearest
    EXPECT_GT(above.outside[0].distance, 0.05);
}

/// A point of the map where its Jacobian is singular, between two places of opposite signs, if there is one.
bool FindFold(const Internal::Trilinear& hex, TestShapes::Random& random, Internal::Vec3& point) {
    const auto draw = [&] {
        return 0.5 * (Internal::Vec3{1, 1, 1} + Internal::Vec3{random.Uniform(), random.Uniform(), random.Uniform()});
    };
    const auto det = [&](const Internal::Vec3& at) {
        const auto columns = hex.Jacobian(at);
        return Internal::Det(columns[0], columns[1], columns[2]);
    };
    Internal::Vec3 a = draw(), b = draw();
    if (det(a) * det(b) >= 0) return false;
    for (int k = 0; k < 60; ++k) {
        const Internal::Vec3 middle = 0.5 * (a + b);
        (det(middle) * det(a) > 0 ? a : b) = middle;
    }
    point = hex.PointOf(a);
    return true;
}

TEST(LocatorBadCells, AroundFoldsOfHexahedraNoPlaceIsNearerThanTheNearest) {
    constexpr double kReach = 1.4e-14;
    TestShapes::Random random(7);
    int n_held = 0, n_folds = 0;
    for (int i = 0; i < 2000; ++i) {
        Internal::Trilinear hex;
        for (auto& c : hex.corners) c = {random.Uniform(), random.Uniform(), random.Uniform()};
        Internal::Vec3 p = 0.7 * Internal::Vec3{random.Uniform(), random.Uniform(), random.Uniform()};
        if (i % 2 == 0 && FindFold(hex, random, p)) {
            ++n_folds;
            p = p + std::pow(10.0, -3 - i % 12) * Internal::Vec3{random.Uniform(), random.Uniform(), random.Uniform()};
        }
        for (auto& c : hex.corners) c = c - p;
        const auto nearest = Internal::NearestInHex(hex, kReach, 1e300);
        const bool is_held = Internal::HoldInHex(hex, kReach).distance <= kReach;
        n_held += is_held;
        // What is held has a place within the reach; the nearest may be off by as much again, and its gap.
        EXPECT_LE(is_held ? nearest.distance : 0, 2.1 * kReach) << i;
        EXPECT_EQ(is_held || nearest.distance > kReach, true) << i;
        for (int k = 0; k < 300; ++k) {
            const auto at =
                0.5 * (Internal::Vec3{1, 1, 1} + Internal::Vec3{random.Uniform(), random.Uniform(), random.Uniform()});
            EXPECT_GE(Internal::Length(hex.PointOf(at)), nearest.distance * (1 - 1.1e-6)) << i;
        }
    }
    EXPECT_GT(n_held, 200);
    EXPECT_GT(n_folds, 200);
}

TEST(LocatorBadCells, OfCellsThatLieOverEachOtherTheLowestHoldsThePoint) {
    TestShapes::Shape s = TestShapes::KuhnBlock(2);
    const Index n_tets = static_cast<Index>(s.tets.size() / 4);
    for (std::size_t v = 0; v < 27; ++v) {  // the same once more, over other vertices
        for (std::size_t c = 0; c < 3; ++c) s.positions.push_back(s.positions[3 * v + c]);
    }
    const std::vector<Index> tets = s.tets;
    for (Index v : tets) s.tets.push_back(v + 27);
    s.n_vertices += 27;
    const TestSolid solid = TetSolid("twice", s, 0);
    const auto places = RandomPlaces(solid, 1000, 5);
    const Location found = Locator(solid.refiner, 0, solid.positions).Locate(PointsOf(solid, places));
    for (std::size_t i = 0; i < places.size(); ++i) EXPECT_LE(found.places[i].element, places[i].element % n_tets);
}

TEST(LocatorBadCells, SolidsOfNoSizeAtAllHoldTheirOnlyPoint) {
    TestShapes::Shape s = TestShapes::SingleTet();
    for (double& x : s.positions) x = 3;
    const TestSolid solid = TetSolid("point", s, 0);
    const Location found = Locator(solid.refiner, 0, solid.positions).Locate(std::vector<double>{3, 3, 3, 3, 3, 4});
    ASSERT_EQ(found.outside.size(), 1u);
    EXPECT_EQ(found.outside[0].point, 1);
    EXPECT_DOUBLE_EQ(found.outside[0].distance, 1);
}

TEST(BoxTree, FindsTheBoxesThatHoldAPointAndNoOthers) {
    TestShapes::Random random(6);
    for (const int n : {0, 1, 7, 8, 9, 65, 700}) {
        std::vector<Internal::FloatBox> boxes(static_cast<std::size_t>(n));
        for (auto& box : boxes) {
            for (int k = 0; k < 3; ++k) {
                box.low[k] = static_cast<float>(random.Uniform());
                box.high[k] = box.low[k] + static_cast<float>(0.3 + 0.3 * random.Uniform());
            }
        }
        const Internal::BoxTree tree(boxes);
        for (int i = 0; i < 200; ++i) {
            // Points together and far apart: shared steps down the hierarchy must miss no box.
            std::vector<Internal::BoxTree::Point> points(static_cast<std::size_t>(1 + i % 16));
            const double spread = i % 3 == 0 ? 0.02 : 1;
            for (std::size_t k = 0; k < 3; ++k) {
                const double middle = random.Uniform();
                for (auto& p : points) p[k] = static_cast<float>(middle + spread * random.Uniform());
            }
            std::vector<std::pair<std::size_t, Index>> found, expected;
            tree.ForEachHolding(points, [&](std::size_t p, Index item) { found.emplace_back(p, item); });
            std::sort(found.begin(), found.end());
            for (std::size_t p = 0; p < points.size(); ++p) {
                for (Index b = 0; b < n; ++b) {
                    bool holds = true;
                    for (std::size_t k = 0; k < 3; ++k) {
                        holds = holds && points[p][k] >= boxes[b].low[k] && points[p][k] <= boxes[b].high[k];
                    }
                    if (holds) expected.emplace_back(p, b);
                }
            }
            EXPECT_EQ(found, expected);
        }
    }
}

}  // namespace
}  // namespace SolidSubdiv::Geometry
