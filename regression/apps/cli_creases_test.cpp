// SPDX-License-Identifier: Apache-2.0
// `refine` on surfaces with creases and corners, from and to files.
#include <fstream>

#include <solidsubdiv/kit/io/creases.h>
#include <solidsubdiv/kit/io/formats.h>

#include "apps/cli_testing.h"

namespace {

using namespace SolidSubdiv;
using namespace SolidSubdiv::CliTesting;
using testing::HasSubstr;

class CliCreases : public CliTest {
  protected:
    /// A cube of twelve triangles with the given lines of tags.
    void WriteCube(const std::string& name, const std::string& tags) {
        std::ofstream file(folder / name);
        for (int v = 0; v < 8; ++v) file << "v " << v % 2 << " " << v / 2 % 2 << " " << v / 4 << "\n";
        for (const char* face : {"1 4 2", "1 3 4", "5 6 8", "5 8 7", "1 2 6", "1 6 5", "3 8 4", "3 7 8", "1 5 7",
                                 "1 7 3", "2 4 8", "2 8 6"})
            file << "f " << face << "\n";
        file << tags;
    }
    Io::Mesh Read(const std::string& name) { return Io::ReadMesh(folder / name); }
};

TEST_F(CliCreases, WhatIsStillSharpIsWrittenAndRefinesOn) {
    WriteCube("cube.obj",
              "t crease 2/1/0 4 5 2.25\nt crease 2/1/0 5 7 10\nt corner 1/1/0 0 10\nt creasemethod 0/0/1 chaikin\n");
    for (const std::string extension : {".obj", ".vtu", ".vtk", ".msh"}) {
        SCOPED_TRACE(extension);
        MustRun("refine cube.obj -o one" + extension + " --levels 1");
        const Io::Creases creases = Io::CreasesOf(Read("one" + extension));
        EXPECT_EQ(creases.edge_sharpness, (std::vector<float>{1.25f, 1.25f, 10, 10}));
        EXPECT_EQ(creases.vertices, std::vector<Index>{0});
        // Files other than .obj don't say chaikin.
        const std::string chaikin = extension == ".obj" ? "" : " --creasing chaikin";
        MustRun("refine one" + extension + " -o twice.obj --levels 1" + chaikin);
        MustRun("refine cube.obj -o two.obj --levels 2");
        const Io::Mesh twice = Read("twice.obj"), two = Read("two.obj");
        EXPECT_EQ(Io::CreasesOf(twice).edge_sharpness.size(), Io::CreasesOf(two).edge_sharpness.size());
        double sum = 0, sum_of_two = 0;
        for (double x : twice.positions) sum += x * x;
        for (double x : two.positions) sum_of_two += x * x;
        EXPECT_NEAR(sum, sum_of_two, 1e-9);
    }
}

TEST_F(CliCreases, TheCommandLineOutweighsTheFile) {
    WriteCube("cube.obj", "t crease 2/1/0 4 5 2.25\nt creasemethod 0/0/1 chaikin\nt interpolateboundary 1/0/0 1\n");
    const auto setting = [&](const std::string& options) {
        return Json("refine cube.obj -o out.obj " + options)["settings"];
    };
    EXPECT_EQ(setting("")["creasing"], "chaikin");
    EXPECT_EQ(setting("")["features"], "sharp");
    EXPECT_EQ(setting("--creasing uniform")["creasing"], "uniform");
    EXPECT_EQ(setting("--features smooth")["features"], "smooth");
}

TEST_F(CliCreases, FormatsThatCannotCarryThemSaySo) {
    WriteCube("cube.obj", "t crease 2/1/0 4 5 10\nt corner 1/1/0 0 10\n");
    for (const std::string extension : {".stl", ".ply"}) {
        const Outcome outcome = MustRun("refine cube.obj -o out" + extension);
        EXPECT_THAT(outcome.err, HasSubstr("can't carry what is still sharp, left out")) << extension;
        EXPECT_EQ(Read("out" + extension).topology.n_triangles(), 48);
    }
}

TEST_F(CliCreases, SemiSharpOnesAreRefusedByButterflies) {
    WriteCube("cube.obj", "t crease 2/1/0 4 5 2.25\n");
    const Outcome outcome = Run("refine cube.obj -o out.obj --scheme butterfly");
    EXPECT_EQ(outcome.status, 1);
    EXPECT_THAT(outcome.err, HasSubstr("edge (4 5) has the sharpness 2.25"));
    EXPECT_FALSE(std::filesystem::exists(folder / "out.obj"));
}

TEST_F(CliCreases, ABorderCanBeDropped) {
    std::ofstream file(folder / "grid.obj");
    for (int v = 0; v < 16; ++v) file << "v " << v % 4 << " " << v / 4 << " 0\n";
    for (int y = 0; y < 3; ++y) {
        for (int x = 0; x < 3; ++x) {
            const int v = 1 + x + 4 * y;
            file << "f " << v << " " << v + 1 << " " << v + 5 << "\nf " << v << " " << v + 5 << " " << v + 4 << "\n";
        }
    }
    file.close();
    // No triangle but the middle square's two... all others touch the border, and these do at no vertex.
    MustRun("refine grid.obj -o kept.obj --levels 1");
    EXPECT_EQ(Read("kept.obj").topology.n_triangles(), 4 * 18);
    MustRun("refine grid.obj -o dropped.obj --levels 1 --drop-border");
    EXPECT_EQ(Read("dropped.obj").topology.n_triangles(), 4 * 2);
    std::ofstream(folder / "grid.obj", std::ios::app) << "t interpolateboundary 1/0/0 0\n";
    MustRun("refine grid.obj -o dropped.obj --levels 1");
    EXPECT_EQ(Read("dropped.obj").topology.n_triangles(), 4 * 2);
}

TEST_F(CliCreases, InfoCountsThem) {
    WriteCube("cube.obj", "t crease 2/1/0 4 5 2.25\nt corner 1/1/0 0 10\nt crease 2/1/0 0 7 1\n");
    const Outcome outcome = MustRun("info cube.obj");
    EXPECT_THAT(outcome.out, HasSubstr("2 sharp edges, 1 sharp vertex"));
    EXPECT_THAT(outcome.out, HasSubstr("crease without an edge"));
    EXPECT_THAT(outcome.out, testing::Not(HasSubstr("coincident element")));
}

}  // namespace
