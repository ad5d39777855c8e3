// SPDX-License-Identifier: Apache-2.0
// Derivatives of fits pass, and wrong ones are caught.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <solidsubdiv/apps/fit/internal/blocks.h>

#include "validation/fit_jacobians.h"
#include "validation/fit_shapes.h"

namespace SolidSubdiv::Validation {
namespace {

using Fit::Internal::LinearBlock;
using testing::Contains;
using testing::HasSubstr;

constexpr double kTolerance = 1e-7;

/// A block one of whose derivatives is off.
class Spoiled final : public ceres::CostFunction {
  public:
    Spoiled(const ceres::CostFunction& block, double by) : block_(block), by_(by) {
        set_num_residuals(block.num_residuals());
        *mutable_parameter_block_sizes() = block.parameter_block_sizes();
    }
    bool Evaluate(double const* const* parameters, double* residuals, double** jacobians) const override {
        block_.Evaluate(parameters, residuals, jacobians);
        if (jacobians) jacobians[1][4] += by_;
        return true;
    }

  private:
    const ceres::CostFunction& block_;
    double by_;
};

TEST(FitJacobiansValidator, CatchesADerivativeThatIsOff) {
    const LinearBlock::Row row{
        .weights = {{0, 0.5}, {1, 0.5}}, .goal = {1, 2, 3}, .matrix = {1, 0, 0, 0, 1, 0, 0, 0, 1}};
    const LinearBlock block(std::span(&row, 1));
    const std::vector<double> control = {1, 0, 0, 0, 1, 0};
    Findings good, bad;
    CompareJacobian(Spoiled(block, 0), block.control_points(), control, "rows", good);
    EXPECT_TRUE(good.Passes(kTolerance)) << good.where;
    CompareJacobian(Spoiled(block, 1e-6), block.control_points(), control, "rows", bad);
    EXPECT_FALSE(bad.Passes(kTolerance));
    EXPECT_EQ(bad.where, "rows, residual 1, control point 1");
}

TEST(FitJacobiansValidator, CatchesASlopeThatIsOff) {
    const auto energy_spoiled_by = [](double by) {
        return [by](std::span<const double> at, std::span<double> slope) {
            if (!slope.empty()) slope[1] += 3 * at[1] * at[1] + by, slope[0] += 1;
            return at[0] + at[1] * at[1] * at[1];
        };
    };
    const std::vector<double> at = {1, 2, 3};
    Findings good, bad;
    CompareSlope(energy_spoiled_by(0), at, "energy", good);
    EXPECT_TRUE(good.Passes(kTolerance)) << good.where;
    CompareSlope(energy_spoiled_by(1e-4), at, "energy", bad);
    EXPECT_FALSE(bad.Passes(kTolerance));
    EXPECT_EQ(bad.where, "energy, control point 0");
}

TEST(FitJacobiansValidator, AsksForEveryKindOfRow) {
    const FitTarget ball = MakeFitBall(5);
    const FitCase solid = FitCasesAround(ball.View(), 64)[0];
    Fit::Problem problem = MakeProblem(solid.mesh, solid.scheme, ball.View(), 1);
    Findings good;
    CheckJacobians(problem, 2, good);
    EXPECT_TRUE(good.Passes(kTolerance)) << good.where;
    for (auto& around : problem.neighbors) around.clear();
    problem.corners.resize(1);
    Findings poor;
    CheckJacobians(problem, 2, poor);
    EXPECT_THAT(poor.faults, Contains(HasSubstr("no fair rows")));
    EXPECT_THAT(poor.faults, Contains(HasSubstr("nowhere or everywhere")));
}

}  // namespace
}  // namespace SolidSubdiv::Validation
