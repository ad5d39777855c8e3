// SPDX-License-Identifier: Apache-2.0
// Limit masks among polyhedra: fixed points of refinement, tensor products in regular places, where refinement goes.
#include <algorithm>
#include <cmath>
#include <set>

#include <gtest/gtest.h>
#include <solidsubdiv/far/limit_stencil_table.h>
#include <solidsubdiv/far/local_matrix.h>

#include "far/far_testing.h"

namespace SolidSubdiv {
namespace {

using TestFar::Describe;
using TestShapes::PolyhedralShape;

std::vector<std::pair<std::string, PolyhedralShape>> Shapes() {
    auto shapes = TestShapes::PolyhedralShapes();
    for (auto& entry : shapes) {
        for (std::size_t i = 0; i < entry.second.positions.size(); ++i) {
            entry.second.positions[i] += 0.1 * std::sin(7.0 * static_cast<double>(i));
        }
    }
    return shapes;
}

Far::TopologyRefiner Refined(const PolyhedralShape& shape, int levels) {
    auto refiner = Far::TopologyRefiner::Create(Describe(shape), Sdc::Split::Polyhedral);
    refiner.RefineUniform({.max_level = levels, .full_topology_in_last_level = true});
    return refiner;
}

TEST(PolyhedralLimitMask, IsAFixedPointOfRefinement) {
    for (const auto& [name, shape] : Shapes()) {
        const auto refiner = Refined(shape, 2);
        for (const auto& [scheme_name, scheme] : TestFar::AllSchemes(Sdc::Split::Polyhedral)) {
            if (!TestFar::IsSolid(scheme)) continue;
            SCOPED_TRACE(name + ", " + scheme_name);
            TestFar::ExpectLimitsAreFixedPoints(refiner, scheme, shape.positions, 5e-14);
        }
    }
}

TEST(PolyhedralLimitMask, RowsSumToOneAndNameNoVertexTwice) {
    for (const auto& [name, shape] : Shapes()) {
        const auto refiner = Refined(shape, 1);
        const auto table = Far::LimitStencilTable::Create(refiner, Sdc::Mlca{}, {.level = 1});
        for (Index v = 0; v < table.rows().n_rows(); ++v) {
            const auto indices = table.rows().Indices(v);
            double sum = 0;
            for (double w : table.rows().Weights(v)) sum += w;
            EXPECT_NEAR(sum, 1, 1e-14) << name << " " << v;
            EXPECT_EQ(std::set<Index>(indices.begin(), indices.end()).size(), indices.size()) << name << " " << v;
        }
    }
}

TEST(PolyhedralLimitMask, IsWhereDeepRefinementGoes) {
    const PolyhedralShape shape = Shapes()[1].second;
    const auto refiner = Refined(shape, 4);
    for (const Sdc::Scheme& scheme : {Sdc::Scheme(Sdc::CatmullClarkSolid{}), Sdc::Scheme(Sdc::Mlca{})}) {
        const auto deep = TestFar::Apply(Far::StencilTable::Create(refiner, scheme), shape.positions);
        const auto limits =
            TestFar::Limits(Far::LimitStencilTable::Create(refiner, scheme, {.level = 0}), shape.positions);
        // The distance falls by about 4 a level.
        TestFar::ExpectNear(std::vector<double>(deep.begin(), deep.begin() + static_cast<long>(limits.size())), limits,
                            1e-2);
    }
}

// The star gives the closed form where there is one.
TEST(PolyhedralLimitMask, InRegularPlacesIsTheLeftEigenvectorOfTheStar) {
    const auto refiner = Refined(TestShapes::HexBlock(2), 0);
    const auto limits = Far::LimitStencilTable::Create(refiner, Sdc::Mlca{}, {.level = 0});
    const Index middle = 13;
    const auto matrix = Far::MakeLocalMatrix(refiner.polyhedral_level(0), Sdc::Mlca{}, middle);
    ASSERT_TRUE(matrix);
    ASSERT_EQ(matrix->size(), 27);
    std::vector<double> mask = Far::LimitMaskOf(*matrix);
    std::vector<double> closed(limits.rows().Weights(middle).begin(), limits.rows().Weights(middle).end());
    ASSERT_EQ(closed.size(), mask.size());
    EXPECT_NEAR(mask[0], 64.0 / 216, 1e-15);
    std::sort(mask.begin(), mask.end());
    std::sort(closed.begin(), closed.end());
    TestFar::ExpectNear(mask, closed, 1e-15);
}

TEST(PolyhedralLimitMask, CreasesThatFadeHaveNoneYet) {
    PolyhedralShape shape = TestShapes::HexBlock(2);
    Far::TopologyDescriptor d = Describe(shape);
    // An edge of the boundary: vertex 12 is the middle of the side x = 0.
    const std::vector<Index> ends{12, 3};
    const std::vector<float> one{1.5f};
    d.crease_edges = ends, d.crease_sharpness = one;
    auto refiner = Far::TopologyRefiner::Create(d, Sdc::Split::Polyhedral);
    refiner.RefineUniform({.max_level = 2, .full_topology_in_last_level = true});
    EXPECT_EQ(Far::LimitStencilTable::Create(refiner, Sdc::CatmullClarkSolid{}, {.level = 0}).without_limit(),
              (std::vector<Index>{3, 12}));
    EXPECT_TRUE(
        Far::LimitStencilTable::Create(refiner, Sdc::CatmullClarkSolid{}, {.level = 2}).without_limit().empty());
}

}  // namespace
}  // namespace SolidSubdiv
