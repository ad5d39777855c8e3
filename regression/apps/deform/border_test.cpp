// SPDX-License-Identifier: Apache-2.0
// What happens at the border of a lattice: how smooth deformations fade there, lattices with holes, local ones.
#include <solidsubdiv/apps/deform/deformer.h>

#include <gtest/gtest.h>

#include "apps/deform/deform_testing.h"

namespace SolidSubdiv::Deform {
namespace {

constexpr int kCells = 6;

/// How far points move from where they are.
std::vector<double> Displacements(const ControlLattice& lattice, const std::vector<double>& moved,
                                  const std::vector<double>& points, const EmbedOptions& options) {
    const Embedding e = Embedding::Create(lattice.View(), lattice.positions, points, options);
    std::vector<double> result(points.size());
    Deformer(e).Deform(moved, result);
    for (std::size_t i = 0; i < result.size(); ++i) result[i] -= points[i];
    return result;
}

/// The control points of a block whose distance from the face x = 0 is at least `n_fixed`, moved.
std::vector<double> MovedBeyond(const ControlLattice& lattice, double n_fixed) {
    std::vector<double> moved = Moved(lattice.positions, 0.3, 1);
    for (std::size_t i = 0; i < moved.size(); i += 3) {
        if (lattice.positions[i] >= n_fixed) continue;
        for (std::size_t c = 0; c < 3; ++c) moved[i + c] = lattice.positions[i + c];
    }
    return moved;
}

/// Displacements at distances s from the middle of the face x = 0, over s^power.
std::vector<double> Scaled(double n_fixed, int power, const std::vector<double>& distances) {
    const ControlLattice lattice = LatticeOf(TestShapes::HexBlock(kCells));
    std::vector<double> points;
    for (double s : distances) points.insert(points.end(), {s, 2.3, 3.6});
    auto d = Displacements(lattice, MovedBeyond(lattice, n_fixed), points, {.levels = 0, .limit = true});
    for (std::size_t i = 0; i < d.size(); ++i) d[i] /= std::pow(distances[i / 3], power);
    return d;
}

/// With the border's own control points fixed, deformations begin there linearly: C0.
TEST(Border, OfOneFixedLayer_IsContinuous) {
    const auto d = Scaled(1, 1, {1e-3, 1e-4});
    EXPECT_GT(std::abs(d[3]), 1e-2);
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(d[c], d[3 + c], 1e-5 * std::abs(d[3])) << "linear, and no square";
}

/// With one layer more they begin with a cube: C2, in closed form s^3 / 6 times the spline of the third layer.
TEST(Border, OfTwoFixedLayers_IsC2) {
    const auto d = Scaled(2, 3, {0.5, 0.1, 0.02});
    EXPECT_GT(std::abs(d[3]), 1e-3);
    // Over 0.02 cubed rounding of 1e-15 is 1e-10.
    for (std::size_t c = 0; c < 6; ++c) EXPECT_NEAR(d[c], d[c + 3], 1e-9);
}

TEST(Border, OfThreeFixedLayers_LeavesTheFirstCell) {
    for (double x : Scaled(3, 0, {0.2, 0.9})) EXPECT_NEAR(x, 0, 1e-14);
}

/// At a level, where cells are trilinear, the border stays as well.
TEST(Border, AtALevel_StaysWithItsControlPoints) {
    const ControlLattice lattice = LatticeOf(TestShapes::HexBlock(kCells));
    TestShapes::Random random(2);
    std::vector<double> points;
    for (int i = 0; i < 100; ++i)
        points.insert(points.end(), {0, 3 + 2.9 * random.Uniform(), 3 + 2.9 * random.Uniform()});
    for (int levels : {0, 1, 2}) {
        for (double x : Displacements(lattice, MovedBeyond(lattice, 1), points, {.levels = levels})) {
            EXPECT_NEAR(x, 0, 1e-14);
        }
    }
}

/// Carried points go on as the border does: continuous, and in the limit with a continuous derivative.
TEST(Border, CarriesWhatIsOutside_WithoutAJump) {
    const ControlLattice lattice = LatticeOf(TestShapes::HexBlock(2));
    const auto moved = Moved(lattice.positions, 0.2, 3);
    const double h = 1e-4;
    std::vector<double> points;
    for (double x : {-h, 0.0, h}) points.insert(points.end(), {x, 0.7, 1.1});
    for (Outside outside : {Outside::Clamp, Outside::Carry}) {
        const auto d = Displacements(lattice, moved, points, {.levels = 0, .limit = true, .outside = outside});
        for (std::size_t c = 0; c < 3; ++c) {
            const double before = (d[3 + c] - d[c]) / h, after = (d[6 + c] - d[3 + c]) / h;
            EXPECT_LT(std::abs(before), 1) << "no jump";
            // Second derivatives are about 1: differences over h are off by about h.
            EXPECT_NEAR(before, outside == Outside::Carry ? after : 0, 10 * h);
        }
    }
}

/// chang2002boxspline, fig. 12: what stands in the hole of a lattice stays, by the bit.
TEST(Border, OfAHole_LeavesWhatIsInIt) {
    const ControlLattice ring =
        LatticeOf(TestShapes::HexBlock(3, 3, 2, [](int x, int y, int) { return x != 1 || y != 1; }));
    const std::vector<double> points = {1.5, 1.5, 1, 1.4, 1.6, 0.3, 0.5, 0.5, 1, 2.5, 1.5, 1.5};
    auto moved = ring.positions;
    for (std::size_t i = 0; i < moved.size(); i += 3) moved[i] += 0.5;
    const auto d = Displacements(ring, moved, points, {.levels = 0, .outside = Outside::Leave});
    for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(d[i], 0);
    EXPECT_NEAR(d[6], 0.5, 1e-14);
    EXPECT_NEAR(d[9], 0.5, 1e-14);
}

/// chang2002boxspline, fig. 13: a lattice around a part of a model moves that part.
TEST(Border, OfALocalLattice_LeavesTheRest) {
    ControlLattice local = LatticeOf(TestShapes::HexBlock(kCells));
    std::vector<double> model;
    for (int i = 0; i <= 200; ++i) model.insert(model.end(), {-6 + 0.06 * i, 3.1, 2.9});
    const auto moved = MovedBeyond(local, 2);
    const auto d = Displacements(local, moved, model, {.levels = 0, .limit = true, .outside = Outside::Leave});
    double largest_step = 0;
    for (std::size_t i = 0; i < model.size(); i += 3) {
        EXPECT_TRUE(model[i] >= -1e-9 || d[i] == 0) << i;
        if (i > 0 && model[i] < 2) largest_step = std::max(largest_step, std::abs(d[i + 1] - d[i - 2]));
    }
    EXPECT_LT(largest_step, 0.06) << "slopes are less than 1 across the border";
}

}  // namespace
}  // namespace SolidSubdiv::Deform
