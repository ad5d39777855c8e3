// SPDX-License-Identifier: Apache-2.0
// solidsubdiv fit: what is written is what was found, and what can't be fitted is said.
#include <cmath>

#include <solidsubdiv/kit/io/creases.h>

#include "apps/cli_testing.h"
#include "cube_surface.h"
#include "sanitized.h"

namespace SolidSubdiv::CliTesting {
namespace {

using testing::HasSubstr;

/// A ball of radius 10 around (5, 0, 0), of n x 2n quads with poles.
std::string Ball(int n) {
    std::ostringstream text;
    const double pi = 3.14159265358979323846;
    text << "v 5 0 10\n";
    for (int i = 1; i < n; ++i) {
        for (int j = 0; j < 2 * n; ++j) {
            const double t = pi * i / n, p = pi * j / n;
            text << "v " << 5 + 10 * std::sin(t) * std::cos(p) << " " << 10 * std::sin(t) * std::sin(p) << " "
                 << 10 * std::cos(t) << "\n";
        }
    }
    text << "v 5 0 -10\n";
    const auto at = [&](int i, int j) { return 2 + (i - 1) * 2 * n + j % (2 * n); };
    for (int j = 0; j < 2 * n; ++j) {
        text << "f 1 " << at(1, j) << " " << at(1, j + 1) << "\n";
        for (int i = 1; i + 1 < n; ++i) {
            text << "f " << at(i, j) << " " << at(i + 1, j) << " " << at(i + 1, j + 1) << " " << at(i, j + 1) << "\n";
        }
        text << "f " << at(n - 1, j + 1) << " " << at(n - 1, j) << " " << 2 + (n - 1) * 2 * n << "\n";
    }
    return text.str();
}

class CliFit : public CliTest {
  protected:
    void SetUp() override {
        CliTest::SetUp();
        WriteText("ball.obj", Ball(16));
    }
};

TEST_F(CliFit, ASolidIsFoundWhoseLimitIsTheTarget) {
    const auto json = Json("fit ball.obj -o out --control 130 --levels 1 --no-pictures");
    EXPECT_EQ(json["target"]["border_edges"], 0);
    EXPECT_EQ(json["settings"]["model"], "solid");
    EXPECT_EQ(json["settings"]["scheme"], "catmull-clark-solid");
    EXPECT_TRUE(json["control"]["has_target_topology"]);
    // The target's own facets are up to 0.3 % of its diagonal from the ball.
    EXPECT_LT(json["fit"]["surface_to_target"]["rms_percent"], 0.3);
    EXPECT_LT(json["fit"]["target_to_surface"]["rms_percent"], 0.3);
    EXPECT_EQ(json["solid"]["folded"], 0);
    EXPECT_GT(json["solid"]["least_scaled_jacobian"], 0);
    const Io::Mesh lattice = Io::ReadMesh(folder / "out/lattice.vtu");
    EXPECT_EQ(lattice.topology.n_vertices, json["control"]["points"]);
    EXPECT_EQ(lattice.topology.n_hexes(), json["control"]["cells"]);
    const Io::Mesh solid = Io::ReadMesh(folder / "out/solid.vtu");
    EXPECT_EQ(solid.topology.n_hexes(), 8 * lattice.topology.n_hexes());
    const Io::Mesh fitted = Io::ReadMesh(folder / "out/fitted.vtu");
    ASSERT_NE(fitted.FindPointData("distance"), nullptr);
    double largest = 0;
    for (double d : fitted.FindPointData("distance")->values) largest = std::max(largest, d);
    EXPECT_LE(largest, json["fit"]["surface_to_target"]["max"].get<double>() + 1e-12);
    for (std::size_t i = 0; i < fitted.positions.size(); i += 3) {
        const double* p = &fitted.positions[i];
        EXPECT_NEAR(std::hypot(p[0] - 5, p[1], p[2]), 10, 0.5);
    }
    EXPECT_EQ(Io::ReadMesh(folder / "out/fitted.obj").topology.triangles, fitted.topology.triangles);
    EXPECT_THAT(ReadText(folder / "out/fit.json"), HasSubstr("\"hausdorff\""));
}

TEST_F(CliFit, CagesAndTetsDoToo) {
    SOLIDSUBDIV_LONG_TEST();
    for (const char* how : {"--model surface --control 60", "--scheme box-spline --control 120 --levels 1"}) {
        SCOPED_TRACE(how);
        const auto json = Json("fit ball.obj -o out --no-pictures " + std::string(how));
        EXPECT_LT(json["fit"]["surface_to_target"]["rms_percent"], 0.5);
        EXPECT_LT(json["fit"]["target_to_surface"]["rms_percent"], 0.5);
    }
    EXPECT_TRUE(fs::exists(folder / "out/cage.obj"));
}

TEST_F(CliFit, AnyNumberOfThreadsGivesTheSameBytes) {
    SOLIDSUBDIV_LONG_TEST();
    Json("fit ball.obj -o a --model surface --control 60 --threads 1 --no-pictures");
    Json("fit ball.obj -o b --model surface --control 60 --threads 3 --no-pictures");
    EXPECT_EQ(ReadText(folder / "a/cage.obj"), ReadText(folder / "b/cage.obj"));
    EXPECT_EQ(ReadText(folder / "a/fitted.vtu"), ReadText(folder / "b/fitted.vtu"));
}

TEST_F(CliFit, MoreControlPointsAreTakenUntilATolerance) {
    SOLIDSUBDIV_LONG_TEST();
    const auto tried = [&](const std::string& options) {
        return Json("fit ball.obj -o out --model surface --control 12 --no-pictures " + options)["tried"];
    };
    const auto all = tried("--tolerance 0.05");
    ASSERT_GT(all.size(), 1u);
    for (std::size_t i = 0; i < all.size(); ++i) {
        EXPECT_EQ(all[i]["rms"] <= 0.05, i + 1 == all.size()) << i;
        EXPECT_GT(all[i]["control_points"], i == 0 ? 0 : all[i - 1]["control_points"].get<int>());
    }
    EXPECT_EQ(tried("").size(), 1u);
    const auto few = tried("--tolerance 1e-9 --max-control 16");
    EXPECT_EQ(few.size(), 2u);
    EXPECT_LE(few.back()["control_points"], 20);
    EXPECT_THAT(
        Run("fit ball.obj -o out --model surface --control 12 --tolerance 1e-9 --max-control 12 --no-pictures").err,
        HasSubstr("it is not met"));
}

TEST_F(CliFit, SharpEdgesOfPartsBecomeCreases) {
    SOLIDSUBDIV_LONG_TEST();
    WriteText("cube.obj", CubeObj(8));
    const auto with = Json("fit cube.obj -o with --model surface --control 50 --no-pictures");
    const auto without = Json("fit cube.obj -o without --model surface --control 50 --creases 0 --no-pictures");
    EXPECT_GE(with["control"]["creases"], 12);
    EXPECT_EQ(without["control"]["creases"], 0);
    for (const char* way : {"surface_to_target", "target_to_surface"}) {
        EXPECT_LT(with["fit"][way]["max_percent"], 1) << way;
        EXPECT_GT(without["fit"][way]["rms_percent"], 10 * with["fit"][way]["rms_percent"].get<double>()) << way;
    }
    const Io::Creases creases = Io::CreasesOf(Io::ReadMesh(folder / "with/cage.obj"));
    EXPECT_EQ(creases.edge_sharpness.size(), with["control"]["creases"]);
}

TEST_F(CliFit, SolidsWithSharpEdgesAreOfTetsWithCreases) {
    SOLIDSUBDIV_LONG_TEST();
    WriteText("cube.obj", CubeObj(8));
    const auto json = Json("fit cube.obj -o out --control 120 --no-pictures");
    EXPECT_EQ(json["settings"]["scheme"], "box-spline");
    EXPECT_GE(json["control"]["creases"], 12);
    EXPECT_EQ(json["solid"]["folded"], 0);
    for (const char* way : {"surface_to_target", "target_to_surface"}) {
        EXPECT_LT(json["fit"][way]["max_percent"], 0.5) << way;
    }
    const Io::Mesh lattice = Io::ReadMesh(folder / "out/lattice.vtu");
    EXPECT_GT(lattice.topology.n_tets(), 0);
    EXPECT_EQ(Io::CreasesOf(lattice).edge_sharpness.size(), json["control"]["creases"]);
    // Refined again, with the diagonals of the fit, it is the same solid.
    MustRun("refine out/lattice.vtu -o again.vtu --scheme box-spline --diagonals first --levels 3 --limit");
    const Io::Mesh again = Io::ReadMesh(folder / "again.vtu"), solid = Io::ReadMesh(folder / "out/solid.vtu");
    ASSERT_EQ(again.positions.size(), solid.positions.size());
    for (std::size_t i = 0; i < solid.positions.size(); ++i) {
        ASSERT_NEAR(again.positions[i], solid.positions[i], 1e-9) << i;
    }
    // Hexahedra where they are asked for, with a word, and none where creases are asked for as well.
    const std::string hexes = "fit cube.obj -o hexes --scheme catmull-clark-solid --control 60 --no-pictures";
    EXPECT_THAT(MustRun(hexes).err, HasSubstr("hexahedra round them off"));
    const Outcome refused = Run(hexes + " --creases 40");
    EXPECT_EQ(refused.status, 2);
    EXPECT_THAT(refused.err, HasSubstr("--creases is for cages and lattices of tets"));
}

TEST_F(CliFit, OpenTargetsGetACageWithAWord_OrASolidWhereAsked) {
    SOLIDSUBDIV_LONG_TEST();
    // Without the faces around one pole.
    std::istringstream ball(Ball(16));
    std::string open, line;
    while (std::getline(ball, line)) open += line.starts_with("f 1 ") ? "" : line + "\n";
    WriteText("open.obj", open);
    const Outcome outcome = MustRun("fit open.obj -o out --control 60 --no-pictures");
    EXPECT_THAT(outcome.err, HasSubstr("32 border edges"));
    EXPECT_TRUE(fs::exists(folder / "out/cage.obj"));
    // A solid, where it is asked for: the hole is bridged.
    const auto json = Json("fit open.obj -o solid --model solid --control 100 --levels 1 --no-pictures");
    EXPECT_EQ(json["solid"]["folded"], 0);
    EXPECT_GT(json["target"]["closing_radius"], 0);
    EXPECT_GT(json["fit"]["surface_to_target"]["left_out_percent"], 0);
    EXPECT_LT(json["fit"]["surface_to_target"]["rms_percent"], 1);
    EXPECT_LT(json["fit"]["target_to_surface"]["rms_percent"], 1);
    WriteText("sheet.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n");
    EXPECT_THAT(ErrorOf("fit sheet.obj -o out2 --model solid --control 30"), HasSubstr("open: 4 border edges"));
    EXPECT_FALSE(fs::exists(folder / "out2"));
}

TEST_F(CliFit, TargetsThatLookInwardsAreTurned_OpenOnesLookWhereTheyLook) {
    std::istringstream ball(Ball(8));
    std::string turned, line;
    while (std::getline(ball, line)) {
        if (!line.starts_with("f ")) {
            turned += line + "\n";
            continue;
        }
        std::istringstream words(line.substr(2));
        std::string face, word;
        while (words >> word) face = " " + word + face;
        turned += "f" + face + "\n";
    }
    WriteText("turned.obj", turned);
    const Outcome outcome = MustRun("fit turned.obj -o out --model surface --control 40 --no-pictures");
    EXPECT_THAT(outcome.err, HasSubstr("look inwards"));
    // Four quads that rise from the origin: with it they enclose less than nothing.
    WriteText("open.obj",
              "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 .5\nv 2 1 .5\nv 0 2 0\nv 1 2 0\nv 2 2 1\n"
              "f 1 2 3 4\nf 2 5 6 3\nf 4 3 8 7\nf 3 6 9 8\n");
    MustRun("fit open.obj -o out --control 8 --no-pictures");
}

TEST_F(CliFit, BadTargetsAndOptionsAreNamedAndLeaveNothing) {
    WriteText("points.obj", "v 0 0 0\nv 1 0 0\n");
    WriteText("nan.obj", "v 0 0 nan\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    WriteText("file", "a file");
    const auto error = [&](const std::string& arguments) {
        const std::string text = ErrorOf("fit " + arguments + " --no-pictures");
        EXPECT_FALSE(fs::exists(folder / "out")) << arguments;
        return text;
    };
    EXPECT_THAT(error("points.obj -o out"), HasSubstr("points.obj: has no faces"));
    EXPECT_THAT(error("nan.obj -o out"), HasSubstr("nan.obj"));
    EXPECT_THAT(error("missing.obj -o out"), HasSubstr("missing.obj"));
    EXPECT_THAT(error("ball.obj -o file"), HasSubstr("file: is no folder"));
    EXPECT_THAT(error("ball.obj -o no/such/folder"), HasSubstr("no/such/folder"));
    EXPECT_EQ(Run("fit ball.obj -o out --model shell").status, 2);
    EXPECT_EQ(Run("fit ball.obj -o out --control 3").status, 2);
    EXPECT_EQ(Run("fit ball.obj -o out --scheme nonsense").status, 2);
    EXPECT_EQ(Run("fit ball.obj").status, 2);
    EXPECT_FALSE(fs::exists(folder / "out"));
}

TEST_F(CliFit, PicturesAreWritten) {
    SOLIDSUBDIV_LONG_TEST();
    if (MustRun("fit --help").out.find("--no-pictures") == std::string::npos) GTEST_SKIP() << "built without pictures";
    MustRun("fit ball.obj -o out --model surface --control 40 --iterations 3");
    EXPECT_THAT(ReadText(folder / "out/fit.png"), testing::StartsWith("\x89PNG"));
    EXPECT_THAT(ReadText(folder / "out/convergence.svg"), HasSubstr("</svg>"));
    const std::string page = ReadText(folder / "out/report.html");
    for (const char* words : {"fit of ball.obj", "distance from the target", "limit to target, rms", "</html>"}) {
        EXPECT_THAT(page, HasSubstr(words));
    }
}

}  // namespace
}  // namespace SolidSubdiv::CliTesting
