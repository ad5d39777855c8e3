// SPDX-License-Identifier: Apache-2.0
// Solids whose refined cells are looked at.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <solidsubdiv/apps/fit/fit_solid.h>
#include <solidsubdiv/sdc/errors.h>

#include "apps/fit/fit_testing.h"
#include "sanitized.h"

namespace SolidSubdiv::Fit {
namespace {

ControlMesh Mirrored(ControlMesh mesh) {
    for (std::size_t i = 0; i < mesh.positions.size(); i += 3) mesh.positions[i] = -mesh.positions[i];
    return mesh;
}

TEST(FoldedCells, NoneWhereNoneIsFolded) {
    EXPECT_THAT(FoldedCells(BulgedHexes(2), Sdc::CatmullClarkSolid{}, 2), testing::IsEmpty());
    EXPECT_THAT(FoldedCells(BulgedTets(2), Sdc::BoxSpline{}, 2), testing::IsEmpty());
}

TEST(FoldedCells, AllOfAMirroredMesh) {
    EXPECT_EQ(FoldedCells(Mirrored(BulgedHexes(2)), Sdc::CatmullClarkSolid{}, 2).size(), 8u * 64);

    ControlMesh tets_and_octahedron = BulgedTets(2);
    const Index first = tets_and_octahedron.n_vertices();
    for (double x : {5., 0., 0., 7., 0., 0., 6., -1., 0., 6., 1., 0., 6., 0., -1., 6., 0., 1.})
        tets_and_octahedron.positions.push_back(x);
    for (Index v : {0, 1, 2, 3, 4, 5}) tets_and_octahedron.octs.push_back(first + v);
    ASSERT_THAT(FoldedCells(tets_and_octahedron, Sdc::BoxSpline{}, 2), testing::IsEmpty());
    const ControlMesh mesh = Mirrored(tets_and_octahedron);
    const auto n_tets = static_cast<Index>(mesh.tets.size() / 4), n_octs = static_cast<Index>(mesh.octs.size() / 6);
    ASSERT_GT(n_tets, 1);
    ASSERT_EQ(n_octs, 1);
    // A tet has 4 tets and an octahedron, an octahedron 8 tets and 6 octahedra.
    EXPECT_EQ(FoldedCells(mesh, Sdc::BoxSpline{}, 2).size(), static_cast<std::size_t>(34 * n_tets + 124 * n_octs));
}

TEST(FoldedCells, APlantedFoldIsFoundWhereItIs) {
    ControlMesh mesh = BulgedHexes(3);
    // A corner of the block, pushed through the cell that has it.
    for (std::size_t c = 0; c < 3; ++c) mesh.positions[c] = 3 * mesh.positions[3 * 21 + c] - 2 * mesh.positions[c];
    const std::vector<Index> folded = FoldedCells(mesh, Sdc::CatmullClarkSolid{}, 2);
    ASSERT_FALSE(folded.empty());
    // The first cell's are the first 64.
    EXPECT_THAT(folded, testing::Contains(testing::Lt(64)));
    EXPECT_LT(folded.size(), 9u * 64);
}

TEST(FitSolid, SaysHowManyOfItsCellsAreFolded) {
    SOLIDSUBDIV_LONG_TEST();
    // Squeezed to a quarter on one side, whose cells turn over where nothing keeps them.
    const Sdc::Scheme scheme = Sdc::CatmullClarkSolid{};
    const ControlMesh start = BulgedHexes(3);
    const Problem problem = MakeProblem(start, scheme, {}, 3);
    Surface target = SurfaceOf(problem);
    Map(target.positions, [](std::array<double, 3> p) {
        return std::array<double, 3>{p[0], p[1], p[2] * (p[0] > 0.5 ? 0.25 : 1.0)};
    });
    const SolidFit kept = FitSolid(start, scheme, target.View(), {.max_rounds = 40}, 3);
    const SolidFit free = FitSolid(start, scheme, target.View(), {.max_rounds = 40, .barrier = 0}, 3);
    EXPECT_EQ(kept.n_folded, 0);
    EXPECT_GT(free.n_folded, 0);
    EXPECT_GT(free.n_fits, 1);
    for (const SolidFit* fit : {&kept, &free}) {
        ControlMesh mesh = start;
        mesh.positions = fit->result.control;
        EXPECT_EQ(static_cast<Offset>(FoldedCells(mesh, scheme, fit->level).size()), fit->n_folded);
    }
    EXPECT_FALSE(free.problem.fine_corners.empty());
    EXPECT_THROW(FitSolid(SphereCage(1), Sdc::Loop{}, target.View(), {}), InvalidInput);
}

}  // namespace
}  // namespace SolidSubdiv::Fit
