// SPDX-License-Identifier: Apache-2.0
// Control points that nothing reads cost nothing, of large lattices and in files that claim many.
#include <solidsubdiv/apps/deform/deformer.h>
#include <solidsubdiv/apps/deform/internal/used_columns.h>

#include <gtest/gtest.h>

#include <filesystem>

#include "apps/deform/deform_testing.h"

namespace SolidSubdiv::Deform {
namespace {

TEST(UsedColumns, AreRenumberedWhereFewOfManyAreRead) {
    Array<Index> a{70, 5, 70}, b{9};
    const Internal::UsedColumns few(100, {&a, &b});
    EXPECT_EQ(a, (Array<Index>{2, 0, 2}));
    EXPECT_EQ(b, (Array<Index>{1}));
    EXPECT_EQ(few.size(), 3);
    for (Index place = 0; place < 3; ++place) EXPECT_EQ(few.PlaceOf(few[place]), place);
    EXPECT_EQ(few.PlaceOf(6), kNoIndex);
    EXPECT_EQ(few.PlaceOf(99), kNoIndex);

    Array<Index> many{1, 3, 3, 1};
    const Internal::UsedColumns all(4, {&many});
    EXPECT_EQ(many, (Array<Index>{1, 3, 3, 1}));
    EXPECT_EQ(all.size(), 4);
    EXPECT_EQ(all.PlaceOf(2), 2);
}

TEST(Deformers, OfFewPointsInALargeLattice_KeepFewControlPoints) {
    const ControlLattice lattice = LatticeOf(TestShapes::HexBlock(20));
    const std::vector<double> points{lattice.positions.begin(), lattice.positions.begin() + 3};
    const Index n_control = lattice.n_control_points();
    ASSERT_GT(n_control, 9000);
    for (int levels : {0, 1}) {
        const auto e = Embedding::Create(lattice.View(), lattice.positions, points, {.levels = levels});
        Deformer deformer(e);
        EXPECT_LT(deformer.Bytes(), 10000) << levels;  // 32 bytes a control point would be 296,352

        auto control = Moved(lattice.positions, 0.2, 1);
        std::vector<double> moved(3), anew(3);
        deformer.Deform(control, moved);
        const auto rows = e.ControlRows(std::vector<Index>{0});
        for (std::size_t c = 0; c < 3; ++c) {
            double sum = 0;
            for (std::size_t k = 0; k < rows.indices.size(); ++k) {
                sum += rows.weights[k] * control[3 * static_cast<std::size_t>(rows.indices[k]) + c];
            }
            EXPECT_NEAR(moved[c], sum, 1e-13);  // round-off of sums of coordinates of about 1
        }

        const Index read = rows.indices.front(), unread = n_control - 1;
        for (double& x : control) x += 1;  // of which Update is told two
        for (Index i : {read, unread}) {
            const std::size_t n_written = deformer.Update({&i, 1}, control, moved).size();
            EXPECT_EQ(n_written, deformer.Affected({&i, 1}).size());
            EXPECT_EQ(n_written, i == read ? 1u : 0u);
        }
        for (std::size_t i = 0; i < control.size(); ++i) control[i] -= i / 3 != static_cast<std::size_t>(read);
        Deformer(e).Deform(control, anew);
        for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(moved[c], anew[c], 1e-13);  // x + 1 - 1 rounds
    }
}

/// Small embeddings of every kind; the last claims 2^31 - 1 control points in 560 bytes.
TEST(Deformers, OfTheFuzzersSeeds_TakeNoMoreThanWhatIsInThem) {
    const std::filesystem::path seeds = SOLIDSUBDIV_SOURCE "/regression/fuzz/corpus/fuzz_embedding";
    for (const char* name :
         {"hexes", "hexes_level_0", "tets", "tets_level_2", "rows", "rows_level_0", "many_control_points"}) {
        const auto e = Embedding::Load(seeds / name);
        EXPECT_GT(e.n_points(), 0) << name;
        Deformer deformer(e);
        EXPECT_LT(deformer.Bytes(), 10000) << name;
        EXPECT_FALSE(deformer.Affected(std::vector<Index>{0}).empty()) << name;
        EXPECT_EQ(e.ControlRows(std::vector<Index>{0}).n_rows(), 1) << name;
    }
    EXPECT_EQ(Embedding::Load(seeds / "many_control_points").n_control_points(), 2147483647);
}

}  // namespace
}  // namespace SolidSubdiv::Deform
