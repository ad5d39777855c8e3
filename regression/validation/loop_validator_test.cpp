// SPDX-License-Identifier: Apache-2.0
// The comparison with OpenSubdiv: passes on what the framework gives, and catches faults planted in it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <utility>

#include "validation/meshes.h"
#include "validation/or_skip.h"
#include "validation/solid_shapes.h"
#include "validation/surface_compare.h"

namespace SolidSubdiv::Validation {
namespace {

constexpr double kTolerance = 1e-12;  // that of the validator

/// One solid refined twice by both, with everything that a comparison needs.
class LoopValidator : public testing::Test {
  protected:
    void SetUp() override {
        shape_ = VoxelSolid("ring", "", {{"###", "#.#", "###"}});
        const CellArrays cells(shape_.complex);
        refiner_.emplace(Far::TopologyRefiner::Create(cells.Descriptor(shape_.n_vertices()), Sdc::Split::TetOct));
        Far::UniformRefinementOptions options;
        options.max_level = 2;
        refiner_->RefineUniform(options);
        start_ = TakeSurface(BoundaryTriangles(shape_.complex), shape_.positions);
        OrSkip([&] { oracle_ = RefineByOpenSubdiv(start_.surface, 2, 2); });
        if (oracle_.empty()) return;
        match_ = FollowChildren(*refiner_, start_, oracle_, findings_);
        ASSERT_TRUE(findings_.faults.empty());
        ASSERT_EQ(match_.size(), 3U);
    }

    Far::StencilTable Composite(int level) const {
        return Far::StencilTable::CreateComposite(*refiner_, Sdc::BoxSpline{}, {{level, match_[level]}});
    }

    SolidShape shape_;
    std::optional<Far::TopologyRefiner> refiner_;
    SurfaceOfMesh start_;
    std::vector<SurfaceLevel> oracle_;
    Match match_;
    Findings findings_;
};

TEST_F(LoopValidator, PassesOnTheFrameworksOwnTables) {
    CompareTriangles(*refiner_, oracle_, match_, findings_);
    ComparePositions(Far::StencilTable::Create(*refiner_, Sdc::BoxSpline{}), shape_.positions, oracle_, match_,
                     findings_);
    for (int l : {1, 2}) CompareRows(Composite(l).level(1), l, start_, oracle_, findings_);
    EXPECT_TRUE(findings_.Passes(kTolerance)) << findings_.where << " " << findings_.largest_error;
}

TEST_F(LoopValidator, CatchesAWeightOffByAMillionthInThePositions) {
    const auto cascaded = Far::StencilTable::Create(*refiner_, Sdc::BoxSpline{});
    std::vector<Far::StencilRows<double>> levels = {cascaded.level(1), cascaded.level(2)};
    const Index row = match_[1][5];  // a vertex of the boundary
    levels[0].weights[levels[0].offsets[row]] += 1e-6;
    ComparePositions(Far::StencilTable::FromRows(cascaded.n_control_vertices(), levels), shape_.positions, oracle_,
                     match_, findings_);
    EXPECT_FALSE(findings_.Passes(kTolerance));
    EXPECT_GT(findings_.largest_error, 1e-8);
    EXPECT_LT(findings_.largest_error, 1e-6);
}

TEST_F(LoopValidator, CatchesAWeightOffByAMillionthInCompositeRows) {
    Far::StencilRows<double> rows = Composite(2).level(1);
    rows.weights[rows.offsets[7] + 1] += 1e-6;
    CompareRows(rows, 2, start_, oracle_, findings_);
    EXPECT_FALSE(findings_.Passes(kTolerance));
    EXPECT_NEAR(findings_.largest_error, 1e-6, kTolerance);
    EXPECT_THAT(findings_.where, testing::HasSubstr("row 7 of level 2"));
}

TEST_F(LoopValidator, CatchesAnInnerVertexInABoundaryRow) {
    // A whole weight moved from one control vertex to another leaves the sum of the row as it was.
    Far::StencilRows<double> rows = Composite(1).level(1);
    rows.indices[rows.offsets[3]] = (rows.indices[rows.offsets[3]] + 1) % shape_.n_vertices();
    CompareRows(rows, 1, start_, oracle_, findings_);
    EXPECT_FALSE(findings_.Passes(kTolerance));
}

TEST_F(LoopValidator, CatchesSwappedChildren) {
    std::swap(match_[2][3], match_[2][40]);
    Findings triangles, positions, rows;
    CompareTriangles(*refiner_, oracle_, match_, triangles);
    ComparePositions(Far::StencilTable::Create(*refiner_, Sdc::BoxSpline{}), shape_.positions, oracle_, match_,
                     positions);
    CompareRows(Composite(2).level(1), 2, start_, oracle_, rows);
    EXPECT_FALSE(triangles.faults.empty());
    EXPECT_FALSE(positions.Passes(kTolerance));
    EXPECT_FALSE(rows.Passes(kTolerance));
}

TEST_F(LoopValidator, CatchesATriangleTurnedRound) {
    oracle_[0].triangles[2] = {oracle_[0].triangles[2][1], oracle_[0].triangles[2][0], oracle_[0].triangles[2][2]};
    CompareTriangles(*refiner_, oracle_, match_, findings_);
    EXPECT_THAT(findings_.faults, testing::ElementsAre(testing::HasSubstr("level 0")));
}

TEST_F(LoopValidator, CatchesAnEdgeThatIsNotThere) {
    start_.mesh_vertices[0] = start_.mesh_vertices[1];
    const Match match = FollowChildren(*refiner_, start_, oracle_, findings_);
    EXPECT_EQ(match.size(), 1U);
    EXPECT_FALSE(findings_.Passes(kTolerance));
}

TEST(LoopComparison, CatchesWarrensWeights) {
    const SolidShape shape = Spindle(5);
    const CellArrays cells(shape.complex);
    Sdc::BoxSpline scheme;
    const auto triangles = BoundaryTriangles(shape.complex);
    OrSkip([&] {
        const auto loop = CompareWithLoop(cells.Descriptor(7), scheme, triangles, shape.positions, {}, {2, 2});
        EXPECT_TRUE(loop.Passes(kTolerance)) << loop.where;
        scheme.loop_weights = Sdc::LoopWeights::Warren;
        EXPECT_FALSE(
            CompareWithLoop(cells.Descriptor(7), scheme, triangles, shape.positions, {}, {2, 2}).Passes(kTolerance));
    });
}

}  // namespace
}  // namespace SolidSubdiv::Validation
