// SPDX-License-Identifier: Apache-2.0
// solidsubdiv analyze: places made to order and places of files, as a person and a program read them.
#include "apps/cli_testing.h"

namespace {

using namespace SolidSubdiv;
using namespace SolidSubdiv::CliTesting;
using testing::HasSubstr;

class CliAnalyze : public CliTest {
  protected:
    void ExpectError(const std::string& arguments, int status, const std::string& part) const {
        const Outcome outcome = Run(arguments);
        EXPECT_EQ(outcome.status, status) << arguments;
        EXPECT_THAT(outcome.err, testing::StartsWith("solidsubdiv: error: ")) << arguments;
        EXPECT_THAT(outcome.err, HasSubstr(part)) << arguments;
        EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    }

    /// n tets around an edge, with positions on a circle.
    void WriteTetsAroundEdge(const std::string& name, int n) const {
        std::vector<double> positions{0, 0, -1, 0, 0, 1};
        std::vector<Index> tets;
        for (int i = 0; i < n; ++i) {
            const double angle = 2 * 3.14159265358979 * i / n;
            positions.insert(positions.end(), {std::cos(angle), std::sin(angle), 0});
            tets.insert(tets.end(), {0, 1, 2 + i, 2 + (i + 1) % n});
        }
        WriteMesh(name, TetMesh(std::move(positions), std::move(tets)));
    }
};

/// The kinds of one group.
std::vector<nlohmann::json> Group(const nlohmann::json& result, const std::string& group) {
    std::vector<nlohmann::json> kinds;
    for (const auto& kind : result["kinds"]) {
        if (kind["group"] == group) kinds.push_back(kind);
    }
    return kinds;
}

TEST_F(CliAnalyze, FindsTheEdgeOfAFile) {
    for (int n : {3, 5}) {
        WriteTetsAroundEdge("edge.vtu", n);
        const auto result = Json("analyze edge.vtu --scheme box-spline --diagonals first");
        const auto edges = Group(result, "edges inside");
        ASSERT_EQ(edges.size(), 1u);
        EXPECT_EQ(edges[0]["count"], 1);
        EXPECT_EQ(edges[0]["example"], "edge 0 1");
        EXPECT_EQ(edges[0]["place"], std::to_string(n) + " tets, B edge of " + std::to_string(n));
        EXPECT_EQ(edges[0]["smoothness"], "C1 uneven");
        // docs/schemes/README.md: .410 and .550 across, 1/2 along.
        const double across = edges[0]["eigenvalues"][n == 3 ? 2 : 1]["real"];
        EXPECT_NEAR(across, n == 3 ? 0.410 : 0.550, 5e-4);
        EXPECT_GT(edges[0]["characteristic_map"]["ratio"], 0);
    }
}

TEST_F(CliAnalyze, TellsMatchedFacesFromOthers) {
    const std::string text = MustRun("analyze --face --scheme interpolatory").out;
    EXPECT_THAT(text, HasSubstr("matched    C1  "));
    EXPECT_THAT(text, HasSubstr("unmatched  C0  "));
    EXPECT_THAT(text, HasSubstr("0.6983"));
    // The same through a file: the second tet's pair by the data 'diagonal'.
    Io::Mesh mesh = TetMesh({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, -1}, {0, 1, 2, 3, 1, 0, 2, 4});
    for (int diagonal : {0, 1}) {
        mesh.cell_data = {{"diagonal", 1, {0, static_cast<double>(diagonal)}}};
        WriteMesh("two.vtu", mesh);
        const auto faces = Group(Json("analyze two.vtu --scheme interpolatory --diagonals given"), "faces inside");
        ASSERT_EQ(faces.size(), 1u);
        EXPECT_EQ(faces[0]["smoothness"], diagonal == 0 ? "C1" : "C0");
    }
}

TEST_F(CliAnalyze, ListsTheMostFrequentKindsAndCountsTheRest) {
    WriteMesh("solid.vtu", TwentyEightTets());
    const std::string all = MustRun("analyze solid.vtu --top 0").out, one = MustRun("analyze solid.vtu --top 1").out;
    EXPECT_THAT(all, testing::Not(HasSubstr("not listed")));
    EXPECT_THAT(one, HasSubstr("not listed; --top 0 lists all"));
    EXPECT_LT(one.size(), all.size());
    const auto result = Json("analyze solid.vtu --top 1");
    int n_vertices = 0;
    for (const char* group : {"vertices inside", "vertices of the surface"}) {
        for (const auto& kind : Group(result, group)) n_vertices += kind["count"].get<int>();
    }
    EXPECT_EQ(n_vertices, 16) << "JSON has all";
}

TEST_F(CliAnalyze, SurfacesHaveTheirValences) {
    const std::string valences = MustRun("analyze --valence 3..12 --scheme loop").out;
    EXPECT_THAT(valences, HasSubstr("6 triangles   C2 spectrum"));
    EXPECT_THAT(valences, HasSubstr("12 triangles  C1  "));
    EXPECT_THAT(MustRun("analyze --border 1..4 --scheme catmull-clark").out,
                HasSubstr("2 quadrilaterals  C2 spectrum"));
    WriteText("cube.obj",
              "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
              "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n");
    const auto result = Json("analyze cube.obj");
    EXPECT_EQ(result["scheme"], "catmull-clark");
    ASSERT_EQ(result["kinds"].size(), 1u);
    EXPECT_EQ(result["kinds"][0]["place"], "3 faces");
    EXPECT_EQ(result["kinds"][0]["count"], 8);
    EXPECT_EQ(result["kinds"][0]["smoothness"], "C1");
}

TEST_F(CliAnalyze, SaysTheSameForAnyNumberOfThreads) {
    WriteMesh("solid.vtu", TwentyEightTets());
    nlohmann::json one = Json("analyze solid.vtu --scheme interpolatory --threads 1");
    nlohmann::json three = Json("analyze solid.vtu --scheme interpolatory --threads 3");
    one.erase("seconds");
    three.erase("seconds");
    EXPECT_EQ(one, three);
}

TEST_F(CliAnalyze, PlotsWhatItLists) {
    if (MustRun("analyze --help").out.find("--plot") == std::string::npos) GTEST_SKIP() << "built without pictures";
    MustRun("analyze --edge 3..6 --scheme mlca --plot edges.svg");
    const std::string svg = ReadText(folder / "edges.svg");
    for (const char* word : {"<svg", ">3 cells<", ">6 cells<", ">1/2<", ">1/4<", ">C1 uneven<", ">C2 spectrum<"}) {
        EXPECT_THAT(svg, HasSubstr(word));
    }
}

TEST_F(CliAnalyze, SaysWhatIsWrong) {
    WriteMesh("tet.vtu", OneTet());
    ExpectError("analyze", 2, "which place is meant");
    ExpectError("analyze tet.vtu --regular", 2, "which place is meant");
    ExpectError("analyze nothing.vtu", 1, "nothing.vtu");
    ExpectError("analyze tet.vtu --scheme loop", 1, "tet.vtu: ");
    ExpectError("analyze --face --scheme mlca", 2, "mlca is not for tets");
    ExpectError("analyze --valence 2 --scheme loop", 2, "from 3 to 32");
    ExpectError("analyze --border 0 --scheme loop", 2, "from 1 to 32");
    ExpectError("analyze --regular --scheme nonsense", 2, "nonsense");
    WriteText("broken.obj", "v 0 0 0\nf 1 2 3\n");
    ExpectError("analyze broken.obj", 1, "broken.obj");
    WriteText("curve.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nl 1 2 3\n");
    ExpectError("analyze curve.obj --scheme loop", 1, "curve.obj: no place to analyze");
    EXPECT_EQ(Names(), (std::set<std::string>{"tet.vtu", "broken.obj", "curve.obj"})) << "no output is left";
}

}  // namespace
