// SPDX-License-Identifier: Apache-2.0
// Tessellated boundaries are watertight, on the limit, as close as asked for, and say so.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <solidsubdiv/kit/geometry/tessellation.h>

#include <random>

#include <solidsubdiv/sdc/parallel.h>

#include "kit/geometry/tessellation_testing.h"
#include "sanitized.h"

namespace SolidSubdiv::Geometry {
namespace {

TEST(Tessellation, ARateKeepsWhatIsClosedClosedAndEveryEulerCharacteristic) {
    for (const TestComplex& complex : TestComplexesInShort()) {
        for (const auto& [name, scheme] : complex.schemes) {
            for (const int rate : {1, 2, 3}) {
                for (const bool quads : {false, true}) {
                    const auto t =
                        TessellateBoundary(complex.refiner, scheme, {.rate = rate, .quads = quads, .normals = false});
                    EXPECT_TRUE(IsWatertight(complex.refiner, t, rate)) << complex.name << ", " << name << ", " << rate;
                }
            }
        }
    }
}

TEST(Tessellation, AToleranceKeepsWhatIsClosedClosedAndEveryEulerCharacteristic) {
    for (const TestComplex& complex : TestComplexesInShort()) {
        for (const auto& [name, scheme] : complex.schemes) {
            for (const double tolerance : {0.2, 0.04}) {
                const auto t = TessellateBoundary(complex.refiner, scheme, complex.positions,
                                                  {.tolerance = tolerance, .normals = false});
                EXPECT_TRUE(IsWatertight(complex.refiner, t, 0)) << complex.name << ", " << name << ", " << tolerance;
            }
        }
    }
}

TEST(Tessellation, ARateMakesItsSquareOfFacetsOfEveryFace) {
    const TestComplex tets = MakeComplex("tets", TestShapes::KuhnBlock(2), Sdc::Split::TetOct);
    EXPECT_EQ(TessellateBoundary(tets.refiner, Sdc::BoxSpline{}, {.rate = 5}).triangles.size(), 3u * 25 * 48);
    const TestComplex hexes = MakeComplex("hexes", TestShapes::HexBlock(2), Sdc::Split::Polyhedral);
    const auto cut = TessellateBoundary(hexes.refiner, Sdc::Mlca{}, {.rate = 5});
    EXPECT_EQ(cut.triangles.size(), 3u * 2 * 25 * 24);
    const auto kept = TessellateBoundary(hexes.refiner, Sdc::Mlca{}, {.rate = 5, .quads = true});
    EXPECT_EQ(kept.quads.size(), 4u * 25 * 24);
    EXPECT_TRUE(kept.triangles.empty());
    EXPECT_EQ(kept.n_vertices(), cut.n_vertices());
}

TEST(Tessellation, ValenceTwoLeavesTheSurfaceAManifold) {
    // Quads that share two edges, and so their opposite corners 0 and 2: at the vertices 1 and 3 two quads meet.
    const std::vector<Index> quads = {0, 1, 2, 4, 0, 5, 2, 1, 0, 4, 2, 3, 0, 3, 2, 5};
    Far::TopologyDescriptor descriptor{.n_vertices = 6};
    descriptor.quads = quads;
    const auto refiner = Far::TopologyRefiner::Create(descriptor, Sdc::Split::Polyhedral);
    const std::vector<double> positions = {-1, 0, 0, 0, 1, 0, 1, 0, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1};
    for (const int rate : {2, 3, 4, 5}) {
        EXPECT_TRUE(IsWatertight(refiner, TessellateBoundary(refiner, Sdc::CatmullClark{}, {.rate = rate}), rate));
    }
    for (const double tolerance : {10., 0.1, 0.001}) {
        const auto t = TessellateBoundary(refiner, Sdc::CatmullClark{}, positions, {.tolerance = tolerance});
        EXPECT_TRUE(IsWatertight(refiner, t, 0)) << tolerance;
    }
}

TEST(Tessellation, PlantedCracksHangingVerticesAndFlipsAreCaught) {
    const TestComplex ball = Ball();
    const auto good = TessellateBoundary(ball.refiner, Sdc::Loop{}, {.rate = 3});
    ASSERT_TRUE(IsWatertight(ball.refiner, good, 3));
    ASSERT_TRUE(IsWatertight(ball.refiner, good, 0));
    Tessellation crack = good;  // a facet with a vertex of its own
    ++crack.rows.n_sources;
    crack.rows.offsets.push_back(crack.rows.offsets.back());
    crack.triangles[0] = crack.n_vertices() - 1;
    Tessellation flip = good;
    std::swap(flip.triangles[0], flip.triangles[1]);
    Tessellation hanging = good;  // an edge that is cut on one of its sides alone
    hanging.rows.offsets.push_back(hanging.rows.offsets.back());
    const Index a = good.triangles[0], b = good.triangles[1], c = good.triangles[2], m = hanging.n_vertices() - 1;
    hanging.triangles[1] = m;
    hanging.triangles.insert(hanging.triangles.end(), {m, b, c});
    EXPECT_NE(a, b);
    Tessellation hole = good;
    hole.triangles.resize(hole.triangles.size() - 3);
    for (const Tessellation* bad : {&crack, &flip, &hanging, &hole}) {
        EXPECT_FALSE(IsWatertight(ball.refiner, *bad, 3));
        EXPECT_FALSE(IsWatertight(ball.refiner, *bad, 0));
    }
}

TEST(Tessellation, AVertexIsTheLimitInEveryFaceThatHasIt) {
    SOLIDSUBDIV_LONG_TEST();
    for (const TestComplex& complex : TestComplexesInShort()) {
        for (const auto& [name, scheme] : complex.schemes) {
            for (const double tolerance : {0., 0.05}) {
                const auto t =
                    TessellateBoundary(complex.refiner, scheme, complex.positions, {.rate = 3, .tolerance = tolerance});
                std::vector<Far::Place> corners;
                for (const FacetDomain& domain : t.domains) {
                    corners.push_back(domain.At({1, 0, 0, 0}));
                    corners.push_back(domain.At({0, 1, 0, 0}));
                    corners.push_back(domain.At({0, 0, 1, 0}));
                }
                const auto table = Far::LimitStencilTable::Create(complex.refiner, scheme, corners,
                                                                  {.elements = Far::Elements::BoundaryFaces});
                const auto limits = TestFar::Limits(table, complex.positions);
                const auto vertices = t.Positions(complex.positions);
                double gap = 0;
                for (std::size_t i = 0; i < t.triangles.size(); ++i) {
                    gap = std::max(gap,
                                   Length(PointOf(limits, static_cast<Index>(i)) - PointOf(vertices, t.triangles[i])));
                }
                // Sums of tens of products on shapes of size 5.
                EXPECT_LE(gap, 1e-12) << complex.name << ", " << name << ", " << tolerance;
            }
        }
    }
}

TEST(Tessellation, ARateOfFourHasTheLimitsOfTheVerticesOfLevelTwo) {
    for (const TestComplex& complex : TestComplexesInShort()) {
        Far::TopologyRefiner refiner = complex.refiner;
        refiner.RefineUniform({.max_level = 2, .full_topology_in_last_level = true});
        if (refiner.is_polyhedral()) {
            const auto& level = refiner.polyhedral_level(0);
            bool has_others = false;
            for (Index b = 0; b < level.n_boundary_faces; ++b) has_others |= level.BoundaryVertices(b).size() != 4;
            if (has_others) continue;  // a rate cuts them otherwise than a split does
        }
        for (const auto& [name, scheme] : complex.schemes) {
            const auto t = TessellateBoundary(refiner, scheme, {.rate = 4});
            const auto limits =
                TestFar::Limits(Far::LimitStencilTable::Create(refiner, scheme),
                                TestFar::Apply(Far::StencilTable::Create(refiner, scheme), complex.positions));
            const BoundarySurface boundary = refiner.is_polyhedral() ? ExtractBoundary(refiner.polyhedral_level(2))
                                                                     : ExtractBoundary(refiner.level(2));
            EXPECT_EQ(TestFar::SortedPoints(t.Positions(complex.positions)),
                      TestFar::SortedPoints(GatherRows(limits, 3, boundary.vertices)))
                << complex.name << ", " << name;
        }
    }
}

TEST(Tessellation, RandomPointsOfTheLimitAreWithinTheTolerance) {
    SOLIDSUBDIV_LONG_TEST();
    int n_that_a_coarser_one_fails = 0;
    for (const TestComplex& complex : TestComplexesInShort()) {
        for (const auto& [name, scheme] : complex.schemes) {
            for (const double tolerance : {0.04}) {
                const auto t = TessellateBoundary(complex.refiner, scheme, complex.positions, {.tolerance = tolerance});
                EXPECT_LE(t.error, 0.8 * tolerance) << complex.name << ", " << name;
                EXPECT_LE(LargestDistance(complex.refiner, scheme, t, complex.positions, 10), tolerance)
                    << complex.name << ", " << name;
                const auto coarse =
                    TessellateBoundary(complex.refiner, scheme, complex.positions, {.tolerance = 4 * tolerance});
                n_that_a_coarser_one_fails +=
                    LargestDistance(complex.refiner, scheme, coarse, complex.positions, 10) > tolerance;
            }
        }
    }
    EXPECT_GT(n_that_a_coarser_one_fails, FewerIfSanitized(10));  // the check can fail
}

TEST(Tessellation, TheErrorSaidIsTheErrorFoundAtRandom) {
    SOLIDSUBDIV_LONG_TEST();
    for (const TestComplex& complex : TestComplexesInShort()) {
        const auto& scheme = complex.schemes.front().second;
        const auto t = TessellateBoundary(complex.refiner, scheme, {.rate = 4});
        const auto said = MeasureError(complex.refiner, scheme, t, complex.positions);
        const double found = LargestDistance(complex.refiner, scheme, t, complex.positions, 60);
        // A quadratic deviation is largest in the middle of an edge or of a triangle, and there are test points near;
        // facets of extraordinary vertices deviate less smoothly.
        EXPECT_LE(found, 1.2 * said.largest + 1e-12) << complex.name;
        EXPECT_GE(found, 0.5 * said.largest) << complex.name;
    }
}

TEST(Tessellation, AnInflatedTessellationIsInError) {
    const TestComplex ball = Ball();
    Tessellation t = TessellateBoundary(ball.refiner, Sdc::Loop{}, {.rate = 16});
    const double before = MeasureError(ball.refiner, Sdc::Loop{}, t, ball.positions).largest;
    for (double& w : t.rows.weights) w *= 1.1;
    EXPECT_GT(MeasureError(ball.refiner, Sdc::Loop{}, t, ball.positions).largest, 5 * before);
}

TEST(Tessellation, OnARoundLimitTheErrorFallsWithTheSquareOfTheRate) {
    const TestComplex ball = Ball();
    double before = 0;
    for (const int rate : {8, 16, 32}) {
        const auto t = TessellateBoundary(ball.refiner, Sdc::Loop{}, {.rate = rate});
        const double error = MeasureError(ball.refiner, Sdc::Loop{}, t, ball.positions).largest;
        if (before > 0) {
            // Twice the rate, a quarter of the sagitta; to the third order in the rate's inverse.
            EXPECT_GT(before / error, 3.5);
            EXPECT_LT(before / error, 4.5);
        }
        before = error;
    }
}

TEST(Tessellation, ToleranceTakesFewerFacetsThanARateOfTheSameError) {
    const TestComplex complex = MakeComplex("touching", TestShapes::TouchingCubes(), Sdc::Split::Polyhedral);
    const Sdc::Scheme scheme = [] {
        Sdc::CatmullClarkSolid smooth;
        smooth.SetOption("features", "smooth");
        return smooth;
    }();
    const auto at_rate = TessellateBoundary(complex.refiner, scheme, {.rate = 8});
    const double error = MeasureError(complex.refiner, scheme, at_rate, complex.positions).largest;
    const auto close = TessellateBoundary(complex.refiner, scheme, complex.positions, {.tolerance = error});
    EXPECT_LT(3 * close.n_facets(), 2 * at_rate.n_facets());
}

TEST(Tessellation, WhatIsFlatStaysAsCoarseAsItsFaces) {
    const TestComplex block = MakeComplex("block", TestShapes::HexBlock(3), Sdc::Split::Polyhedral);
    const auto t = TessellateBoundary(block.refiner, Sdc::LinearSolid{}, block.positions, {.tolerance = 1e-9});
    EXPECT_EQ(t.n_facets(), 4 * 54);
    EXPECT_LE(t.error, 1e-14);
}

TEST(Tessellation, FewerHalvingsThanNeededAreOwnedUpTo) {
    const TestComplex ball = Ball();
    const auto t =
        TessellateBoundary(ball.refiner, Sdc::Loop{}, ball.positions, {.tolerance = 1e-4, .max_halvings = 2});
    EXPECT_GT(t.error, 1e-3);
    EXPECT_TRUE(IsWatertight(ball.refiner, t, 0));
    EXPECT_GT(1.001 * t.error, LargestDistance(ball.refiner, Sdc::Loop{}, t, ball.positions, 40));
}

/// A shear with a stretch, and a shift.
Point Mapped(const Point& p, bool is_point) {
    const double shift = is_point ? 1 : 0;
    return {2 * p.x + 0.5 * p.y + 3 * shift, p.y - 0.25 * p.z - 2 * shift, 0.75 * p.z + 0.1 * p.x + shift};
}

TEST(Tessellation, AnAffineMapOfTheControlPointsMapsThePoints) {
    for (const TestComplex& complex : TestComplexes()) {
        const auto t = TessellateBoundary(complex.refiner, complex.schemes.front().second, {.rate = 3});
        std::vector<double> mapped;
        for (Index v = 0; v < complex.refiner.n_vertices(0); ++v) {
            const Point p = Mapped(PointOf(complex.positions, v), true);
            mapped.insert(mapped.end(), {p.x, p.y, p.z});
        }
        const auto before = t.Positions(complex.positions), after = t.Positions(mapped);
        double gap = 0;
        for (Index v = 0; v < t.n_vertices(); ++v) {
            gap = std::max(gap, Length(PointOf(after, v) - Mapped(PointOf(before, v), true)));
        }
        EXPECT_LE(gap, 1e-12) << complex.name;  // rows sum to 1, but for round-off of tens of products
    }
}

TEST(Tessellation, NormalsAreThoseOfTheFacetsAsTheRateGrows) {
    // Schemes whose boundary is smooth everywhere, on shapes whose boundary is a manifold.
    Sdc::CatmullClarkSolid smooth;
    smooth.SetOption("features", "smooth");
    TestShapes::PolyhedralShape mixed = TestShapes::MixedCells();
    struct Case {
        TestComplex complex;
        Sdc::Scheme scheme;
        double most, fall;
    };
    // An angle of the first order in an edge's length; at extraordinary vertices of one in a power of it, 0.3 at one of
    // valence 9.
    const std::vector<Case> cases = {
        {Ball(), Sdc::Loop{}, 0.5, 0.75},
        {MakeComplex("kuhn", TestShapes::KuhnBlock(2), Sdc::Split::TetOct), Sdc::BoxSpline{}, 0.5, 0.75},
        {MakeComplex("block", TestShapes::HexBlock(2), Sdc::Split::Polyhedral), smooth, 0.5, 0.75},
        {MakeComplex("mixed", mixed, Sdc::Split::Polyhedral), smooth, 1.1, 0.9}};
    for (const auto& [complex, scheme, most, fall] : cases) {
        std::vector<double> largest;
        for (const int rate : {8, 16}) {
            const auto t = TessellateBoundary(complex.refiner, scheme, {.rate = rate});
            const auto positions = t.Positions(complex.positions), normals = t.Normals(complex.positions);
            double angle = 0;
            for (std::size_t i = 0; i < t.triangles.size(); ++i) {
                const Index* v = &t.triangles[i - i % 3];
                const Point n = Cross(PointOf(positions, v[1]) - PointOf(positions, v[0]),
                                      PointOf(positions, v[2]) - PointOf(positions, v[0]));
                const Point normal = PointOf(normals, t.triangles[i]);
                EXPECT_NEAR(Length(normal), 1, 1e-14);
                angle = std::max(angle, std::atan2(Length(Cross(n, normal)), Dot(n, normal)));
            }
            largest.push_back(angle);
        }
        EXPECT_LT(largest[0], most) << complex.name;
        EXPECT_LT(largest[1], fall * largest[0]) << complex.name;
    }
}

TEST(Tessellation, NormalsWhereTangentsVanishAreTheFacets) {
    TestComplex ball = Ball();
    auto t = TessellateBoundary(ball.refiner, Sdc::Loop{}, {.rate = 8});
    const auto with = t.Normals(ball.positions);
    t.tangent_vertices.clear();
    const auto without = t.Normals(ball.positions);
    for (Index v = 0; v < t.n_vertices(); ++v) {
        EXPECT_GT(Dot(PointOf(with, v), PointOf(without, v)), 0.99);  // within a facet's turn
    }
}

TEST(Tessellation, TheSameBitsForAnyNumberOfThreads) {
    const TestComplex complex = MakeComplex("kuhn", TestShapes::KuhnBlock(3), Sdc::Split::TetOct);
    const auto make = [&](int n_threads) {
        const Sdc::ThreadLimit limit(n_threads);
        return TessellateBoundary(complex.refiner, Sdc::BoxSpline{}, complex.positions, {.tolerance = 0.003});
    };
    const Tessellation one = make(1), four = make(4);
    EXPECT_EQ(one.triangles, four.triangles);
    EXPECT_EQ(one.error, four.error);
    EXPECT_EQ(one.rows.indices, four.rows.indices);
    EXPECT_EQ(one.rows.weights, four.rows.weights);
    EXPECT_EQ(one.tangents[0].weights, four.tangents[0].weights);
    EXPECT_EQ(one.Normals(complex.positions), four.Normals(complex.positions));
}

TEST(Tessellation, FacesLeftOutGetNoFacets) {
    const TestComplex ball = Ball();
    std::vector<bool> is_left_out(8);
    is_left_out[2] = true;
    for (const double tolerance : {0., 0.01}) {
        const auto t = TessellateBoundary(ball.refiner, Sdc::Loop{}, ball.positions,
                                          {.rate = 3, .tolerance = tolerance, .is_left_out = is_left_out});
        EXPECT_EQ(KindOf(t).euler_characteristic, 1);
        for (const FacetDomain& domain : t.domains) EXPECT_NE(domain.face, 2);
    }
    is_left_out.pop_back();
    EXPECT_THROW(TessellateBoundary(ball.refiner, Sdc::Loop{}, {.is_left_out = is_left_out}), InvalidInput);
}

TEST(Tessellation, BadRequestsAreNamed) {
    const TestComplex ball = Ball();
    const auto text_of = [&](const TessellationOptions& options) -> std::string {
        try {
            TessellateBoundary(ball.refiner, Sdc::Loop{}, ball.positions, options);
        } catch (const InvalidInput& error) {
            return error.what();
        }
        return {};
    };
    EXPECT_EQ(text_of({.rate = 0}), "rate is 0; it must be 1 to 4096");
    EXPECT_THAT(text_of({.tolerance = -1}), testing::HasSubstr("tolerance is -1"));
    EXPECT_THAT(text_of({.tolerance = 1, .quads = true}), testing::HasSubstr("makes triangles, not quads"));
    EXPECT_THAT(text_of({.rate = 100, .max_facets = 1000}),
                testing::HasSubstr("a rate of 100 makes 80000 facets, more than the 1000 allowed"));
    EXPECT_THAT(text_of({.tolerance = 1e-6, .max_facets = 1000}),
                testing::HasSubstr("takes more than the 1000 facets"));
    EXPECT_THROW(TessellateBoundary(ball.refiner, Sdc::Loop{}, {.tolerance = 1}), InvalidInput);
    EXPECT_THROW(TessellateBoundary(ball.refiner, Sdc::Loop{}, std::vector<double>(3), {}), InvalidInput);
    const auto t = TessellateBoundary(ball.refiner, Sdc::Loop{}, {.rate = 1});
    EXPECT_THROW(t.Values(ball.positions, 2), InvalidInput);
}

}  // namespace
}  // namespace SolidSubdiv::Geometry
