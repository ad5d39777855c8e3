// SPDX-License-Identifier: Apache-2.0
// Laws of embeddings and of what moves them.
#include <solidsubdiv/apps/deform/deformer.h>
#include <solidsubdiv/sdc/parallel.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <numeric>

#include "apps/deform/deform_testing.h"
#include "sanitized.h"

namespace SolidSubdiv::Deform {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// Sizes are about 3: some hundred roundings of sums of some tens of terms.
constexpr double kRoundOff = 1e-13;

std::vector<double> Deformed(const Embedding& embedding, const std::vector<double>& control) {
    std::vector<double> points(3 * static_cast<std::size_t>(embedding.n_points()));
    Deformer(embedding).Deform(control, points);
    return points;
}

class Embeddings : public testing::TestWithParam<LatticeCase> {
  protected:
    const ControlLattice& lattice() const { return GetParam().lattice; }
    Embedding Embed(const std::vector<double>& points, EmbedOptions options) const {
        options.scheme = GetParam().scheme;
        return Embedding::Create(lattice().View(), lattice().positions, points, options);
    }
};

TEST_P(Embeddings, UndeformedLattice_LeavesAllPoints) {
    const auto points = PointsAround(lattice(), 300, 1);
    for (Outside outside : {Outside::Leave, Outside::Clamp, Outside::Carry}) {
        for (int levels : {0, 2}) {
            const Embedding e = Embed(points, {.levels = levels, .outside = outside});
            EXPECT_LT(Distance(Deformed(e, lattice().positions), points), kRoundOff) << levels;
        }
    }
}

TEST_P(Embeddings, UndeformedLattice_LeavesPointsInTheLimit) {
    const auto points = PointsAround(lattice(), FewerIfSanitized(40), 1);
    const Embedding e = Embed(points, {.levels = 1, .limit = true});
    // Points inside are as near as the search in the limit comes: 1e-12 of the diagonal.
    EXPECT_LT(Distance(Deformed(e, lattice().positions), points), 1e-11);
}

TEST_P(Embeddings, AffineMapsOfTheLattice_AreThoseOfTheModel) {
    const auto points = PointsAround(lattice(), 300, 2);
    for (int levels : {0, 1, 2}) {
        const Embedding e = Embed(points, {.levels = levels, .falloff = kInfinity});
        // Flat tets at the border of a jittered lattice are continued far: their coordinates are large.
        EXPECT_LT(Distance(Deformed(e, Affine(lattice().positions)), Affine(points)), 10 * kRoundOff) << levels;
    }
}

TEST_P(Embeddings, PointsOutside_DoAsAsked) {
    const auto points = PointsAround(lattice(), 200, 3);
    std::vector<double> control = lattice().positions;
    for (std::size_t i = 0; i < control.size(); i += 3) control[i] += 1;  // all by (1, 0, 0)
    for (Outside outside : {Outside::Leave, Outside::Clamp, Outside::Carry}) {
        const Embedding e = Embed(points, {.levels = 1, .outside = outside, .falloff = 0.3});
        ASSERT_FALSE(e.outside().empty());
        const auto moved = Deformed(e, control);
        std::vector<double> factors(points.size() / 3, 1);
        for (const OutsidePoint& p : e.outside()) {
            const double t = p.distance / 0.3, carried = t < 1 ? (1 - t * t) * (1 - t * t) : 0;
            factors[static_cast<std::size_t>(p.point)] = outside == Outside::Leave   ? 0
                                                         : outside == Outside::Clamp ? 1
                                                                                     : carried;
        }
        for (std::size_t i = 0; i < factors.size(); ++i) {
            EXPECT_NEAR(moved[3 * i] - points[3 * i], factors[i], 10 * kRoundOff);
            EXPECT_NEAR(moved[3 * i + 1], points[3 * i + 1], 10 * kRoundOff);
        }
    }
}

TEST_P(Embeddings, ControlRows_AreTheDerivative) {
    const auto points = PointsAround(lattice(), FewerIfSanitized(30), 4);
    for (bool limit : {false, true}) {
        const Embedding e = Embed(points, {.levels = 1, .limit = limit});
        std::vector<Index> all(static_cast<std::size_t>(e.n_points()));
        std::iota(all.begin(), all.end(), 0);
        const auto rows = e.ControlRows(all);
        const auto control = Moved(lattice().positions, 0.2, 5);
        std::vector<double> expected(points.size());
        for (Index i = 0; i < rows.n_rows(); ++i) {
            for (std::size_t k = 0; k < rows.Indices(i).size(); ++k) {
                for (std::size_t c = 0; c < 3; ++c) {
                    expected[3 * static_cast<std::size_t>(i) + c] +=
                        rows.Weights(i)[k] * control[3 * static_cast<std::size_t>(rows.Indices(i)[k]) + c];
                }
            }
        }
        for (const OutsidePoint& p : e.outside()) {
            for (std::size_t c = 0; c < 3; ++c) expected[3 * static_cast<std::size_t>(p.point) + c] += p.constant[c];
        }
        EXPECT_LT(Distance(Deformed(e, control), expected), 10 * kRoundOff);
    }
}

TEST_P(Embeddings, Update_ChangesWhatIsAffected_ToTheBitsOfDeform) {
    for (bool limit : {false, true}) {
        const auto points = PointsAround(lattice(), limit ? FewerIfSanitized(30) : 500, 6);
        const Embedding e = Embed(points, {.levels = 1, .limit = limit});
        Deformer deformer(e), whole(e);
        std::vector<double> control = Moved(lattice().positions, 0.2, 7), moved(points.size()), expected(points.size());
        deformer.Deform(control, moved);
        TestShapes::Random random(8);
        for (int step = 0; step < 20; ++step) {
            const Index i = random.Below(lattice().n_control_points());
            for (std::size_t c = 0; c < 3; ++c) control[3 * static_cast<std::size_t>(i) + c] += 0.1 * random.Uniform();
            const std::vector<double> before = moved;
            const auto changed = deformer.Update(std::span(&i, 1), control, moved);
            std::vector<Index> sorted(changed.begin(), changed.end());
            std::sort(sorted.begin(), sorted.end());
            EXPECT_EQ(sorted, deformer.Affected(std::span(&i, 1)));
            for (Index p = 0; p < e.n_points(); ++p) {
                const bool differs =
                    !std::equal(&moved[3 * static_cast<std::size_t>(p)], &moved[3 * static_cast<std::size_t>(p)] + 3,
                                &before[3 * static_cast<std::size_t>(p)]);
                EXPECT_TRUE(!differs || std::binary_search(sorted.begin(), sorted.end(), p));
            }
            whole.Deform(control, expected);
            EXPECT_EQ(moved, expected);
        }
    }
}

TEST_P(Embeddings, AreTheSameBits_TwiceAndForAnyThreads) {
    const auto points = PointsAround(lattice(), 400, 9);
    const auto control = Moved(lattice().positions, 0.2, 10);
    const auto run = [&](int n_threads) {
        const Sdc::ThreadLimit limit(n_threads);
        return Deformed(Embed(points, {.levels = 2}), control);
    };
    const auto once = run(1);
    EXPECT_EQ(once, run(1));
    EXPECT_EQ(once, run(2));
}

TEST_P(Embeddings, Floats_AreNearDoubles) {
    const auto points = PointsAround(lattice(), 300, 11);
    const Embedding e = Embed(points, {.levels = 2});
    const std::vector<float> control(lattice().positions.begin(), lattice().positions.end());
    std::vector<float> moved(points.size());
    DeformerReal<float>(e).Deform(control, moved);
    // A millionth of the size, which is 3.
    EXPECT_LT(Distance({moved.begin(), moved.end()}, points), 3e-6);
}

TEST_P(Embeddings, WhatNoPointNeeds_IsDropped) {
    const auto points = PointsAround(lattice(), 1, 12);
    const Embedding few = Embed(points, {.levels = 2, .outside = Outside::Clamp});
    EXPECT_LE(few.tables().n_patch_points(), 30);  // corners of one cell
    const Embedding none = Embed({}, {.levels = 2});
    EXPECT_EQ(none.tables().n_patch_points(), 0);
    EXPECT_EQ(none.n_points(), 0);
    EXPECT_TRUE(Deformed(none, lattice().positions).empty());
}

INSTANTIATE_TEST_SUITE_P(EveryScheme, Embeddings, testing::ValuesIn(LatticeCases()), [](const auto& test) {
    std::string name = test.param.name;
    std::replace_if(
        name.begin(), name.end(), [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); }, '_');
    return name;
});

/// Every point, were it outside or not, must be told from what it is: a lattice that is not where it was moves points.
TEST(EmbeddingLaws, AMovedLattice_IsCaughtByTheLawOfTheUndeformed) {
    const ControlLattice lattice = LatticeOf(TestShapes::HexBlock(2));
    const auto points = PointsAround(lattice, 50, 1);
    const Embedding e = Embedding::Create(lattice.View(), lattice.positions, points, {});
    EXPECT_GT(Distance(Deformed(e, Moved(lattice.positions, 1e-9, 2)), points), 1e-11);
}

TEST(EmbeddingErrors, NameWhatIsWrong) {
    const ControlLattice lattice = LatticeOf(TestShapes::HexBlock(1));
    const auto embed = [&](const std::vector<double>& points, const EmbedOptions& options) {
        return Embedding::Create(lattice.View(), lattice.positions, points, options);
    };
    const auto message = [](auto&& call) -> std::string {
        try {
            call();
        } catch (const InvalidInput& error) {
            return error.what();
        }
        return "no error";
    };
    using testing::HasSubstr;
    EXPECT_THAT(message([&] { embed({1, 2}, {}); }), HasSubstr("no multiple of three"));
    EXPECT_THAT(message([&] { embed({1, 2, NAN}, {}); }), HasSubstr("not finite"));
    EXPECT_THAT(message([&] { embed({}, {.levels = 21}); }), HasSubstr("levels is 21"));
    EXPECT_THAT(message([&] { embed({}, {.falloff = -1}); }), HasSubstr("falloff"));
    EXPECT_THAT(message([&] { embed({}, {.tolerance = NAN}); }), HasSubstr("tolerance"));
    EXPECT_THAT(message([&] { embed({}, {.scheme = Sdc::Loop{}}); }), HasSubstr("loop"));
    EXPECT_THAT(message([&] { Embedding::Create({.n_vertices = 0}, {}, {}, {}); }), HasSubstr("no cells"));
    EXPECT_THAT(message([&] {
                    Embedding::Create(lattice.View(), std::vector<double>{1, 2, 3}, {}, {});
                }),
                HasSubstr("3 coordinates are given for 8 control points"));
    EXPECT_THAT(message([&] { OutsideOf("fly"); }), HasSubstr("leave, clamp, carry"));

    const Embedding e = embed({.5, .5, .5}, {});
    Deformer deformer(e);
    std::vector<double> point(3), control = lattice.positions;
    const Index bad = 8, good = 0;
    EXPECT_THAT(message([&] { deformer.Update({&good, 1}, control, point); }), HasSubstr("needs a Deform"));
    deformer.Deform(control, point);
    EXPECT_THAT(message([&] { deformer.Update({&bad, 1}, control, point); }), HasSubstr("control point 8"));
    EXPECT_THAT(message([&] { deformer.Deform({control.data(), 3}, point); }), HasSubstr("8 control points"));
    EXPECT_THAT(message([&] { e.ControlRows({&bad, 1}); }), HasSubstr("point 8"));
}

}  // namespace
}  // namespace SolidSubdiv::Deform
