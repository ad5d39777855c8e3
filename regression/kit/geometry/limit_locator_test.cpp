// SPDX-License-Identifier: Apache-2.0
// Points of the limit are found again where they are; points outside are listed; bad input is refused.
#include <gtest/gtest.h>
#include <solidsubdiv/kit/geometry/limit_locator.h>
#include <solidsubdiv/sdc/parallel.h>

#include "kit/geometry/place_testing.h"
#include "sanitized.h"

namespace SolidSubdiv::Geometry {
namespace {

std::vector<double> LimitsOf(const TestSolid& s, const Sdc::Scheme& scheme, std::span<const Far::Place> places) {
    const auto table = Far::LimitStencilTable::Create(s.refiner, scheme, places, {.level = s.level});
    std::vector<double> points(3 * places.size());
    for (Index i = 0; i < table.rows().n_rows(); ++i) {
        const auto indices = table.rows().Indices(i);
        for (std::size_t k = 0; k < indices.size(); ++k) {
            for (std::size_t c = 0; c < 3; ++c) {
                points[3 * static_cast<std::size_t>(i) + c] +=
                    table.rows().Weights(i)[k] * s.positions[3 * static_cast<std::size_t>(indices[k]) + c];
            }
        }
    }
    return points;
}

/// The same refined with all its topology.
TestSolid Full(TestSolid s) {
    s.refiner.RefineUniform({.max_level = s.level, .full_topology_in_last_level = true});
    return s;
}

void ExpectFoundAgain(const TestSolid& s, const Sdc::Scheme& scheme, int n) {
    SCOPED_TRACE(s.name + ", " + std::string(Sdc::NameOf(scheme)));
    const auto places = RandomPlaces(s, FewerIfSanitized(n), 5);
    const auto points = LimitsOf(s, scheme, places);
    LimitLocator locator(s.refiner, scheme, s.level, s.positions);
    const auto found = locator.Locate(points);
    EXPECT_TRUE(found.outside.empty()) << found.outside.size() << " lost, the first, " << found.outside[0].point
                                       << ", by " << found.outside[0].distance;
    const auto again = LimitsOf(s, scheme, found.places);
    for (std::size_t i = 0; i < places.size(); ++i) {
        EXPECT_LE(DistanceOf(points, again, i, i), 1e-11);  // twice the tolerance of 1e-12 of a few units
    }
}

TEST(LimitLocator, PointsOfTheLimit_AreFoundAgain) {
    SOLIDSUBDIV_LONG_TEST();
    auto block = TestShapes::KuhnBlock(2);
    TestShapes::Jitter(block, 0.1, 8);
    for (int level : {1, 2}) {
        const TestSolid tets = Full(TetSolid("block", block, level));
        for (const Sdc::Scheme scheme : {Sdc::Scheme(Sdc::BoxSpline{}), Sdc::Scheme(Sdc::LinearSolid{})}) {
            ExpectFoundAgain(tets, scheme, 120);
        }
        const TestSolid hexes = Full(PolyhedralSolid("hexes", TestShapes::HexBlock(2), level));
        for (const Sdc::Scheme scheme : {Sdc::Scheme(Sdc::CatmullClarkSolid{}), Sdc::Scheme(Sdc::Mlca{})}) {
            ExpectFoundAgain(hexes, scheme, 300);
        }
        ExpectFoundAgain(Full(PolyhedralSolid("mixed", TestShapes::MixedCells(), level)), Sdc::CatmullClarkSolid{},
                         200);
    }
    ExpectFoundAgain(Full(TetSolid("tet", TestShapes::SingleTet(), 2)), Sdc::SmoothTet{}, 50);
    // (A single tet is folded in the limit of this one.)
    ExpectFoundAgain(Full(TetSolid("block", TestShapes::KuhnBlock(2), 1)), Sdc::Interpolatory{}, 50);
}

TEST(LimitLocator, PointsOutside_AreListedWithTheirDistance) {
    const TestSolid s = Full(PolyhedralSolid("hexes", TestShapes::HexBlock(2), 1));
    LimitLocator locator(s.refiner, Sdc::CatmullClarkSolid{}, s.level, s.positions);
    // With sharp features the block's limit is the block, [0, 2]^3.
    const std::vector<double> points{1, 1, 1, 3, 1, 1, 1, 1, -2, 2, 2, 2};
    const auto found = locator.Locate(points);
    ASSERT_EQ(found.outside.size(), 2u);
    EXPECT_EQ(found.outside[0].point, 1);
    EXPECT_NEAR(found.outside[0].distance, 1, 1e-9);
    EXPECT_EQ(found.outside[1].point, 2);
    EXPECT_NEAR(found.outside[1].distance, 2, 1e-9);
}

TEST(LimitLocator, Places_AreTheSameForAnyNumberOfThreads) {
    const TestSolid s = Full(TetSolid("block", TestShapes::KuhnBlock(2), 1));
    const auto points = LimitsOf(s, Sdc::BoxSpline{}, RandomPlaces(s, 500, 3));
    LimitLocator locator(s.refiner, Sdc::BoxSpline{}, s.level, s.positions);
    const auto many = locator.Locate(points);
    const Sdc::ThreadLimit one(1);
    const auto alone = locator.Locate(points);
    for (std::size_t i = 0; i < many.places.size(); ++i) {
        EXPECT_EQ(many.places[i].element, alone.places[i].element);
        EXPECT_EQ(many.places[i].at, alone.places[i].at);
    }
}

TEST(LimitLocator, BadInput_IsRefused) {
    const TestSolid s = Full(TetSolid("tet", TestShapes::SingleTet(), 1));
    EXPECT_THROW(LimitLocator(s.refiner, Sdc::Mlca{}, 1, s.positions), InvalidInput);
    EXPECT_THROW(LimitLocator(s.refiner, Sdc::BoxSpline{}, 0, s.positions), InvalidInput);
    LimitLocator locator(s.refiner, Sdc::BoxSpline{}, 1, s.positions);
    const std::vector<double> nan{0, NAN, 0}, point{0, 0, 0};
    EXPECT_THROW(locator.Locate(nan), InvalidInput);
    EXPECT_THROW(locator.Locate(point, {.tolerance = -1}), InvalidInput);
    EXPECT_THROW(locator.Locate(point, {.max_steps = 0}), InvalidInput);
}

}  // namespace
}  // namespace SolidSubdiv::Geometry
