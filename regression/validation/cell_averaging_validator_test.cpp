// SPDX-License-Identifier: Apache-2.0
// The comparison with plain averages passes, and catches a weight that is off, another scheme and another rule.
#include <gtest/gtest.h>

#include "validation/cell_averaging.h"
#include "validation/cell_shapes.h"
#include "validation/meshes.h"

namespace SolidSubdiv::Validation {
namespace {

constexpr double kTolerance = 1e-12;  // that of the validator

Far::StencilTable WithWeightOff(const Far::StencilTable& table, Index row) {
    std::vector<Far::StencilRows<double>> levels = {table.level(1)};
    levels[0].weights[levels[0].offsets[row]] += 1e-6;
    return Far::StencilTable::FromRows(table.n_control_vertices(), levels);
}

TEST(CellAveragingValidator, CatchesFaultsInTetOctAverages) {
    std::vector<SolidShape> shapes = ManifoldShapes();
    const SolidShape& shape =
        *std::find_if(shapes.begin(), shapes.end(), [](const auto& s) { return s.name == "octet-truss"; });
    const CellArrays cells(shape.complex);
    auto refiner = Far::TopologyRefiner::Create(cells.Descriptor(shape.n_vertices()), Sdc::Split::TetOct);
    refiner.RefineUniform({.max_level = 1});
    const auto passes = [&](const Far::StencilTable& table) {
        Findings findings;
        CompareWithTetOctAverages(refiner, table, shape.positions, 1, findings);
        return findings.Passes(kTolerance);
    };
    const auto table = Far::StencilTable::Create(refiner, Sdc::SmoothTet{});
    EXPECT_TRUE(passes(table));
    EXPECT_FALSE(passes(Far::StencilTable::Create(refiner, Sdc::BoxSpline{})));
    // Points inside: of the last edge inside, and of the last octahedron.
    const Far::Level& base = refiner.level(0);
    Index inner = base.n_edges - 1;
    while (base.edge_tags[inner].rule() != Vtr::Rule::Solid) --inner;
    EXPECT_FALSE(passes(WithWeightOff(table, base.n_vertices + inner)));
    EXPECT_FALSE(passes(WithWeightOff(table, base.n_vertices + base.n_edges + base.n_octs - 1)));
    inner = 0;
    while (base.vertex_tags[inner].rule() != Vtr::Rule::Solid) ++inner;
    EXPECT_FALSE(passes(WithWeightOff(table, inner)));
}

TEST(CellAveragingValidator, CatchesFaultsInPolyhedralAverages) {
    const CellShape shape = CellsAroundEdge(5, CellsAround::InTurn);
    const DescribedCells mesh(shape);
    auto refiner = Far::TopologyRefiner::Create(mesh.descriptor, Sdc::Split::Polyhedral);
    refiner.RefineUniform({.max_level = 1});
    const auto passes = [&](const Far::StencilTable& table, bool sharp = true) {
        Findings findings;
        CompareWithPolyhedralAverages(refiner, table, shape.positions, 1, sharp, findings);
        return findings.Passes(kTolerance);
    };
    const auto table = Far::StencilTable::Create(refiner, Sdc::Mlca{});
    EXPECT_TRUE(passes(table));
    EXPECT_FALSE(passes(table, false));
    EXPECT_FALSE(passes(Far::StencilTable::Create(refiner, Sdc::CatmullClarkSolid{})));
    EXPECT_FALSE(passes(Far::StencilTable::Create(refiner, Sdc::Mlca{.surface = Sdc::BoundarySurface::CatmullClark})));
    // Every row is compared: this shape is a manifold with sharp edges and corners.
    for (Index row = 0; row < table.level(1).n_rows(); ++row) EXPECT_FALSE(passes(WithWeightOff(table, row))) << row;
}

}  // namespace
}  // namespace SolidSubdiv::Validation
