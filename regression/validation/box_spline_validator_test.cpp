// SPDX-License-Identifier: Apache-2.0
// The box-spline validator: passes on the framework's tables, and catches faults planted in each of them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <utility>

#include "validation/box_spline_regular.h"
#include "validation/solid_shapes.h"

namespace SolidSubdiv::Validation {
namespace {

constexpr double kTolerance = 1e-12;  // that of the validator

class BoxSplineValidator : public testing::Test {
  protected:
    BoxSplineValidator()
        : refined_(RefineBlock(MakeTrussBlock({4, 4, 4}, TrussCells::RefinedOnce), 2)),
          cascaded_(Far::StencilTable::Create(refined_.refiner, Sdc::BoxSpline{})) {
        Shaker shaker(3);
        for (std::size_t i = 0; i < 3 * refined_.block.vertices.size(); ++i) control_.push_back(shaker.Next());
    }

    /// The row of a vertex of level 1 in the middle of the block.
    Index InnerRow() const { return refined_.block.VertexAt({2, 2, 2}); }

    Far::StencilTable WithWeightOff(double by) const {
        std::vector<Far::StencilRows<double>> levels = {cascaded_.level(1), cascaded_.level(2)};
        levels[0].weights[levels[0].offsets[InnerRow()]] += by;
        return Far::StencilTable::FromRows(cascaded_.n_control_vertices(), levels);
    }

    RefinedBlock refined_;
    Far::StencilTable cascaded_;
    std::vector<double> control_;
    Findings findings_;
};

TEST_F(BoxSplineValidator, CatchesAWeightOffByAMillionthInTheValues) {
    CompareValues(refined_, cascaded_, control_, findings_);
    ASSERT_TRUE(findings_.Passes(kTolerance)) << findings_.where;
    CompareValues(refined_, WithWeightOff(1e-6), control_, findings_);
    EXPECT_FALSE(findings_.Passes(kTolerance));
    EXPECT_LE(findings_.largest_error, 1e-6);
}

TEST_F(BoxSplineValidator, CatchesAWeightOffByAMillionthInTheLimitOfValues) {
    CompareLimitOfValues(refined_, cascaded_, control_, findings_);
    ASSERT_TRUE(findings_.Passes(kTolerance)) << findings_.where;
    CompareLimitOfValues(refined_, WithWeightOff(1e-6), control_, findings_);
    EXPECT_FALSE(findings_.Passes(kTolerance));
}

TEST_F(BoxSplineValidator, CatchesAWeightOffByAMillionthInCompositeRows) {
    const std::vector<Index> vertices = RegularVertices(refined_, 2);
    const auto table =
        Far::StencilTable::CreateComposite(refined_.refiner, Sdc::BoxSpline{}, {Far::CompositeRows{2, vertices}});
    Far::StencilRows<double> rows = table.level(1);
    CompareRows(refined_, rows, 2, vertices, findings_);
    ASSERT_TRUE(findings_.Passes(kTolerance)) << findings_.where;
    rows.weights[rows.offsets[9]] += 1e-6;
    CompareRows(refined_, rows, 2, vertices, findings_);
    EXPECT_NEAR(findings_.largest_error, 1e-6, kTolerance);
}

TEST_F(BoxSplineValidator, CatchesAWeightOffByAMillionthInLimitRows) {
    Far::StencilRows<double> limits = Far::LimitStencilTable::Create(refined_.refiner, Sdc::BoxSpline{}, {0}).rows();
    CompareLimitRows(refined_, cascaded_, limits, 0, control_, findings_);
    ASSERT_TRUE(findings_.Passes(kTolerance)) << findings_.where;
    limits.weights[limits.offsets[InnerRow()]] += 1e-6;
    CompareLimitRows(refined_, cascaded_, limits, 0, control_, findings_);
    EXPECT_FALSE(findings_.Passes(kTolerance));
    EXPECT_LE(findings_.largest_error, 1e-6);
}

TEST_F(BoxSplineValidator, CatchesSwappedChildren) {
    const std::vector<Index> vertices = RegularVertices(refined_, 2);
    std::swap(refined_.points[2][vertices[0]], refined_.points[2][vertices[1]]);
    CompareValues(refined_, cascaded_, control_, findings_);
    EXPECT_GT(findings_.largest_error, 1e-3);
}

TEST_F(BoxSplineValidator, CatchesThePrintedEdgeRule) {
    Sdc::BoxSpline printed;
    printed.edge_rule = Sdc::EdgeRule::Printed2002;
    CompareValues(refined_, Far::StencilTable::Create(refined_.refiner, printed), control_, findings_);
    EXPECT_GT(findings_.largest_error, 1e-3);
}

TEST_F(BoxSplineValidator, CatchesATableOfAnotherMesh) {
    const RefinedBlock other = RefineBlock(MakeTrussBlock({4, 4, 2}, TrussCells::Tets), 2);
    std::vector<double> control(3 * other.block.vertices.size());
    CompareValues(other, Far::StencilTable::Create(other.refiner, Sdc::BoxSpline{}), control, findings_);
    ASSERT_TRUE(findings_.Passes(kTolerance));
    RefinedBlock mixed = RefineBlock(other.block, 2);
    mixed.points[1].pop_back();
    CompareValues(mixed, Far::StencilTable::Create(other.refiner, Sdc::BoxSpline{}), control, findings_);
    EXPECT_THAT(findings_.faults, testing::SizeIs(1));
}

}  // namespace
}  // namespace SolidSubdiv::Validation
