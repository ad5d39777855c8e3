// SPDX-License-Identifier: Apache-2.0
// Limit masks: fixed points of refinement, rows that sum to one, the known regular values.
#include <gtest/gtest.h>
#include <solidsubdiv/far/limit_stencil_table.h>
#include <solidsubdiv/far/local_matrix.h>

#include "far/far_testing.h"

namespace {

using namespace SolidSubdiv;
using namespace SolidSubdiv::TestFar;

// The limit of a vertex is the same whether taken before or after a refinement.
TEST(LimitMask, IsAFixedPointOfRefinement) {
    for (const auto& [name, shape] : TestShapes::AllShapes()) {
        for (const auto& [scheme_name, scheme] : AllSchemes()) {
            if (!IsSolid(scheme) && !(shape.tets.empty() && shape.octs.empty())) continue;
            SCOPED_TRACE(std::string(name) + ", " + scheme_name);
            const auto refiner = Refined(shape, 2, true);
            ExpectLimitsAreFixedPoints(refiner, scheme, shape.positions, 2e-14);
        }
    }
}

TEST(LimitMask, IsWhereDeepRefinementGoes) {
    auto shape = TestShapes::RandomSubset(TestShapes::KuhnBlock(2), 80, 6);
    TestShapes::Jitter(shape, 0.1, 8);
    const auto refiner = Refined(shape, 5);
    const auto deep = Apply(Far::StencilTable::Create(refiner, Sdc::BoxSpline{}), shape.positions);
    auto limits = Limits(Far::LimitStencilTable::Create(refiner, Sdc::BoxSpline{}, {.level = 0}), shape.positions);
    // The distance falls by about 4 a level (by 2 at worst): 4^-5 of a cell's size.
    ExpectNear(std::vector<double>(deep.begin(), deep.begin() + static_cast<long>(limits.size())), limits, 2e-2);
    double nearest_change = 1;
    for (std::size_t i = 0; i < limits.size(); ++i)
        nearest_change = std::min(nearest_change, std::abs(limits[i] - shape.positions[i]));
    EXPECT_LT(nearest_change, 1);
}

TEST(LimitMask, RegularInnerVerticesHaveTheBoxSplinesValues) {
    const auto refiner = Refined(TestShapes::SingleTet(), 3, true);
    const auto table = Far::LimitStencilTable::Create(refiner, Sdc::BoxSpline{});
    const auto& level = refiner.level(3);
    int n_inner = 0;
    for (Index v = 0; v < level.n_vertices; ++v) {
        if (level.vertex_tags[v].rule() != Vtr::Rule::Solid) continue;
        ++n_inner;
        auto weights = std::vector<double>(table.rows().Weights(v).begin(), table.rows().Weights(v).end());
        ASSERT_EQ(weights.size(), 15u);
        EXPECT_NEAR(weights[0], 2.0 / 5, 1e-15);
        std::sort(weights.begin() + 1, weights.end());
        for (int i = 1; i <= 6; ++i) EXPECT_NEAR(weights[i], 1.0 / 30, 1e-15);
        for (int i = 7; i <= 14; ++i) EXPECT_NEAR(weights[i], 1.0 / 20, 1e-15);
    }
    EXPECT_GT(n_inner, 30);
}

TEST(LimitMask, APlantedFaultInARowBreaksTheFixedPoint) {
    const auto shape = TestShapes::KuhnBlock(2);
    const auto refiner = Refined(shape, 1, true);
    auto rows = Far::StencilTable::Create(refiner, Sdc::BoxSpline{}).level(1);
    const Index inner = 13;
    rows.weights[rows.offsets[inner]] += 1e-6;
    rows.weights[rows.offsets[inner] + 1] -= 1e-6;
    const auto a = Limits(Far::LimitStencilTable::Create(refiner, Sdc::BoxSpline{}, {.level = 0}), shape.positions);
    const auto b = Limits(Far::LimitStencilTable::Create(refiner, Sdc::BoxSpline{}, {.level = 1}),
                          Apply(Far::StencilTable::FromRows(shape.n_vertices, {rows}), shape.positions));
    double largest = 0;
    for (int k = 0; k < 3; ++k) largest = std::max(largest, std::abs(a[3 * inner + k] - b[3 * inner + k]));
    EXPECT_GT(largest, 1e-8);
}

TEST(LimitStencilTable, NeedsFullTopology) {
    const auto refiner = Refined(TestShapes::SingleTet(), 1);
    EXPECT_THROW(Far::LimitStencilTable::Create(refiner, Sdc::BoxSpline{}), InvalidInput);
    EXPECT_NO_THROW(Far::LimitStencilTable::Create(refiner, Sdc::BoxSpline{}, {.level = 0}));
    EXPECT_THROW(Far::LimitStencilTable::Create(refiner, Sdc::BoxSpline{}, {.level = 7}), InvalidInput);
}

TEST(LocalMatrixTest, RowsSumToOneAndTheMatrixIsTheSameAtTheNextLevel) {
    const auto shape = TestShapes::KuhnBlock(3);
    const auto refiner = Refined(shape, 1, true);
    for (const auto& [name, scheme] : AllSchemes()) {
        if (!IsSolid(scheme)) continue;
        SCOPED_TRACE(name);
        for (Index v = 0; v < shape.n_vertices; ++v) {
            const auto a = Far::MakeLocalMatrix(refiner.level(0), scheme, v),
                       b = Far::MakeLocalMatrix(refiner.level(1), scheme, v);
            ASSERT_TRUE(a && b);
            ASSERT_EQ(a->size(), b->size());
            const std::size_t n = a->ring.size();
            double trace_a = 0, trace_b = 0;
            for (std::size_t i = 0; i < n; ++i) {
                double sum = 0;
                for (std::size_t j = 0; j < n; ++j) sum += a->weights[i * n + j];
                EXPECT_NEAR(sum, 1, 1e-14);
                trace_a += a->weights[i * n + i];
                trace_b += b->weights[i * n + i];
            }
            EXPECT_NEAR(trace_a, trace_b, 1e-13);
        }
    }
}

}  // namespace
