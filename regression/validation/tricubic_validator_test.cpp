// SPDX-License-Identifier: Apache-2.0
// The comparison with tricubic B-splines passes, and catches weights that are off, other rules and swapped children.
#include <gtest/gtest.h>

#include <utility>

#include "validation/tricubic_regular.h"

namespace SolidSubdiv::Validation {
namespace {

constexpr double kTolerance = 1e-12;  // that of the validator

class TricubicValidator : public testing::Test {
  protected:
    TricubicValidator() : cubes_(4, 2), table_(Far::StencilTable::Create(cubes_.refiner, Sdc::CatmullClarkSolid{})) {}

    bool ValuesPass(const Far::StencilTable& table) const {
        Findings findings;
        CompareWithKnotInsertion(cubes_, table, findings);
        return findings.Passes(kTolerance);
    }
    bool LimitsPass(const Far::StencilRows<double>& rows, int level) const {
        Findings findings;
        CompareWithTricubic(cubes_, table_, rows, level, findings);
        return findings.Passes(kTolerance);
    }
    /// The vertex in the middle of the block keeps its number.
    static constexpr Index kMiddle = 2 + 5 * (2 + 5 * 2);

    RefinedCubes cubes_;
    Far::StencilTable table_;
};

TEST_F(TricubicValidator, CatchesFaultsInValues) {
    EXPECT_TRUE(ValuesPass(table_));
    std::vector<Far::StencilRows<double>> levels = {table_.level(1), table_.level(2)};
    levels[1].weights[levels[1].offsets[kMiddle]] += 1e-6;
    EXPECT_FALSE(ValuesPass(Far::StencilTable::FromRows(table_.n_control_vertices(), levels)));
    EXPECT_FALSE(ValuesPass(Far::StencilTable::Create(cubes_.refiner, Sdc::LinearSolid{})));
    std::swap(cubes_.places[1][kMiddle], cubes_.places[1][kMiddle + 1]);
    EXPECT_FALSE(ValuesPass(table_));
    cubes_.places[1].pop_back();
    EXPECT_FALSE(ValuesPass(table_));
}

TEST_F(TricubicValidator, CatchesFaultsInLimits) {
    for (int level : {0, 2}) {
        auto rows = Far::LimitStencilTable::Create(cubes_.refiner, Sdc::Mlca{}, {.level = level}).rows();
        EXPECT_TRUE(LimitsPass(rows, level));
        rows.weights[rows.offsets[kMiddle]] += 1e-6;
        EXPECT_FALSE(LimitsPass(rows, level));
    }
}

}  // namespace
}  // namespace SolidSubdiv::Validation
