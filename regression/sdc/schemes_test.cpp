// SPDX-License-Identifier: Apache-2.0
// Every scheme's weights sum to one, and its options follow its table.
#include <cmath>
#include <vector>

#include <gtest/gtest.h>
#include <solidsubdiv/sdc/schemes.h>

namespace {

using namespace SolidSubdiv;
using namespace SolidSubdiv::Sdc;

TEST(BoxSplineTest, WeightsOfEveryNeighborhoodSumToOne) {
    BoxSpline averaged, printed;
    averaged.diagonals = Diagonals::Averaged;
    printed.edge_rule = EdgeRule::Printed2002;
    for (const BoxSpline& s : {BoxSpline{}, averaged, printed}) {
        for (int faces = 3; faces < 20; ++faces) {
            for (int octs = 0; octs < 5; ++octs) {
                const VertexWeights v = s.Vertex({faces, octs});
                EXPECT_NEAR(v.self + faces * v.edge + octs * v.oct, 1, 1e-15);
                const int oct_vertices = s.diagonals == Diagonals::Averaged ? 2 * octs : octs;
                const EdgeWeights e = s.Edge({faces, octs, oct_vertices});
                EXPECT_NEAR(2 * e.end + faces * e.face + oct_vertices * e.oct, 1, 1e-15);
            }
        }
        const OctWeights c = s.Centre();
        EXPECT_NEAR(2 * c.diagonal + 4 * c.equator, 1, 1e-15);
    }
}

// Chang et al. 2002, eqs. (8), (10), (12), in 32nds.
TEST(BoxSplineTest, RegularWeightsAreThePapers) {
    const BoxSpline s;
    EXPECT_EQ(s.Vertex({12, 2}).self * 32, 18);
    EXPECT_DOUBLE_EQ(s.Vertex({12, 2}).edge * 32, 1);
    EXPECT_DOUBLE_EQ(s.Vertex({12, 2}).oct * 32, 1);
    EXPECT_EQ(s.Edge({4, 2, 2}).end * 32, 10);
    EXPECT_DOUBLE_EQ(s.Edge({4, 2, 2}).face * 32, 2);
    EXPECT_EQ(s.Edge({4, 0, 0}).end * 32, 8);
    EXPECT_EQ(s.Edge({4, 0, 0}).face * 32, 4);
    EXPECT_EQ(s.Centre().diagonal * 32, 8);
    EXPECT_EQ(s.Centre().equator * 32, 4);
}

TEST(SmoothTetTest, WeightsOfEveryNeighborhoodSumToOne) {
    const SmoothTet s;
    for (int tets = 0; tets < 9; ++tets) {
        for (int octs = tets == 0; octs < 5; ++octs) {
            const CellVertexWeights v = s.Vertex({tets, octs});
            EXPECT_NEAR(v.self + 3 * tets * v.tet + octs * (4 * v.oct + v.opposite), 1, 1e-15);
            const EdgeWeights e = s.Edge({tets + octs, octs, 2 * octs});
            EXPECT_NEAR(2 * e.end + (tets + octs) * e.face + 2 * octs * e.oct, 1, 1e-15);
        }
    }
}

TEST(LoopTest, WeightsSumToOneAndTheLimitIsAFixedPoint) {
    for (const LoopSurface& s : {LoopSurface{LoopWeights::Loop}, LoopSurface{LoopWeights::Warren}}) {
        for (int n = 3; n < 40; ++n) {
            const RingWeights v = s.Vertex(n), limit = s.Limit(n);
            EXPECT_NEAR(v.self + n * v.neighbor, 1, 1e-15);
            // One refinement of symmetric data: centre p, ring mean q; ring points become (3/8)(p + q) + (1/4) q.
            const double p = 2, q = -1;
            const double p1 = v.self * p + n * v.neighbor * q, q1 = 3.0 / 8 * p + 5.0 / 8 * q;
            EXPECT_NEAR(limit.self * p1 + n * limit.neighbor * q1, limit.self * p + n * limit.neighbor * q, 1e-14);
        }
    }
    EXPECT_DOUBLE_EQ(LoopSurface{}.Vertex(6).neighbor, 1.0 / 16);
    EXPECT_DOUBLE_EQ(LoopSurface{}.Vertex(3).neighbor, 3.0 / 16);
}

TEST(SchemesTest, EveryChoiceOfEveryOptionCanBeSetAndOthersAreRefused) {
    int n_schemes = 0;
    ForEachScheme([&](auto scheme) {
        ++n_schemes;
        EXPECT_EQ(NameOf(SchemeOf(scheme.kName)), scheme.kName);
        for (const OptionInfo& option : scheme.kOptions) {
            std::string_view rest = option.values == kNumber ? option.initial : option.values;
            bool has_default = false;
            while (!rest.empty()) {
                const std::size_t bar = rest.find('|');
                EXPECT_NO_THROW(scheme.SetOption(option.name, rest.substr(0, bar)));
                has_default |= rest.substr(0, bar) == option.initial;
                rest = bar == std::string_view::npos ? std::string_view{} : rest.substr(bar + 1);
            }
            EXPECT_TRUE(has_default) << option.name;
            EXPECT_THROW(scheme.SetOption(option.name, "no such value"), InvalidInput);
        }
        EXPECT_THROW(scheme.SetOption("no-such-option", "1"), InvalidInput);
    });
    EXPECT_EQ(n_schemes, static_cast<int>(std::variant_size_v<Scheme>));
    EXPECT_THROW(SchemeOf("nurbs"), InvalidInput);
}

TEST(SchemesTest, OptionsReachTheFieldsTheyName) {
    Scheme s = SchemeOf("box-spline");
    SetOption(s, "edge-rule", "printed-2002");
    EXPECT_EQ(std::get<BoxSpline>(s).edge_rule, EdgeRule::Printed2002);
    SetOption(s, "diagonals", "averaged");
    EXPECT_THROW(std::get<BoxSpline>(s).Validate(), InvalidInput);
    SetOption(s, "edge-rule", "box-spline");
    EXPECT_NO_THROW(std::get<BoxSpline>(s).Validate());
    SetOption(s, "loop-weights", "warren");
    EXPECT_EQ(std::get<BoxSpline>(s).surface().weights, LoopWeights::Warren);
}

TEST(SchemesTest, TensionsAreNumbersOrFractionsInTheirRange) {
    const auto tension_of = [](const char* text) {
        Interpolatory s;
        s.SetOption("tension", text);
        s.Validate();
        return s.tension;
    };
    EXPECT_EQ(tension_of("1/16"), 0.0625);
    EXPECT_EQ(tension_of("0.0625"), 0.0625);
    EXPECT_EQ(tension_of("0"), 0);
    EXPECT_EQ(tension_of("0.1249999"), 0.1249999);
    for (const char* bad :
         {"", "w", "1/", "/16", "1/16x", "1/0", "0/0", "nan", "inf", "-0.01", "0.125", "1/8", "1", "1 "})
        EXPECT_THROW(tension_of(bad), InvalidInput) << bad;
    Butterfly butterfly;
    butterfly.tension = 0.125;
    EXPECT_THROW(butterfly.Validate(), InvalidInput);
    ModifiedButterfly modified;
    modified.far_weight = -1.0 / 16;
    EXPECT_NO_THROW(modified.Validate());
    modified.far_weight = std::nextafter(1.0 / 16, 1);
    EXPECT_THROW(modified.Validate(), InvalidInput);
}

TEST(InterpolatoryTest, WeightsSumToOneAndZeroTensionIsLinear) {
    for (double w : {0.0, 1.0 / 32, 1.0 / 16, 0.1}) {
        for (int n = 3; n < 12; ++n) {
            for (int m = 1; m < 20; ++m) {
                const TwoNeighborWeights e = Interpolatory{.tension = w}.Edge(n, m);
                EXPECT_NEAR(2 * e.end + n * e.one + m * e.two, 1, 1e-15);
                if (w == 0) {
                    EXPECT_TRUE(e.end == 0.5 && e.one == 0 && e.two == 0);
                }
            }
        }
    }
}

// rules.md section 3, regular: N = 6, M = 6 and N = 4, M = 8, in 16ths.
TEST(InterpolatoryTest, RegularWeightsAreTheRules) {
    const Interpolatory s;
    EXPECT_EQ(s.Edge(6, 6).end * 16, 8);
    EXPECT_EQ(s.Edge(6, 6).one * 16, 1);
    EXPECT_EQ(s.Edge(4, 8).end * 16, 4);
    EXPECT_EQ(s.Edge(4, 8).one * 16, 4);
    EXPECT_EQ(s.Edge(4, 8).two * 16, -1);
}

TEST(ButterflyTest, WeightsOfEveryRingSumToOne) {
    for (int n = 3; n < 30; ++n) {
        std::vector<double> ring(static_cast<std::size_t>(n));
        double sum = ButterflySurface::ClosedRing(n, ring);
        for (double w : ring) sum += w;
        EXPECT_NEAR(sum, 1, 1e-14) << n;
    }
    for (int k = 2; k < 30; ++k) {
        for (int i = 1; i < k; ++i) {
            std::vector<double> ring(static_cast<std::size_t>(k) + 1), mirrored = ring;
            double sum = ButterflySurface::OpenRing(k, i, ring);
            for (double w : ring) sum += w;
            EXPECT_NEAR(sum, 1, 1e-14) << k << " " << i;
            ButterflySurface::OpenRing(k, k - i, mirrored);
            for (int j = 0; j <= k; ++j) EXPECT_NEAR(ring[j], mirrored[k - j], 1e-15) << k << " " << i << " " << j;
        }
    }
    for (double w : {0.0, 0.02, -1.0 / 16}) {
        const ButterflyWeights b = ButterflySurface{true, w, 1}.Regular(true);
        EXPECT_NEAR(2 * b.end + 2 * b.opposite + 4 * b.wing + 2 * b.far, 1, 1e-15);
    }
    const FourPointCurve curve;
    EXPECT_EQ(curve.Edge().end, 9.0 / 16);
    EXPECT_EQ(curve.LastEdge().last, 3.0 / 8);
    EXPECT_EQ(curve.LastEdge().end, 6.0 / 8);
    EXPECT_EQ(curve.LastEdge().next, -1.0 / 8);
}

}  // namespace
