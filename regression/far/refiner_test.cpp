// SPDX-License-Identifier: Apache-2.0
// Refiners refuse what they can't do in one clear line, before any work; defects are found and named.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <solidsubdiv/far/primvar_refiner.h>
#include <solidsubdiv/far/topology_refiner.h>

#include "far/far_testing.h"

namespace {

using namespace SolidSubdiv;
using namespace SolidSubdiv::TestFar;

std::string Refusal(const Far::TopologyDescriptor& d) {
    try {
        Far::TopologyRefiner::Create(d, Sdc::Split::TetOct);
    } catch (const InvalidInput& e) {
        EXPECT_EQ(std::string(e.what()).find('\n'), std::string::npos);
        return e.what();
    }
    return "";
}

TEST(CreateTest, NamesTheElementAndTheValue) {
    const std::vector<Index> out_of_range{0, 1, 2, 3, 1, 2, 3, 9}, negative{0, 1, 2, -1}, twice{0, 1, 2, 2},
        short_row{0, 1, 2};
    const std::vector<Index> duplicate{0, 1, 2, 3, 3, 2, 1, 0}, three{0, 1, 2, 3, 0, 1, 2, 4, 0, 1, 2, 5},
        hex{0, 1, 2, 3, 4, 5, 6, 7};
    EXPECT_EQ(Refusal({.n_vertices = 5, .tets = out_of_range}), "tet 1 names vertex 9, but vertices are 0 to 4");
    EXPECT_EQ(Refusal({.n_vertices = 5, .tets = negative}), "tet 0 names vertex -1, but vertices are 0 to 4");
    EXPECT_EQ(Refusal({.n_vertices = 5, .tets = twice}), "tet 0 (0 1 2 2) names vertex 2 twice");
    EXPECT_THAT(Refusal({.n_vertices = 5, .tets = short_row}), testing::HasSubstr("3 indices are no multiple of 4"));
    EXPECT_EQ(Refusal({.n_vertices = 5, .tets = duplicate}), "tet 1 has the same vertices as tet 0 (3 2 1 0)");
    EXPECT_EQ(Refusal({.n_vertices = 6, .tets = three}), "face (0 1 2) bounds more than two cells: tet 0 tet 1 tet 2");
    EXPECT_THAT(Refusal({.n_vertices = 8, .hexes = hex}), testing::HasSubstr("1 hexahedron"));
    EXPECT_THAT(Refusal({.n_vertices = -1}), testing::HasSubstr("negative"));
    EXPECT_EQ(Refusal({.n_vertices = 3}), "");
}

TEST(RefineUniformTest, RefusesWhatDoesNotFitAndSaysHowManyBytes) {
    auto refiner = Far::TopologyRefiner::Create(Describe(TestShapes::KuhnBlock(4)), Sdc::Split::TetOct);
    const auto refusal = [&](const Far::UniformRefinementOptions& options) -> std::string {
        try {
            refiner.RefineUniform(options);
        } catch (const InvalidInput& e) {
            return e.what();
        }
        return "";
    };
    EXPECT_THAT(refusal({.max_level = 15}), testing::HasSubstr("more than the 2147483647 that indices count"));
    EXPECT_THAT(refusal({.max_level = 3, .max_bytes = 1000}),
                testing::HasSubstr("bytes), more than the 1000 bytes allowed"));
    EXPECT_THAT(refusal({.max_level = -1}), testing::HasSubstr("max_level is -1"));
    EXPECT_THAT(refusal({.max_level = 21}), testing::HasSubstr("max_level is 21"));
    EXPECT_EQ(refiner.max_level(), 0) << "nothing was done";
    // The bound is sharp: exactly what it takes is enough, one byte less is not.
    refiner.RefineUniform({.max_level = 2});
    const Offset bytes = refiner.Bytes();
    EXPECT_EQ(refusal({.max_level = 2, .max_bytes = bytes}), "");
    EXPECT_NE(refusal({.max_level = 2, .max_bytes = bytes - 1}), "");
}

TEST(RefineUniformTest, CountsAreKnownBeforehand) {
    auto refiner = Far::TopologyRefiner::Create(Describe(TestShapes::OctsAndTets()), Sdc::Split::TetOct);
    const auto expected = refiner.CountsAt(3);
    refiner.RefineUniform({.max_level = 3});
    EXPECT_EQ(Vtr::CountsOf(refiner.level(3)), expected);
    EXPECT_GT(refiner.CountsAt(15).n_cells(), Offset{1} << 40);
    EXPECT_THROW(refiner.CountsAt(40), InvalidInput);
}

TEST(RefineUniformTest, CanBeCancelled) {
    auto refiner = Far::TopologyRefiner::Create(Describe(TestShapes::KuhnBlock(2)), Sdc::Split::TetOct);
    int calls = 0;
    const Progress stop = [&](std::string_view, double fraction) {
        EXPECT_TRUE(fraction >= 0 && fraction <= 1);
        return ++calls < 2;
    };
    EXPECT_THROW(refiner.RefineUniform({.max_level = 3, .progress = stop}), Cancelled);
    EXPECT_EQ(calls, 2);
}

TEST(StencilTableTest, ASurfaceSchemeRefusesCells) {
    const auto refiner = Refined(TestShapes::SingleTet(), 1);
    EXPECT_THROW(Far::StencilTable::Create(refiner, Sdc::Loop{}), InvalidInput);
    EXPECT_THROW(Far::PrimvarRefiner(refiner, Sdc::Loop{}), InvalidInput);
    Sdc::BoxSpline contradiction;
    contradiction.diagonals = Sdc::Diagonals::Averaged;
    contradiction.edge_rule = Sdc::EdgeRule::Printed2002;
    EXPECT_THROW(Far::StencilTable::Create(refiner, contradiction), InvalidInput);
    EXPECT_THROW(Far::StencilTable::Create(refiner, Sdc::BoxSpline{}, {.max_level = 2}), InvalidInput);
}

TEST(PrimvarRefinerTest, RefusesLevelsAndLengthsThatDoNotFit) {
    const auto refiner = Refined(TestShapes::SingleTet(), 1);
    const Far::PrimvarRefiner primvars(refiner, Sdc::BoxSpline{});
    std::vector<double> coarse(12), fine(30);
    EXPECT_NO_THROW(primvars.Interpolate<double>(1, coarse, fine, 3));
    EXPECT_THROW(primvars.Interpolate<double>(2, coarse, fine, 3), InvalidInput);
    EXPECT_THROW(primvars.Interpolate<double>(0, coarse, fine, 3), InvalidInput);
    EXPECT_THROW(primvars.Interpolate<double>(1, coarse, fine, 2), InvalidInput);
    coarse.pop_back();
    EXPECT_THROW(primvars.Interpolate<double>(1, coarse, fine, 3), InvalidInput);
}

TEST(ValidateTest, ListsEveryDefectWithTheFatalOnesFirst) {
    const auto codes = [](const std::vector<Far::Defect>& defects) {
        std::vector<Far::DefectCode> c;
        for (const auto& d : defects) c.push_back(d.code);
        return c;
    };
    using enum Far::DefectCode;
    const std::vector<Index> bowtie{0, 1, 2, 3, 0, 4, 5, 6}, bad{0, 1, 2, 2, 0, 1, 2, 77}, face{0, 1, 2};
    EXPECT_EQ(codes(Far::Validate({.n_vertices = 8, .tets = bowtie})),
              (std::vector{NonManifoldVertex, IsolatedVertex}));
    EXPECT_EQ(codes(Far::Validate({.n_vertices = 7, .tets = bowtie, .triangles = face})),
              (std::vector{NonManifoldVertex, CoincidentElement}));
    EXPECT_EQ(codes(Far::Validate({.n_vertices = 4, .tets = bad})), (std::vector{IndexOutOfRange, RepeatedVertex}));
    const auto block = TestShapes::KuhnBlock(2);
    EXPECT_TRUE(Far::Validate(Describe(block)).empty());
    auto inverted = block;
    std::swap(inverted.tets[2], inverted.tets[3]);
    EXPECT_EQ(codes(Far::Validate(Describe(inverted)))[0], InvertedCell);
}

TEST(ValidateTest, ListsAtMostSoManyOfACode) {
    EXPECT_EQ(Far::Validate({.n_vertices = 1000}).size(), 100u);
    EXPECT_EQ(Far::Validate({.n_vertices = 1000}, 7).size(), 7u);
}

}  // namespace
