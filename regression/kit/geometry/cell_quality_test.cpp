// SPDX-License-Identifier: Apache-2.0
// Determinants of cells whose answers are known, bounds against samples, and folds that corners don't show.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <solidsubdiv/kit/geometry/cell_quality.h>
#include <solidsubdiv/kit/geometry/internal/hex_jacobian.h>
#include <solidsubdiv/sdc/parallel.h>

#include <cstring>

#include "kit/geometry/place_testing.h"

namespace SolidSubdiv::Geometry {
namespace {

using Internal::Trilinear;
using Internal::Vec3;

CellQuality OnlyCell(const TestSolid& s, const QualityOptions& options = {}) {
    const auto all = MeasureQuality(s.refiner, s.level, s.positions, options);
    EXPECT_EQ(all.size(), 1u);
    return all.at(0);
}

/// Corner i of the map is vertex i of HexBlock.
TestSolid HexOf(const Trilinear& map) {
    TestShapes::PolyhedralShape s = TestShapes::HexBlock(1);
    for (std::size_t i = 0; i < 8; ++i) {
        const Vec3& c = map.corners[i];
        s.positions[3 * i] = c.x, s.positions[3 * i + 1] = c.y, s.positions[3 * i + 2] = c.z;
    }
    return PolyhedralSolid("hex", s, 0);
}

Trilinear ShakenCube(double amount, TestShapes::Random& random) {
    Trilinear map;
    for (unsigned i = 0; i < 8; ++i) {
        map.corners[i] = Vec3{i & 1 ? 1.0 : 0.0, i & 2 ? 1.0 : 0.0, i & 4 ? 1.0 : 0.0} +
                         amount * Vec3{random.Uniform(), random.Uniform(), random.Uniform()};
    }
    return map;
}

double DetAt(const Trilinear& map, const Vec3& at) {
    const auto columns = map.Jacobian(at);
    return Internal::Det(columns[0], columns[1], columns[2]);
}

/// The least determinant on a grid of (n + 1)^3 places.
double LeastOfSamples(const Trilinear& map, int n) {
    double least = HUGE_VAL;
    for (int k = 0; k < (n + 1) * (n + 1) * (n + 1); ++k) {
        const int x = k % (n + 1), y = k / (n + 1) % (n + 1), z = k / (n + 1) / (n + 1);
        least = std::min(least, DetAt(map, {1.0 * x / n, 1.0 * y / n, 1.0 * z / n}));
    }
    return least;
}

TEST(CellQuality, OfCellsWhoseAnswersAreKnown) {
    TestShapes::Shape tet = TestShapes::SingleTet();
    const CellQuality corner = OnlyCell(TetSolid("corner", tet, 0));
    EXPECT_DOUBLE_EQ(corner.jacobian_minimum, 1);
    EXPECT_DOUBLE_EQ(corner.lower_bound, 1);
    EXPECT_DOUBLE_EQ(corner.scaled_jacobian, std::sqrt(2) / 2);  // the largest product is 1 * sqrt(2)^2
    EXPECT_EQ(corner.sign, MinimumSign::Positive);
    tet.positions = {1, 1, 1, -1, -1, 1, -1, 1, -1, 1, -1, -1};
    std::swap(tet.tets[2], tet.tets[3]);
    const CellQuality regular = OnlyCell(TetSolid("regular", tet, 0));
    EXPECT_NEAR(std::abs(regular.scaled_jacobian), 1, 1e-15);
    std::swap(tet.tets[2], tet.tets[3]);
    const CellQuality inverted = OnlyCell(TetSolid("inverted", tet, 0));
    EXPECT_DOUBLE_EQ(inverted.jacobian_minimum, -regular.jacobian_minimum);
    EXPECT_NE(inverted.sign == MinimumSign::Negative, regular.sign == MinimumSign::Negative);
    EXPECT_NE(inverted.sign, MinimumSign::Undecided);

    const CellQuality oct = OnlyCell(TetSolid("octahedron", TestShapes::SingleOct(), 0));
    EXPECT_DOUBLE_EQ(oct.jacobian_minimum, 2);  // four tets of the volume 4/3
    EXPECT_NEAR(oct.scaled_jacobian, std::sqrt(0.5), 1e-15);
    EXPECT_EQ(oct.sign, MinimumSign::Positive);

    TestShapes::Random random(1);
    const CellQuality cube = OnlyCell(HexOf(ShakenCube(0, random)));
    EXPECT_DOUBLE_EQ(cube.jacobian_minimum, 1);
    EXPECT_DOUBLE_EQ(cube.scaled_jacobian, 1);
    EXPECT_EQ(cube.sign, MinimumSign::Positive);
}

TEST(CellQuality, FlatCellsAreUndecided) {
    TestShapes::Shape tet = TestShapes::SingleTet();
    for (std::size_t c = 0; c < 3; ++c) tet.positions[9 + c] = 0.3 * (tet.positions[3 + c] + tet.positions[6 + c]);
    EXPECT_EQ(OnlyCell(TetSolid("flat", tet, 0)).sign, MinimumSign::Undecided);
    TestShapes::Random random(2);
    Trilinear pyramid = ShakenCube(0.1, random);
    for (std::size_t i = 5; i < 8; ++i) pyramid.corners[i] = pyramid.corners[4];
    const CellQuality q = OnlyCell(HexOf(pyramid));
    EXPECT_EQ(q.sign, MinimumSign::Undecided);
    EXPECT_EQ(q.scaled_jacobian, 0);
}

TEST(HexJacobian, BernsteinFormHasTheValuesOfTheDeterminant) {
    TestShapes::Random random(3);
    for (int i = 0; i < 50; ++i) {
        const Trilinear map = ShakenCube(1, random);
        const auto polynomial = Internal::JacobianOf(map);
        for (int k = 0; k < 20; ++k) {
            const double t[3] = {random.Uniform(), random.Uniform(), random.Uniform()};  // beyond [0, 1] too
            double sum = 0;
            for (std::size_t c = 0; c < 27; ++c) {
                double weight = 1;
                for (std::size_t axis = 0, rest = c; axis < 3; ++axis, rest /= 3) {
                    const double s = t[axis], w[3] = {(1 - s) * (1 - s), 2 * s * (1 - s), s * s};
                    weight *= w[rest % 3];
                }
                sum += weight * polynomial.coefficients[c];
            }
            EXPECT_NEAR(sum, DetAt(map, {t[0], t[1], t[2]}), 1e-11);  // weights up to 64, determinants up to 100
        }
    }
}

TEST(CellQuality, OfHexahedra_IsBoundedProvedAndReached) {
    TestShapes::Random random(4);
    int n_of_sign[3] = {};
    for (int i = 0; i < 400; ++i) {
        const Trilinear map = ShakenCube(0.1 + 0.2 * (i % 5), random);
        const CellQuality q = OnlyCell(HexOf(map));
        const double sampled = LeastOfSamples(map, 16);
        EXPECT_LE(q.lower_bound, q.jacobian_minimum);
        EXPECT_LE(q.lower_bound, sampled + 1e-14);
        EXPECT_LE(q.jacobian_minimum - q.lower_bound, 1e-3 * 64);  // edges are at most 4 long
        const auto& at = q.place.at;
        EXPECT_TRUE(IsWithin(CellCoordinates::Hex, at));
        EXPECT_NEAR(DetAt(map, {at[0], at[1], at[2]}), q.jacobian_minimum, 1e-13);  // determinants up to 64
        if (q.sign == MinimumSign::Positive) {
            EXPECT_GT(sampled, 0);
        }
        if (q.sign == MinimumSign::Negative) {
            EXPECT_LT(q.jacobian_minimum, 0);
        }
        EXPECT_NE(q.sign, MinimumSign::Undecided);
        if (sampled < 0) {
            EXPECT_EQ(q.sign, MinimumSign::Negative);
        }
        ++n_of_sign[static_cast<int>(q.sign)];
    }
    EXPECT_GT(n_of_sign[0], 50);
    EXPECT_GT(n_of_sign[1], 50);
}

TEST(CellQuality, FindsAPlantedFoldBetweenCornersOfLargeDeterminants) {
    const Trilinear map{{Vec3{-2, 2, 0}, Vec3{5, 1, -3}, Vec3{3, 2, 0}, Vec3{7, 6, 3}, Vec3{2, 0, 2}, Vec3{4, -1, 1},
                         Vec3{2, 7, 1}, Vec3{5, 2, 4}}};
    for (unsigned c = 0; c < 8; ++c) {
        EXPECT_GE(DetAt(map, {c & 1 ? 1. : 0., c & 2 ? 1. : 0., c & 4 ? 1. : 0.}), 40);
    }
    const CellQuality q = OnlyCell(HexOf(map));
    EXPECT_EQ(q.sign, MinimumSign::Negative);
    EXPECT_LE(q.jacobian_minimum, LeastOfSamples(map, 8));
}

TEST(CellQuality, FindsTheFoldInsideAHexahedronWhoseCornersAreAllPositive) {
    TestShapes::Random random(5);
    int n_folded_inside = 0, n_valid_with_negative_coefficients = 0;
    for (int i = 0; i < 200000 && n_folded_inside < 20; ++i) {
        const Trilinear map = ShakenCube(0.8, random);
        bool are_corners_good = true;
        for (unsigned c = 0; c < 8; ++c) {
            are_corners_good =
                are_corners_good && DetAt(map, {c & 1 ? 1. : 0., c & 2 ? 1. : 0., c & 4 ? 1. : 0.}) > 0.01;
        }
        if (!are_corners_good) continue;
        const CellQuality q = OnlyCell(HexOf(map));
        const bool is_folded = LeastOfSamples(map, 20) < 0;
        if (is_folded) {
            ++n_folded_inside;
            EXPECT_EQ(q.sign, MinimumSign::Negative) << i;
            EXPECT_LT(DetAt(map, {q.place.at[0], q.place.at[1], q.place.at[2]}), 0);
        } else if (q.sign == MinimumSign::Positive && Internal::JacobianOf(map).Least() < 0) {
            ++n_valid_with_negative_coefficients;  // proved by halving alone
            EXPECT_EQ(OnlyCell(HexOf(map), {.most_parts = 1}).sign, MinimumSign::Undecided);
        }
    }
    EXPECT_EQ(n_folded_inside, 20);
    EXPECT_GT(n_valid_with_negative_coefficients, 5);
}

TEST(CellQuality, HasTheSameSignsForSmallAndFarShapes) {
    TestShapes::Random random(6);
    for (int i = 0; i < 50; ++i) {
        const Trilinear map = ShakenCube(0.5, random);
        const CellQuality q = OnlyCell(HexOf(map));
        Trilinear small = map, far = map;
        for (Vec3& c : small.corners) c = 1e-30 * c;
        for (Vec3& c : far.corners) c = c + Vec3{1e6, 1e6, 1e6};
        EXPECT_EQ(OnlyCell(HexOf(small)).sign, q.sign);
        EXPECT_NEAR(OnlyCell(HexOf(small)).scaled_jacobian, q.scaled_jacobian, 1e-12);
        EXPECT_EQ(OnlyCell(HexOf(far)).sign, q.sign);
        EXPECT_NEAR(OnlyCell(HexOf(far)).scaled_jacobian, q.scaled_jacobian,
                    1e-8);  // coordinates of 1e6 round to 1e-10
    }
}

TEST(CellQuality, OfTetsIsTheSameUnderBothSplits) {
    TestShapes::Shape s = TestShapes::KuhnBlock(2);
    TestShapes::Jitter(s, 0.4, 7);  // some inverted
    const Far::TopologyDescriptor topology{.n_vertices = s.n_vertices, .tets = s.tets};
    const auto measure = [&](Sdc::Split split) {
        return MeasureQuality(Far::TopologyRefiner::Create(topology, split), 0, s.positions);
    };
    const auto tets = measure(Sdc::Split::TetOct), polyhedra = measure(Sdc::Split::Polyhedral);
    ASSERT_EQ(tets.size(), polyhedra.size());
    Offset n_negative = 0;
    for (std::size_t t = 0; t < tets.size(); ++t) {
        EXPECT_NEAR(tets[t].jacobian_minimum, polyhedra[t].jacobian_minimum, 1e-14);
        EXPECT_NEAR(tets[t].scaled_jacobian, polyhedra[t].scaled_jacobian, 1e-14);
        EXPECT_EQ(tets[t].sign, polyhedra[t].sign);
        n_negative += tets[t].sign == MinimumSign::Negative;
    }
    EXPECT_GT(n_negative, 0);
}

TEST(CellQuality, OfCellsWithPartsIsPositiveUntilACornerIsPushedThrough) {
    TestShapes::PolyhedralShape s = TestShapes::MixedCells();
    const auto signs = [&] {
        std::vector<MinimumSign> all;
        const TestSolid solid = PolyhedralSolid("mixed", s, 0);
        for (const CellQuality& q : MeasureQuality(solid.refiner, 0, solid.positions)) all.push_back(q.sign);
        return all;
    };
    for (MinimumSign sign : signs()) EXPECT_EQ(sign, MinimumSign::Positive);
    s.positions[3 * 8 + 2] = 0.5;  // the pyramid's apex, below its base
    const auto pushed = signs();
    EXPECT_EQ(pushed[1], MinimumSign::Negative);
    EXPECT_EQ(pushed[0], MinimumSign::Positive);
}

TEST(CellQuality, BitsDependOnNoThreadsAndBadInputIsRefused) {
    const TestSolid s = PolyhedralSolid("block", TestShapes::HexBlock(3), 2);
    const auto measure = [&](int n_threads) {
        const Sdc::ThreadLimit limit(n_threads);
        return MeasureQuality(s.refiner, s.level, s.positions);
    };
    const auto one = measure(1), four = measure(4);
    ASSERT_EQ(one.size(), four.size());
    for (std::size_t c = 0; c < one.size(); ++c) {
        EXPECT_EQ(one[c].jacobian_minimum, four[c].jacobian_minimum);
        EXPECT_EQ(one[c].lower_bound, four[c].lower_bound);
        EXPECT_EQ(one[c].scaled_jacobian, four[c].scaled_jacobian);
        EXPECT_EQ(one[c].place.at, four[c].place.at);
    }
    EXPECT_THROW(MeasureQuality(s.refiner, 3, s.positions), InvalidInput);
    EXPECT_THROW(MeasureQuality(s.refiner, 2, s.positions, {.gap = 0}), InvalidInput);
    EXPECT_THROW(MeasureQuality(s.refiner, 2, s.positions, {.most_parts = 0}), InvalidInput);
    std::vector<double> bad = s.positions;
    bad[0] = std::nan("");
    EXPECT_THROW(MeasureQuality(s.refiner, 2, bad), InvalidInput);
}

}  // namespace
}  // namespace SolidSubdiv::Geometry
