// SPDX-License-Identifier: Apache-2.0
// What info says of the quality of cells, the map and the picture that it writes.
#include "apps/cli_testing.h"

namespace SolidSubdiv::CliTesting {
namespace {

using testing::HasSubstr;

using CliQuality = CliTest;

/// Determinants at the corners are 40 to 235; between them they fall to -11.5 and below.
Io::Mesh FoldedBetweenCorners() {
    Io::Mesh mesh;
    mesh.topology.n_vertices = 8;
    mesh.positions = {-2, 2, 0, 5, 1, -3, 7, 6, 3, 3, 2, 0, 2, 0, 2, 4, -1, 1, 5, 2, 4, 2, 7, 1};
    mesh.topology.hexes = {0, 1, 2, 3, 4, 5, 6, 7};
    return mesh;
}

/// A unit cube (of the quality 1) and, apart from it, a corner tet (of sqrt(1/2)), an inverted one and a flat one.
Io::Mesh CubeAndTets() {
    Io::Mesh mesh;
    mesh.positions = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1};
    for (double x : {3, 5, 7}) mesh.positions.insert(mesh.positions.end(), {x, 0, 0, x + 1, 0, 0, x, 1, 0, x, 0, 1});
    mesh.positions[3 * 19 + 2] = 0;
    mesh.topology.n_vertices = 20;
    mesh.topology.hexes = {0, 1, 2, 3, 4, 5, 6, 7};
    mesh.topology.tets = {8, 9, 10, 11, 12, 13, 15, 14, 16, 17, 18, 19};
    mesh.topology.triangles = {0, 1, 9};  // no cell: not in the map
    mesh.cell_data.push_back({"mark", 1, {10, 11, 12, 13, 14}});
    return mesh;
}

TEST_F(CliQuality, TellsHowManyCellsAreFoldedWhichAndWhere) {
    WriteMesh("mixed.vtu", CubeAndTets());
    const auto quality = Json("info mixed.vtu --quality")["quality"];
    EXPECT_EQ(quality["cells"], 4);
    EXPECT_EQ(quality["positive"], 2);
    EXPECT_EQ(quality["folded"], 1);
    EXPECT_EQ(quality["undecided"], 1);
    EXPECT_EQ(quality["least_jacobian"]["kind"], "tetrahedron");
    EXPECT_EQ(quality["least_jacobian"]["number"], 1);
    EXPECT_DOUBLE_EQ(quality["least_jacobian"]["jacobian_minimum"].get<double>(), -1);
    EXPECT_DOUBLE_EQ(quality["scaled_jacobian"]["greatest"].get<double>(), 1);
    EXPECT_EQ(quality["scaled_jacobian"]["below_zero"], 1);
    EXPECT_EQ(quality["scaled_jacobian"]["tenths"], nlohmann::json::array({1, 0, 0, 0, 0, 0, 0, 1, 0, 1}));
    ASSERT_EQ(quality["worst"].size(), 4u);
    EXPECT_EQ(quality["worst"][3]["kind"], "hexahedron");
    const std::string text = MustRun("info mixed.vtu --quality").out;
    EXPECT_THAT(text, HasSubstr("proved positive in 2 of 4, negative in 1 cell (folded or inverted), undecided in 1"));
    EXPECT_THAT(text, HasSubstr("the least: tetrahedron 1: scaled Jacobian -0.707107, least Jacobian -1"));
    EXPECT_THAT(MustRun("info mixed.vtu").out, testing::Not(HasSubstr("Jacobian")));
}

TEST_F(CliQuality, FindsAFoldThatTheCornersDoNotShow) {
    WriteMesh("folded.vtu", FoldedBetweenCorners());
    const auto quality = Json("info folded.vtu --quality")["quality"];
    EXPECT_EQ(quality["folded"], 1);
    EXPECT_LE(quality["least_jacobian"]["jacobian_minimum"].get<double>(), -11.5);
    const auto at = quality["least_jacobian"]["at"].get<std::vector<double>>();
    EXPECT_TRUE(std::any_of(at.begin(), at.end(), [](double x) { return x > 0 && x < 1; })) << "not at a corner";
}

TEST_F(CliQuality, TheMapCarriesTheNumbersInTheOrderOfTheCells) {
    WriteMesh("mixed.vtu", CubeAndTets());
    MustRun("info mixed.vtu --quality-map map.vtu");
    const Io::Mesh map = ReadMesh("map.vtu");
    EXPECT_EQ(map.topology.n_elements(), 4);
    ASSERT_NE(map.FindCellData("jacobian_minimum"), nullptr);
    ASSERT_NE(map.FindCellData("scaled_jacobian"), nullptr);
    ASSERT_NE(map.FindCellData("mark"), nullptr);
    EXPECT_EQ(map.FindCellData("mark")->values, (std::vector<double>{10, 11, 12, 13}));
    EXPECT_EQ(map.FindCellData("jacobian_minimum")->values, (std::vector<double>{1, -1, 0, 1}));
    const auto& scaled = map.FindCellData("scaled_jacobian")->values;
    EXPECT_DOUBLE_EQ(scaled[0], std::sqrt(0.5));
    EXPECT_DOUBLE_EQ(scaled[3], 1);
    EXPECT_EQ(Names(), (std::set<std::string>{"mixed.vtu", "map.vtu"}));
}

TEST_F(CliQuality, ThePictureIsNotEmpty) {
    if (MustRun("info --help").out.find("--picture") == std::string::npos) {
        GTEST_SKIP() << "built without pictures (no Embree or libpng)";
    }
    WriteMesh("lattice.vtu", TwentyEightTets());
    MustRun("info lattice.vtu --picture quality.png");
    EXPECT_GT(fs::file_size(folder / "quality.png"), 50000u) << "an empty picture is much smaller";
}

TEST_F(CliQuality, OfAMeshWithFatalDefectsTheRestIsStillSaid) {
    WriteMesh("twice.vtu", TetMesh({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}, {0, 1, 2, 3, 0, 1, 2, 3}));
    const Outcome outcome = MustRun("info twice.vtu --quality");
    EXPECT_THAT(outcome.out, HasSubstr("duplicate element (fatal): 1"));
    EXPECT_THAT(outcome.err, HasSubstr("twice.vtu: quality is not measured while there are fatal defects"));
    EXPECT_EQ(Run("info twice.vtu --quality-map map.vtu").status, 1);
}

TEST_F(CliQuality, WhatCannotBeMeasuredOrWrittenIsSaidInOneLine) {
    Io::Mesh surface;
    surface.topology.n_vertices = 3;
    surface.positions = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    surface.topology.triangles = {0, 1, 2};
    WriteMesh("surface.vtu", surface);
    Outcome outcome = Run("info surface.vtu --quality --quality-map map.vtu");
    EXPECT_EQ(outcome.status, 1);
    EXPECT_EQ(outcome.err, "solidsubdiv: error: surface.vtu: has no cells whose quality could be measured\n");
    EXPECT_EQ(Names(), (std::set<std::string>{"surface.vtu"}));
    outcome = Run("info surface.vtu --quality-map map.obj");
    EXPECT_EQ(outcome.status, 2);
    EXPECT_THAT(outcome.err, HasSubstr("map.obj"));
}

}  // namespace
}  // namespace SolidSubdiv::CliTesting
