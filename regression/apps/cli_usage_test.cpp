// SPDX-License-Identifier: Apache-2.0
// The program's manners: exit status, help whose examples run, errors of one line, nothing half-written.
#include <cmath>
#include <regex>
#include <set>

#include "apps/cli_testing.h"
#include "cube_surface.h"
#include "sanitized.h"

namespace SolidSubdiv::CliTesting {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

class CliUsage : public CliTest {
  protected:
    void SetUp() override {
        CliTest::SetUp();
        WriteMesh("lattice.vtu", TwentyEightTets());
    }

    /// Fails with `status` and one line that has all `parts`; the folder is as before.
    void ExpectError(const std::string& arguments, int status, const std::vector<std::string>& parts) const {
        const std::set<std::string> before = Names();
        const Outcome outcome = Run(arguments);
        EXPECT_EQ(outcome.status, status) << arguments << "\n" << outcome.err;
        EXPECT_THAT(outcome.err, StartsWith("solidsubdiv: error: ")) << arguments;
        EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << arguments << "\n" << outcome.err;
        EXPECT_THAT(outcome.err, testing::EndsWith("\n"));
        for (const std::string& part : parts) EXPECT_THAT(outcome.err, HasSubstr(part)) << arguments;
        EXPECT_THAT(outcome.err, testing::Not(HasSubstr(".solidsubdiv-"))) << "a hidden name was said";
        EXPECT_THAT(outcome.out, IsEmpty()) << arguments;
        EXPECT_EQ(Names(), before) << arguments;
    }

    /// Names of the sub-commands, from the help.
    std::vector<std::string> Commands() const {
        std::istringstream help(MustRun("--help").out);
        std::vector<std::string> commands;
        bool is_list = false;
        for (std::string line; std::getline(help, line);) {
            if (is_list && line.empty()) break;
            if (is_list) commands.push_back(line.substr(2, line.find(' ', 2) - 2));
            is_list = is_list || line == "Commands:";
        }
        return commands;
    }
};

TEST_F(CliUsage, HelpListsInfoAndRefine) { EXPECT_THAT(Commands(), testing::IsSupersetOf({"info", "refine"})); }

TEST_F(CliUsage, EveryHelpHasAnExampleAndEveryExampleRuns) {
    SOLIDSUBDIV_LONG_TEST();
    std::vector<std::string> commands = Commands();
    commands.insert(commands.begin(), "");
    MustRun("sample lattice.vtu -o bunny.obj --rate 2");
    WriteText("ears.txt", "0 0.1 0.2 0.1\n");
    fs::copy_file(fs::path(SOLIDSUBDIV_SHAPES) / "volumes" / "caudate_labels.nii.gz", folder / "labels.nii.gz");
    std::ostringstream scan;
    for (int i = 0; i < 800; ++i) {  // along a spiral around a ball
        const double z = (i + 0.5) / 400 - 1, r = std::sqrt(1 - z * z);
        scan << r * std::cos(2.4 * i) << " " << r * std::sin(2.4 * i) << " " << z << "\n";
    }
    WriteText("scan.xyz", scan.str());
    WriteText("part.obj", CubeObj(8));
    for (const std::string moved : {"moved", "walk1", "walk2", "walk3"}) {
        MustRun("lattice bunny.obj -o " + moved + ".vtu --levels 1");
    }
    if (std::count(commands.begin(), commands.end(), "voxelize") > 0) {
        MustRun("voxelize lattice.vtu -o solid.vdb --kind fog --resolution 16");
    }
    for (const std::string& command : commands) {
        std::istringstream help(MustRun(command + " --help").out);
        int n_examples = 0;
        for (std::string line; std::getline(help, line);) {
            if (!line.starts_with("  solidsubdiv ")) continue;
            const Outcome outcome = MustRun(line.substr(14));
            EXPECT_THAT(outcome.err, IsEmpty()) << line;
            ++n_examples;
        }
        EXPECT_GE(n_examples, 1) << command;
    }
}

TEST_F(CliUsage, EveryChoiceThatTheHelpOffersWorks) {
    MustRun("refine lattice.vtu -o given.vtu --levels 0 --boundary surface.obj");
    const std::string help = MustRun("refine --help").out;
    const std::regex pattern("  (--[a-z-]+) ([a-z0-9-]+(\\|[a-z0-9-]+)+)");
    int n_choices = 0;
    for (std::sregex_iterator it(help.begin(), help.end(), pattern), end; it != end; ++it) {
        std::istringstream choices((*it)[2].str());
        for (std::string choice; std::getline(choices, choice, '|'); ++n_choices) {
            std::string option = (*it)[1].str() + " " + choice;
            const std::set<std::string> surface_schemes{"loop", "butterfly", "modified-butterfly", "catmull-clark",
                                                        "linear-surface"};
            const std::string name = (*it)[1].str();
            const bool is_surface = (name == "--scheme" && surface_schemes.count(choice) > 0) || name == "--features" ||
                                    name == "--creasing" || name == "--triangles";
            if (name == "--butterfly" || name == "--two-neighbors") option += " --scheme interpolatory";
            if (name == "--surface") option += " --scheme mlca";
            if (name == "--triangles") option += " --scheme catmull-clark";
            MustRun("refine " + std::string(is_surface ? "surface.obj" : "given.vtu") + " -o out.vtu " + option);
        }
    }
    EXPECT_GE(n_choices, 15);
}

// validate and bench are programs of their own beside this one.
TEST_F(CliUsage, ProgramsThatAreNotThereAreSaidAndNotListed) {
    fs::copy_file(Program(), folder / "solidsubdiv");
    const auto run = [&](const std::string& arguments) {
        const int status =
            std::system(("cd '" + folder.string() + "' && ./solidsubdiv " + arguments + " >out 2>err").c_str());
        return Outcome{WIFEXITED(status) ? WEXITSTATUS(status) : -1, ReadText(folder / "out"),
                       ReadText(folder / "err")};
    };
    for (const std::string name : {"validate", "bench"}) {
        const Outcome outcome = run(name + " --help");
        EXPECT_EQ(outcome.status, 1);
        EXPECT_THAT(outcome.err, StartsWith("solidsubdiv: error: "));
        EXPECT_THAT(outcome.err, HasSubstr("solidsubdiv-" + name + ": No such file"));
        EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1);
        EXPECT_THAT(run("--help").out, testing::Not(HasSubstr(name)));
    }
}

TEST_F(CliUsage, AnalyzeTakesOnePlace) {
    EXPECT_THAT(MustRun("analyze --regular --scheme catmull-clark").out, HasSubstr("1, 1/2 x 2, 1/4 x 3"));
    const std::string edges = MustRun("analyze --edge 3..5 --scheme mlca --json -").out;
    for (const char* part : {"\"cells\": 3", "\"cells\": 5", "C1 uneven"}) EXPECT_THAT(edges, HasSubstr(part));
    ExpectError("analyze --scheme mlca", 2, {"--regular or --edge"});
    ExpectError("analyze --regular --edge 3 --scheme mlca", 2, {"--regular or --edge"});
    for (const char* range : {"2", "33", "3..", "..3", "3...4", "x", "3..40"}) {
        ExpectError(std::string("analyze --scheme mlca --edge ") + range, 2, {"from 3 to 32"});
    }
    ExpectError("analyze --scheme mlca --edge 5..4", 2, {"starts above its end"});
    ExpectError("analyze --scheme loop --edge 4", 2, {"loop is one of surfaces"});
}

TEST_F(CliUsage, VersionIsSaid) {
    const Outcome outcome = MustRun("--version");
    EXPECT_TRUE(std::regex_match(outcome.out, std::regex("solidsubdiv [0-9]+\\.[0-9]+\\.[0-9]+\n"))) << outcome.out;
}

TEST_F(CliUsage, BadUsageIsStatusTwo) {
    ExpectError("", 2, {"--help"});
    ExpectError("frobnicate", 2, {"frobnicate", "--help"});
    ExpectError("info", 2, {"FILE", "solidsubdiv info --help"});
    ExpectError("info lattice.vtu --colour", 2, {"--colour"});
    ExpectError("info lattice.vtu --threads 0", 2, {"--threads", "0"});
    ExpectError("info lattice.vtu --threads many", 2, {"--threads", "many"});
    ExpectError("refine lattice.vtu", 2, {"--output"});
    ExpectError("refine lattice.vtu -o out.vtu --levels 21", 2, {"--levels", "21"});
    ExpectError("refine lattice.vtu -o out.vtu --levels -1", 2, {"--levels", "-1"});
    ExpectError("refine lattice.vtu -o out.vtu --scheme spline", 2, {"spline", "box-spline"});
    ExpectError("refine lattice.vtu -o out.vtu --diagonals longest", 2, {"--diagonals", "longest", "shortest"});
    ExpectError("refine lattice.vtu -o out.vtu --orient up", 2, {"--orient", "up", "refuse"});
    ExpectError("refine lattice.vtu -o out.vtu --loop-weights heavy", 2, {"loop-weights", "heavy", "warren"});
    ExpectError("refine lattice.vtu -o out.vtu --scheme linear-solid --loop-weights warren", 2,
                {"linear-solid", "loop-weights"});
    ExpectError("refine lattice.vtu -o out.vtu --scheme linear-solid --diagonals averaged", 2,
                {"linear-solid", "diagonals"});
    ExpectError("refine lattice.vtu -o out.vtu --diagonals averaged --edge-rule printed-2002", 2, {"averaged"});
    ExpectError("refine lattice.vtu -o out.xyzzy", 2, {"out.xyzzy", ".vtu"});
    ExpectError("refine lattice.vtu -o out.vtu --boundary out.vtu", 2, {"out.vtu", "two outputs"});
    ExpectError("refine lattice.vtu -o out.vtu --json ./out.vtu", 2, {"out.vtu", "two outputs"});
    ExpectError("refine lattice.vtu -o out.vtu --boundary out.node", 2, {"out.node"});
    ExpectError("refine lattice.vtu -o out.vtu --limit --stencils out.mtx", 2, {"--stencils", "--limit"});
}

TEST_F(CliUsage, FilesThatCannotBeReadAreNamed) {
    fs::create_directory(folder / "folder.vtu");
    WriteText("empty.vtu", "");
    WriteText("mesh.xyzzy", "1");
    WriteText("garbage.vtu", "\x01\x02 no mesh");
    const std::string vtk = ReadText(folder / "lattice.vtu");
    WriteText("half.vtu", vtk.substr(0, vtk.size() / 2));
    WriteText("range.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n");
    WriteText("nan.obj", "v 0 0 0\nv 1 nan 0\nv 0 1 0\nf 1 2 3\n");
    for (const std::string file :
         {"missing.vtu", "folder.vtu", "empty.vtu", "mesh.xyzzy", "garbage.vtu", "half.vtu", "range.obj", "nan.obj"}) {
        ExpectError("info " + file, 1, {file + ": "});
        ExpectError("info " + file + " --json out.json", 1, {file + ": "});
        ExpectError("refine " + file + " -o out.vtu --boundary out.obj", 1, {file + ": "});
    }
}

TEST_F(CliUsage, MeshesThatCannotBeRefinedAreNamedWithTheElement) {
    Io::Mesh mesh = OneTet();
    mesh.topology.tets = {0, 1, 2, 3, 0, 2, 1, 3};
    WriteMesh("twice.vtu", mesh);
    ExpectError("refine twice.vtu -o out.vtu", 1, {"twice.vtu: ", "tet 1", "tet 0"});

    mesh = TetMesh({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 2, 0, 0, 3}, {0, 1, 2, 3, 0, 1, 2, 4, 0, 1, 2, 5});
    WriteMesh("three.vtu", mesh);
    ExpectError("refine three.vtu -o out.vtu", 1, {"three.vtu: ", "(0 1 2)", "more than two cells"});

    mesh = OneTet();
    mesh.topology.tets = {0, 1, 2, 2};
    WriteMesh("repeated.vtu", mesh);
    ExpectError("refine repeated.vtu -o out.vtu", 1, {"repeated.vtu: ", "tet 0", "vertex 2 twice"});

    mesh = OneTet();
    mesh.topology.tets = {0, 1, 3, 2};
    WriteMesh("inverted.vtu", mesh);
    ExpectError("refine inverted.vtu -o out.vtu --orient refuse", 1, {"inverted.vtu: ", "tet 0", "-0.166667"});

    Io::Mesh hex;
    hex.topology.n_vertices = 8;
    hex.positions = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1};
    hex.topology.hexes = {0, 1, 2, 3, 4, 5, 6, 7};
    WriteMesh("hex.vtu", hex);
    ExpectError("refine hex.vtu -o out.vtu --scheme box-spline", 1, {"hex.vtu: ", "1 hexahedron"});
    WriteText("quad.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n");
    ExpectError("refine quad.obj -o out.obj --scheme loop", 1, {"quad.obj: ", "1 quad"});

    hex.topology.hexes = {4, 5, 6, 7, 0, 1, 2, 3};
    WriteMesh("turned.vtu", hex);
    ExpectError("refine turned.vtu -o out.vtu --orient refuse", 1, {"turned.vtu: ", "hexahedron 0 is inverted", "-1;"});
    hex.topology.hexes.insert(hex.topology.hexes.end(), {7, 6, 5, 4, 3, 2, 1, 0});
    WriteMesh("twice.vtu", hex);
    ExpectError("refine twice.vtu -o out.vtu", 1, {"twice.vtu: ", "hexahedron 1 has the same vertices"});
}

TEST_F(CliUsage, WhatDoesNotFitIsRefusedWithItsSize) {
    ExpectError("refine lattice.vtu -o out.vtu --levels 20", 1, {"lattice.vtu: ", "level", "bytes", "fewer"});
}

TEST_F(CliUsage, SchemesAndDataThatDoNotGoTogetherAreSaid) {
    ExpectError("refine lattice.vtu -o out.vtu --scheme loop", 1, {"lattice.vtu: ", "loop", "28 tetrahedra"});
    ExpectError("refine lattice.vtu -o out.vtu --diagonals given", 1, {"lattice.vtu: ", "'diagonal'"});
    Io::Mesh mesh = OneTet();
    mesh.cell_data.push_back({"diagonal", 1, {7}});
    WriteMesh("seven.vtu", mesh);
    ExpectError("refine seven.vtu -o out.vtu --diagonals given", 1, {"seven.vtu: ", "cell 0", "7"});
}

TEST_F(CliUsage, OutputsThatCannotBeWrittenAreFoundOutBeforeTheWork) {
    fs::create_directory(folder / "folder.vtu");
    WriteText("curve.obj", "v 0 0 0\nv 1 0 0\nl 1 2\n");
    ExpectError("refine lattice.vtu -o nowhere/out.vtu", 1, {"nowhere/out.vtu: ", "no folder nowhere"});
    ExpectError("refine lattice.vtu -o out.vtu --json nowhere/out.json", 1, {"nowhere/out.json: "});
    ExpectError("refine lattice.vtu -o out.vtu --stencils nowhere/out.mtx", 1, {"nowhere/out.mtx: "});
    ExpectError("refine lattice.vtu -o folder.vtu", 1, {"folder.vtu: ", "directory"});
    ExpectError("refine lattice.vtu -o out.obj", 1, {"out.obj: ", "cells", "--boundary"});
    ExpectError("refine curve.obj -o out.vtu --boundary out.obj", 1, {"curve.obj: ", "--boundary"});
    ExpectError("refine lattice.vtu -o out.vtu --boundary /dev/null.obj/x.obj", 1, {"/dev/null.obj/x.obj: "});
    ExpectError("info lattice.vtu --json /dev/null", 1, {"/dev/null: ", "regular"});
}

TEST_F(CliUsage, AFailureLeavesAnOlderOutputAsItWas) {
    WriteText("out.vtu", "older");
    ExpectError("refine lattice.vtu -o out.vtu --levels 20", 1, {"lattice.vtu"});
    EXPECT_EQ(ReadText(folder / "out.vtu"), "older");
    MustRun("refine lattice.vtu -o out.vtu");
    EXPECT_EQ(ReadMesh("out.vtu").topology.n_tets(), 4 * 28 + 4 * 28);
}

TEST_F(CliUsage, OutputsHaveNoCompanionsLeft) {
    MustRun("refine lattice.vtu -o out.vtu --boundary out.obj --stencils out.mtx --json out.json");
    EXPECT_THAT(Names(), testing::ElementsAre("lattice.vtu", "out.json", "out.mtx", "out.obj", "out.vtu"));
}

TEST_F(CliUsage, FormatsOfTwoFilesComeWhole) {
    MustRun("refine lattice.vtu -o out.node --levels 1");
    EXPECT_THAT(Names(), testing::ElementsAre("lattice.vtu", "out.ele", "out.node"));
    EXPECT_EQ(ReadMesh("out.node").topology.n_tets(), 8 * 28);
}

TEST_F(CliUsage, ALinkKeepsPointingToTheFileThatIsWritten) {
    WriteText("real.vtu", "older");
    fs::create_symlink("real.vtu", folder / "link.vtu");
    MustRun("refine lattice.vtu -o link.vtu");
    EXPECT_TRUE(fs::is_symlink(folder / "link.vtu"));
    EXPECT_EQ(ReadMesh("real.vtu").topology.n_tets(), 8 * 28);
}

TEST_F(CliUsage, QuietSaysNothingAndJsonTakesStandardOutput) {
    const Outcome quiet = MustRun("refine lattice.vtu -o out.vtu --quiet");
    EXPECT_THAT(quiet.out, IsEmpty());
    EXPECT_THAT(quiet.err, IsEmpty());
    for (const std::string command : {"info lattice.vtu", "refine lattice.vtu -o out.vtu"}) {
        const auto json = nlohmann::json::parse(MustRun(command + " --json -").out, nullptr, false);
        EXPECT_TRUE(json.is_object()) << command;
        MustRun(command + " --json file.json");
        EXPECT_TRUE(nlohmann::json::parse(ReadText(folder / "file.json"), nullptr, false).is_object()) << command;
    }
}

TEST_F(CliUsage, InterruptedWorkLeavesNothing) {
    const pid_t child = fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
        const std::string err = (folder / "err").string();
        if (chdir(folder.c_str()) != 0 || !freopen(err.c_str(), "w", stderr)) _exit(99);
        execl(Program().c_str(), "solidsubdiv", "refine", "lattice.vtu", "-o", "out.vtu", "--levels", "5", "--quiet",
              nullptr);
        _exit(98);
    }
    // The hidden folder shows that it is at work; from there it takes hundreds of milliseconds.
    bool is_at_work = false;
    for (int i = 0; i < 2000 && !is_at_work; ++i) {
        usleep(5000);
        for (const std::string& name : Names()) is_at_work |= name.starts_with(".solidsubdiv-");
    }
    ASSERT_TRUE(is_at_work);
    kill(child, SIGINT);
    int status = 0;
    ASSERT_EQ(waitpid(child, &status, 0), child);
    EXPECT_TRUE(WIFEXITED(status));
    EXPECT_EQ(WEXITSTATUS(status), 1);
    EXPECT_EQ(ReadText(folder / "err"), "solidsubdiv: error: cancelled; no file was written\n");
    EXPECT_THAT(Names(), testing::ElementsAre("err", "lattice.vtu"));
}

}  // namespace
}  // namespace SolidSubdiv::CliTesting
