// SPDX-License-Identifier: Apache-2.0
// Derivatives of residual blocks against differences.
#include <gtest/gtest.h>
#include <solidsubdiv/apps/fit/internal/blocks.h>
#include <solidsubdiv/apps/fit/internal/fairness.h>

#include <functional>

#include "apps/fit/fit_testing.h"

namespace SolidSubdiv::Fit::Internal {
namespace {

/// The largest difference between a block's derivatives and central differences, over the largest derivative.
double DerivativeError(
    const ceres::CostFunction& block, const std::vector<Index>& points, const std::vector<double>& control,
    const std::function<void(std::vector<double>&)>& spoil = [](auto&) {}) {
    std::vector<double> x = control;
    std::vector<double*> parameters;
    for (Index p : points) parameters.push_back(&x[3 * static_cast<std::size_t>(p)]);
    const auto n = static_cast<std::size_t>(block.num_residuals());
    std::vector<std::vector<double>> jacobians(points.size(), std::vector<double>(3 * n));
    std::vector<double*> pointers;
    for (auto& j : jacobians) pointers.push_back(j.data());
    std::vector<double> residuals(n), above(n), below(n);
    block.Evaluate(parameters.data(), residuals.data(), pointers.data());
    spoil(jacobians[0]);
    double error = 0, largest = 1e-30;
    constexpr double kStep = 1e-5;
    for (std::size_t b = 0; b < points.size(); ++b) {
        for (std::size_t c = 0; c < 3; ++c) {
            double& value = parameters[b][c];
            const double middle = value;
            value = middle + kStep;
            block.Evaluate(parameters.data(), above.data(), nullptr);
            value = middle - kStep;
            block.Evaluate(parameters.data(), below.data(), nullptr);
            value = middle;
            for (std::size_t i = 0; i < n; ++i) {
                const double slope = (above[i] - below[i]) / (2 * kStep), told = jacobians[b][3 * i + c];
                error = std::max(error, std::abs(slope - told));
                largest = std::max(largest, std::abs(told));
            }
        }
    }
    return error / largest;
}

LinearBlock SomeLinearBlock() {
    TestShapes::Random random(1);
    std::vector<LinearBlock::Row> rows;
    for (int i = 0; i < 5; ++i) {
        LinearBlock::Row row;
        for (Index p = 0; p < 4; ++p) row.weights.emplace_back((i + 3 * p) % 8, random.Uniform());
        for (double& x : row.goal) x = random.Uniform();
        for (double& x : row.matrix) x = random.Uniform();
        rows.push_back(row);
    }
    return LinearBlock(rows);
}

TEST(Blocks, DerivativesOfRowsAreDifferences) {
    const LinearBlock block = SomeLinearBlock();
    // Linear: differences are exact but for rounding, 1e-16 over the step.
    EXPECT_LT(DerivativeError(block, block.control_points(), BulgedHexes(1).positions), 1e-10);
    EXPECT_GT(DerivativeError(block, block.control_points(), BulgedHexes(1).positions,
                              [](std::vector<double>& j) { j[1] += 1e-6; }),
              1e-7);
}

TEST(Blocks, DerivativesOfTheBarrierAreDifferences) {
    const std::vector<double> control = BulgedHexes(1).positions;
    // Corners of one hexahedron in HexBlock's own numbering: any eight corners with volumes below and above `least`.
    const std::vector<BarrierBlock::Corner> corners = {
        {{0, 1, 2, 4}, 10}, {{1, 3, 0, 5}, 10}, {{2, 0, 3, 6}, 1e-3}, {{7, 6, 5, 3}, 5}};
    const BarrierBlock block(corners, 0.7);
    // Cubic along one coordinate at most linear: the differences of volumes are exact but for rounding.
    EXPECT_LT(DerivativeError(block, block.control_points(), control), 1e-9);
    EXPECT_GT(DerivativeError(block, block.control_points(), control, [](std::vector<double>& j) { j[0] *= 1 + 1e-6; }),
              1e-8);
    std::vector<double> residuals(corners.size());
    std::vector<const double*> parameters;
    for (Index p : block.control_points()) parameters.push_back(&control[3 * static_cast<std::size_t>(p)]);
    block.Evaluate(parameters.data(), residuals.data(), nullptr);
    EXPECT_GT(residuals[0], 0);
}

TEST(AffineRows, VanishOnAffineMaps) {
    for (const ControlMesh& mesh : {BulgedHexes(3), BulgedTets(2), SphereCage(1), SphereCage(3)}) {
        const Sdc::Scheme scheme = !mesh.is_solid()     ? Sdc::Scheme(Sdc::Loop{})
                                   : mesh.hexes.empty() ? Sdc::Scheme(Sdc::BoxSpline{})
                                                        : Sdc::Scheme(Sdc::CatmullClarkSolid{});
        const Problem problem = MakeProblem(mesh, scheme, {}, 1);
        const auto rows = AffineRows(problem.control, problem.neighbors);
        std::vector<double> moved = problem.control;
        Map(moved, [](std::array<double, 3> p) {
            return std::array<double, 3>{3 * p[0] - p[1] + 7, 2 * p[1] + p[2], p[2] - 5 * p[0] + 1};
        });
        const auto largest_gap = [&](const std::vector<double>& positions) {
            const std::vector<double> sums = MovingSurface{rows, {}}.Positions(positions);
            double largest = 0;
            for (Index i = 0; i < rows.n_rows(); ++i) {
                EXPECT_FALSE(rows.Indices(i).empty()) << i;
                for (std::size_t c = 0; c < 3; ++c) {
                    const std::size_t k = 3 * static_cast<std::size_t>(i) + c;
                    largest = std::max(largest, std::abs(sums[k] - positions[k]));
                }
            }
            return largest;
        };
        EXPECT_LT(largest_gap(moved), 1e-12);
        Shake(moved, 1e-3, 1);
        EXPECT_GT(largest_gap(moved), 1e-4);
    }
}

TEST(AffineRows, PointsOffThePlaneOfTheirNeighboursHaveNone) {
    const std::vector<double> positions = {0, 0, 1, 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0};
    const std::vector<std::vector<Index>> neighbors = {{1, 2, 3, 4}, {}, {1}, {}, {}};
    const auto rows = AffineRows(positions, neighbors);
    for (Index i = 0; i < rows.n_rows(); ++i) EXPECT_TRUE(rows.Indices(i).empty()) << i;
    std::vector<double> flat = positions;
    flat[2] = 0;
    EXPECT_EQ(AffineRows(flat, neighbors).Indices(0).size(), 4u);
}

}  // namespace
}  // namespace SolidSubdiv::Fit::Internal
