// SPDX-License-Identifier: Apache-2.0
// Derivatives of what is minimized against differences.
#include <gtest/gtest.h>
#include <solidsubdiv/apps/fit/internal/corner_shapes.h>
#include <solidsubdiv/apps/fit/internal/fairness.h>
#include <solidsubdiv/apps/fit/internal/more_rows.h>
#include <solidsubdiv/apps/fit/internal/normal_equations.h>
#include <solidsubdiv/apps/fit/internal/rows.h>

#include <functional>

#include "apps/fit/fit_testing.h"

namespace SolidSubdiv::Fit::Internal {
namespace {

/// The largest difference between a told slope and central differences, over the largest slope.
double SlopeError(const std::function<double(std::span<const double>, std::span<double>)>& energy,
                  std::vector<double> at, double step, double spoil = 0) {
    std::vector<double> slope(at.size());
    energy(at, slope);
    *std::max_element(slope.begin(), slope.end(), [](double a, double b) { return std::abs(a) < std::abs(b); }) *=
        1 + spoil;
    double error = 0, largest = 1e-30;
    for (std::size_t i = 0; i < at.size(); ++i) {
        const double middle = at[i];
        at[i] = middle + step;
        const double above = energy(at, {});
        at[i] = middle - step;
        const double below = energy(at, {});
        at[i] = middle;
        error = std::max(error, std::abs((above - below) / (2 * step) - slope[i]));
        largest = std::max(largest, std::abs(slope[i]));
    }
    return error / largest;
}

TEST(CornerEnergy, ItsSlopeIsADifference_WhereCellsAreFoldedToo) {
    // Any corners, well shaped, flat and folded ones.
    const std::vector<double> control = BulgedHexes(1).positions;
    const std::vector<std::array<Index, 4>> corners = {{0, 1, 2, 4}, {1, 3, 0, 5}, {2, 0, 3, 6}, {7, 6, 5, 3}};
    const std::vector<double> enough = {1, 0.9, 1, 1};
    double least = 1, most = -1;
    for (const auto& corner : corners) {
        least = std::min(least, CornerQuality(corner, control));
        most = std::max(most, CornerQuality(corner, control));
    }
    ASSERT_LT(least, -0.5);
    ASSERT_GT(most, 0.5);
    for (double softness : {0.05, 0.5}) {
        const auto energy = [&](std::span<const double> at, std::span<double> slope) {
            return 0.7 * CornerEnergy(corners, enough, at, softness, 0.7, slope);
        };
        // Differences err by the square of the step, over that of the softness, and by 1e-16 over the step.
        EXPECT_LT(SlopeError(energy, control, 1e-6), 1e-7) << softness;
        EXPECT_GT(SlopeError(energy, control, 1e-6, 1e-3), 1e-6) << softness;
    }
}

TEST(CornerEnergy, IsNoneForACubeAndGrowsAsItFlattens) {
    const std::vector<std::array<Index, 4>> corner = {{0, 1, 2, 3}};
    const std::vector<double> enough = {0.99};
    double last = -1;
    for (double height : {1.0, 0.3, 0.1, 0.01, 0.0, -0.01, -0.1, -1.0}) {
        const std::vector<double> at = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0.1, 0, height};
        const double energy = CornerEnergy(corner, enough, at, 0.05, 1, {});
        if (height == 1.0) {
            EXPECT_EQ(energy, 0);
        }
        EXPECT_GT(energy, last) << height;
        last = energy;
    }
    EXPECT_TRUE(std::isfinite(CornerEnergy(corner, enough, std::vector<double>(12), 0.05, 1, {})));
}

TEST(NormalEquations, AreTheSumOfSquaresOfTheirRows) {
    TestShapes::Random random(3);
    std::vector<double> at(24), moved(24);
    for (double& x : at) x = random.Uniform();
    for (double& x : moved) x = 0.1 * random.Uniform();
    NormalEquations form(at);
    double sum = 0;
    for (int i = 0; i < 20; ++i) {
        LinearRow row;
        for (Index p = 0; p < 4; ++p) row.weights.emplace_back((i + 3 * p) % 8, random.Uniform() - 0.3);
        for (double& x : row.goal) x = random.Uniform();
        for (std::size_t r = 0; r < 3; ++r) {
            for (std::size_t c = r; c < 3; ++c) row.matrix[3 * r + c] = row.matrix[3 * c + r] = random.Uniform();
        }
        form.Add(row.weights, row.goal, row.matrix);
        for (std::size_t r = 0; r < 3; ++r) {
            double residual = 0;
            for (std::size_t c = 0; c < 3; ++c) {
                double off = -row.goal[c];
                for (const auto& w : row.weights) {
                    const std::size_t k = 3 * static_cast<std::size_t>(w.first) + c;
                    off += w.second * (at[k] + moved[k]);
                }
                residual += row.matrix[3 * r + c] * off;
            }
            sum += 0.5 * residual * residual;
        }
    }
    EXPECT_NEAR(form.Evaluate(moved, {}), sum, 1e-13 * sum);
    const auto energy = [&](std::span<const double> to, std::span<double> slope) { return form.Evaluate(to, slope); };
    // Quadratic: differences are exact but for rounding, 1e-16 over the step.
    EXPECT_LT(SlopeError(energy, moved, 1e-4), 1e-10);
    EXPECT_GT(SlopeError(energy, moved, 1e-4, 1e-3), 1e-6);
    // The slope at a place, less that at another one, along an axis of a point: its block with itself.
    std::vector<double> a(24), b(24), x(24);
    form.Evaluate(x, a);
    x[3 * 5 + 1] = 1;
    form.Evaluate(x, b);
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(form.Diagonal(5)[3 * c + 1], b[15 + c] - a[15 + c], 1e-12);
}

double SumOfSquares(const std::vector<LinearRow>& rows, const std::vector<double>& control) {
    double sum = 0;
    for (const LinearRow& row : rows) {
        for (double r : row.Residuals(control)) sum += r * r;
    }
    return sum;
}

TEST(TangentRows, AreTheMeanOfSquaredCosines) {
    // Flat triangles: tangents lie in them, and normals that lean by an angle have its sine with one direction.
    ControlMesh mesh = SphereCage(1);
    for (std::size_t i = 2; i < mesh.positions.size(); i += 3) mesh.positions[i] = 0;
    const Problem problem = MakeProblem(mesh, Sdc::LinearSurface{}, {}, 2, 0, true);
    ASSERT_FALSE(problem.surface.tangent_vertices.empty());
    const auto rows_for = [&](const Vec3& normal, double normals) {
        std::vector<Pair> pairs;
        const Index n = problem.surface.rows.n_rows();
        for (Index v = 0; v < n; ++v) {
            pairs.push_back({{v, v, v}, {1, 0, 0}, {}, normal, 0, 1.0 / n});
        }
        std::vector<LinearRow> rows;
        AddTangentRows(problem.surface, pairs, problem.control, normals, rows);
        return rows;
    };
    EXPECT_LT(SumOfSquares(rows_for({0, 0, 1}, 1), problem.control), 1e-30);
    const double angle = 0.1, sine = std::sin(angle);
    const double leaning = SumOfSquares(rows_for({sine, 0, std::cos(angle)}, 1), problem.control);
    EXPECT_GT(leaning, 0.5 * sine * sine);  // of both tangents at right angles it would be sine^2
    EXPECT_LT(leaning, 2 * sine * sine);
    EXPECT_NEAR(SumOfSquares(rows_for({sine, 0, std::cos(angle)}, 7), problem.control), 7 * leaning, 1e-12);
    EXPECT_TRUE(rows_for({1, 0, 0}, 1).empty()) << "across";
}

TEST(SpringRows, AreTheMeanOfSquaredDistances) {
    const std::vector<double> at = {0, 0, 0, 1, 0, 0, 0, 2, 0};
    std::vector<LinearRow> rows;
    AddSpringRows(std::vector<std::vector<Index>>{{1, 2}, {0}, {0}}, 6, rows);
    EXPECT_EQ(rows.size(), 2u);
    EXPECT_NEAR(SumOfSquares(rows, at), 6 * (1 + 4) / 2., 1e-12);
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
