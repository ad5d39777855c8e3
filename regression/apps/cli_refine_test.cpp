// SPDX-License-Identifier: Apache-2.0
// Refinement through the program: counts, values, data, octahedra, mixed dimensions, stencils.
#include "apps/cli_testing.h"

namespace SolidSubdiv::CliTesting {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

// Refined values are a few sums of a dozen products each; files hold doubles exactly.
constexpr double kRoundoff = 1e-14;

class CliRefine : public CliTest {
  protected:
    void SetUp() override {
        CliTest::SetUp();
        WriteMesh("lattice.vtu", TwentyEightTets());
    }
};

/// Positions of the corners of all cells, one after another: independent of how vertices are numbered.
std::vector<double> Corners(const Io::Mesh& mesh) {
    std::vector<double> corners;
    for (const auto* cells : {&mesh.topology.tets, &mesh.topology.octs}) {
        for (Index v : *cells) {
            for (int axis = 0; axis < 3; ++axis) corners.push_back(mesh.positions[3 * v + axis]);
        }
    }
    return corners;
}

TEST_F(CliRefine, TwentyEightTetsGrowAsInThePaper) {
    const auto json = Json("refine lattice.vtu -o out.vtu --levels 3 --keep-octahedra");
    const std::vector<int> expected = {28, 140, 952, 7280};
    ASSERT_EQ(json["levels"].size(), 4u);
    for (int i = 0; i < 4; ++i) EXPECT_EQ(json["levels"][i]["cells"], expected[i]) << i;
    EXPECT_EQ(json["levels"][0]["vertices"], 16);
    const Io::Mesh mesh = ReadMesh("out.vtu");
    EXPECT_EQ(mesh.topology.n_cells(), 7280);
    EXPECT_EQ(mesh.topology.n_vertices, json["levels"][3]["vertices"]);
    for (const char* key : {"input", "settings", "outputs", "bytes", "matched_faces", "seconds", "defects"}) {
        EXPECT_TRUE(json.contains(key)) << key;
    }
    EXPECT_EQ(json["outputs"][0]["bytes"], fs::file_size(folder / "out.vtu"));
}

TEST_F(CliRefine, AttributesThatAFormatCannotCarryAreNamed) {
    Io::Mesh mesh = TwentyEightTets();
    mesh.point_data.push_back({"density", 1, std::vector<double>(16, 2.5)});
    WriteMesh("dense.vtu", mesh);
    const Outcome outcome = MustRun("refine dense.vtu -o out.vtu --boundary skin.stl");
    EXPECT_EQ(outcome.err, "solidsubdiv: skin.stl: the format can't carry density, left out\n");
    EXPECT_NE(ReadMesh("out.vtu").FindPointData("density"), nullptr);
    EXPECT_THAT(MustRun("refine dense.vtu -o out.vtu --boundary skin.ply").err, IsEmpty());
}

TEST_F(CliRefine, OctahedraAreCutIntoFourUnlessKept) {
    MustRun("refine lattice.vtu -o cut.vtu");
    MustRun("refine lattice.vtu -o kept.vtu --keep-octahedra");
    const Io::Mesh cut = ReadMesh("cut.vtu"), kept = ReadMesh("kept.vtu");
    EXPECT_EQ(cut.topology.n_tets(), 28 * 4 + 28 * 4);
    EXPECT_EQ(cut.topology.n_octs(), 0);
    EXPECT_EQ(kept.topology.n_tets(), 28 * 4);
    EXPECT_EQ(kept.topology.n_octs(), 28);
    EXPECT_EQ(cut.positions, kept.positions);
    ASSERT_NE(kept.FindCellData("diagonal"), nullptr);
    EXPECT_EQ(kept.FindCellData("diagonal")->values, std::vector<double>(28 * 5, 0.0));
}

TEST_F(CliRefine, RefiningAFileOfALevelOnceMoreIsRefiningTwice) {
    MustRun("refine lattice.vtu -o one.vtu --levels 1 --keep-octahedra");
    MustRun("refine one.vtu -o one_more.vtu --levels 1 --keep-octahedra --diagonals given --orient keep");
    MustRun("refine lattice.vtu -o two.vtu --levels 2 --keep-octahedra");
    const Io::Mesh one_more = ReadMesh("one_more.vtu"), two = ReadMesh("two.vtu");
    ASSERT_EQ(one_more.topology.n_octs(), two.topology.n_octs());
    // Edges are numbered anew in the file, so sums are taken in another order.
    EXPECT_LT(Difference(Corners(one_more), Corners(two)), kRoundoff);
}

TEST_F(CliRefine, GivenDiagonalsReproduceTheSearchBitByBit) {
    for (const std::string policy : {"matched", "shortest", "first"}) {
        MustRun("refine lattice.vtu -o chosen.vtu --levels 0 --diagonals " + policy);
        MustRun("refine lattice.vtu -o direct.vtu --levels 2 --diagonals " + policy);
        MustRun("refine chosen.vtu -o given.vtu --levels 2 --diagonals given");
        EXPECT_EQ(ReadText(folder / "given.vtu"), ReadText(folder / "direct.vtu")) << policy;
    }
    MustRun("refine lattice.vtu -o first.vtu --diagonals first");
    MustRun("refine lattice.vtu -o matched.vtu");
    EXPECT_NE(ReadMesh("first.vtu").topology.tets, ReadMesh("matched.vtu").topology.tets) << "policies do something";
}

TEST_F(CliRefine, LevelZeroIsTheMeshItselfWithItsDiagonals) {
    MustRun("refine lattice.vtu -o zero.vtu --levels 0 --diagonals matched");
    const Io::Mesh zero = ReadMesh("zero.vtu"), lattice = ReadMesh("lattice.vtu");
    EXPECT_EQ(zero.topology.tets, lattice.topology.tets);
    EXPECT_EQ(zero.positions, lattice.positions);
    ASSERT_NE(zero.FindCellData("diagonal"), nullptr);
    const std::vector<double>& diagonals = zero.FindCellData("diagonal")->values;
    EXPECT_GT(*std::max_element(diagonals.begin(), diagonals.end()), 0);
}

TEST_F(CliRefine, ThreadsDoNotChangeABit) {
    MustRun("refine lattice.vtu -o one.vtu --levels 3 --threads 1");
    MustRun("refine lattice.vtu -o four.vtu --levels 3 --threads 4");
    EXPECT_EQ(ReadText(folder / "one.vtu"), ReadText(folder / "four.vtu"));
}

TEST_F(CliRefine, PointDataAreRefinedLikePositions) {
    Io::Mesh mesh = TwentyEightTets();
    Io::Attribute same{"same", 3, mesh.positions}, mixed{"mixed", 1, {}};
    for (std::size_t v = 0; v < mesh.positions.size(); v += 3) {
        mixed.values.push_back(2 * mesh.positions[v] - mesh.positions[v + 1] + 5);
    }
    mesh.point_data = {same, mixed};
    WriteMesh("data.vtu", mesh);
    for (const std::string options : {"", "--scheme linear-solid", "--limit", "--diagonals averaged"}) {
        MustRun("refine data.vtu -o out.vtu --levels 2 " + options);
        const Io::Mesh out = ReadMesh("out.vtu");
        ASSERT_NE(out.FindPointData("same"), nullptr);
        EXPECT_EQ(out.FindPointData("same")->values, out.positions) << options;
        std::vector<double> expected;
        for (std::size_t v = 0; v < out.positions.size(); v += 3) {
            expected.push_back(2 * out.positions[v] - out.positions[v + 1] + 5);
        }
        EXPECT_LT(Difference(expected, out.FindPointData("mixed")->values), kRoundoff) << options;
    }
}

TEST_F(CliRefine, LinearTetIsHalvedAtItsEdges) {
    WriteMesh("tet.vtu", OneTet());
    MustRun("refine tet.vtu -o out.vtu --scheme linear-solid");
    const std::vector<double> expected = {0, 0,  0, 1, 0, 0,  0,  1,  0, 0,  0, 1,  .5, 0,  0,
                                          0, .5, 0, 0, 0, .5, .5, .5, 0, .5, 0, .5, 0,  .5, .5};
    EXPECT_EQ(ReadMesh("out.vtu").positions, expected);
}

TEST_F(CliRefine, CellsInheritTheDataOfTheirControlCells) {
    // Linear refinement keeps every child inside its control cell, so the child's centre tells whose it is.
    Io::Mesh mesh = TwentyEightTets();
    Io::Attribute volume{"number", 2, {}};
    for (int c = 0; c < 28; ++c) volume.values.insert(volume.values.end(), {100.0 + c, -1.0 * c});
    mesh.cell_data = {volume};
    WriteMesh("data.vtu", mesh);
    MustRun("refine data.vtu -o out.vtu --levels 2 --scheme linear-solid --keep-octahedra");
    const Io::Mesh out = ReadMesh("out.vtu");
    ASSERT_NE(out.FindCellData("number"), nullptr);
    const std::vector<double>& numbers = out.FindCellData("number")->values;
    ASSERT_EQ(numbers.size(), 2u * 952u);

    const auto point = [](const Io::Mesh& m, Index v) { return std::span(m.positions).subspan(3 * v, 3); };
    const auto contains = [&](int cell, const std::array<double, 3>& p) {
        const Index* t = mesh.topology.tets.data() + 4 * cell;
        for (int out_corner = 0; out_corner < 4; ++out_corner) {
            // p and this corner lie on the same side of the opposite face.
            std::array<std::array<double, 3>, 2> a{};
            std::array<std::array<double, 3>, 2> edge{};
            const Index base = t[(out_corner + 1) % 4];
            for (int axis = 0; axis < 3; ++axis) {
                a[0][axis] = p[axis] - point(mesh, base)[axis];
                a[1][axis] = point(mesh, t[out_corner])[axis] - point(mesh, base)[axis];
                edge[0][axis] = point(mesh, t[(out_corner + 2) % 4])[axis] - point(mesh, base)[axis];
                edge[1][axis] = point(mesh, t[(out_corner + 3) % 4])[axis] - point(mesh, base)[axis];
            }
            const auto side = [&](const std::array<double, 3>& q) {
                return q[0] * (edge[0][1] * edge[1][2] - edge[0][2] * edge[1][1]) +
                       q[1] * (edge[0][2] * edge[1][0] - edge[0][0] * edge[1][2]) +
                       q[2] * (edge[0][0] * edge[1][1] - edge[0][1] * edge[1][0]);
            };
            if (side(a[0]) * side(a[1]) <= 0) return false;
        }
        return true;
    };
    const auto check = [&](std::span<const Index> cell, std::size_t row) {
        std::array<double, 3> centre{};
        for (Index v : cell) {
            for (int axis = 0; axis < 3; ++axis) centre[axis] += point(out, v)[axis] / static_cast<double>(cell.size());
        }
        const int owner = static_cast<int>(numbers[2 * row]) - 100;
        EXPECT_EQ(numbers[2 * row + 1], -owner);
        EXPECT_TRUE(contains(owner, centre)) << row;
    };
    const auto n_tets = static_cast<std::size_t>(out.topology.n_tets());
    for (std::size_t t = 0; t < n_tets; ++t) check(std::span(out.topology.tets).subspan(4 * t, 4), t);
    for (std::size_t o = 0; 6 * o < out.topology.octs.size(); ++o) {
        check(std::span(out.topology.octs).subspan(6 * o, 6), n_tets + o);
    }
}

TEST_F(CliRefine, InvertedCellsAreTurnedKeptOrRefusedWithAWord) {
    Io::Mesh mesh = TwentyEightTets();
    std::swap(mesh.topology.tets[4 * 5 + 2], mesh.topology.tets[4 * 5 + 3]);
    WriteMesh("inverted.vtu", mesh);
    const Outcome repaired = MustRun("refine inverted.vtu -o repaired.vtu --diagonals first");
    EXPECT_THAT(repaired.err, HasSubstr("1 inverted cell turned"));
    MustRun("refine lattice.vtu -o straight.vtu --diagonals first");
    EXPECT_EQ(ReadText(folder / "repaired.vtu"), ReadText(folder / "straight.vtu"));
    EXPECT_THAT(MustRun("refine inverted.vtu -o kept.vtu --orient keep").err, HasSubstr("1 inverted cell kept"));
    EXPECT_EQ(Json("info kept.vtu")["volume"]["negative_cells"], 8);
    EXPECT_EQ(Run("refine inverted.vtu -o refused.vtu --orient refuse").status, 1);
    EXPECT_THAT(MustRun("refine inverted.vtu -o repaired.vtu --quiet").err, IsEmpty());
}

TEST_F(CliRefine, ASurfaceFollowsLoop) {
    WriteText("tetrahedron.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n");
    const auto json = Json("refine tetrahedron.obj -o out.obj");
    EXPECT_EQ(json["settings"]["scheme"], "loop");
    const Io::Mesh out = ReadMesh("out.obj");
    EXPECT_EQ(out.topology.n_triangles(), 16);
    ASSERT_EQ(out.topology.n_vertices, 10);
    // Valence 3: 7/16 of itself and 3/16 of each neighbour; edges 3/8, 3/8, 1/8, 1/8. Exact in binary.
    EXPECT_THAT(std::vector<double>(out.positions.begin(), out.positions.begin() + 6),
                testing::ElementsAre(3. / 16, 3. / 16, 3. / 16, 7. / 16, 3. / 16, 3. / 16));
    EXPECT_THAT(std::vector<double>(out.positions.begin() + 12, out.positions.begin() + 15),
                testing::ElementsAre(3. / 8, 1. / 8, 1. / 8));
}

TEST_F(CliRefine, ACurveFollowsTheCubicBSplineAndKeepsItsEnds) {
    WriteText("curve.obj", "v 0 0 0\nv 1 0 0\nv 1 2 0\nv 3 2 0\nl 1 2 3 4\n");
    MustRun("refine curve.obj -o out.vtu --levels 2");
    const Io::Mesh out = ReadMesh("out.vtu");
    EXPECT_EQ(out.topology.n_edges(), 12);
    MustRun("refine curve.obj -o out.vtu");
    const std::vector<double> expected = {0, 0,  0, 7. / 8, 2. / 8, 0, 10. / 8, 14. / 8, 0, 3, 2,
                                          0, .5, 0, 0,      1,      1, 0,       2,       2, 0};
    EXPECT_EQ(ReadMesh("out.vtu").positions, expected);
}

TEST_F(CliRefine, PartsOfEveryDimensionStayTogether) {
    // A tet, a triangle on its edge 1 2, a curve from its vertex 3, and tags: a triangle on a face, a single vertex.
    Io::Mesh mesh = TetMesh({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 2, 2, 0, 0, 0, 3, 0, 0, 5}, {0, 1, 2, 3});
    mesh.topology.triangles = {0, 1, 2, 1, 4, 2};
    mesh.topology.edges = {3, 5, 5, 6};
    mesh.topology.vertices = {0};
    mesh.cell_data = {{"part", 1, {10, 20, 21, 30, 31, 40}}};
    WriteMesh("mixed.vtu", mesh);
    const Outcome outcome = MustRun("refine mixed.vtu -o out.vtu --levels 2 --keep-octahedra");
    EXPECT_THAT(outcome.err, HasSubstr("2 elements lie on a part of higher dimension"));
    const Io::Mesh out = ReadMesh("out.vtu");
    EXPECT_EQ(out.topology.n_tets(), 24);
    EXPECT_EQ(out.topology.n_octs(), 10);
    EXPECT_EQ(out.topology.n_triangles(), 16);
    EXPECT_EQ(out.topology.n_edges(), 8);
    std::vector<double> expected(34, 10.0);
    expected.insert(expected.end(), 16, 21.0);
    expected.insert(expected.end(), 4, 30.0);
    expected.insert(expected.end(), 4, 31.0);
    EXPECT_EQ(out.FindCellData("part")->values, expected);
    EXPECT_EQ(out.FindCellData("diagonal")->values, std::vector<double>(58, 0.0));
    // Each curve element's pieces are a path between its ends, halves of halves when refined linearly.
    MustRun("refine mixed.vtu -o linear.vtu --levels 2 --scheme linear-solid");
    const Io::Mesh linear = ReadMesh("linear.vtu");
    std::multiset<double> lengths;
    for (std::size_t e = 0; e < linear.topology.edges.size(); e += 2) {
        const Index a = linear.topology.edges[e], b = linear.topology.edges[e + 1];
        lengths.insert(std::abs(linear.positions[3 * a + 2] - linear.positions[3 * b + 2]));
    }
    EXPECT_THAT(lengths, testing::ElementsAre(.5, .5, .5, .5, .5, .5, .5, .5));
    double area = 0;  // in the plane z = 0; the triangle's is 3/2
    for (std::size_t t = 0; t < linear.topology.triangles.size(); t += 3) {
        const auto p = [&](int k, int axis) { return linear.positions[3 * linear.topology.triangles[t + k] + axis]; };
        area += ((p(1, 0) - p(0, 0)) * (p(2, 1) - p(0, 1)) - (p(1, 1) - p(0, 1)) * (p(2, 0) - p(0, 0))) / 2;
    }
    EXPECT_NEAR(area, 1.5, kRoundoff) << "and turned as the control triangle is";
}

TEST_F(CliRefine, BoundaryIsTheSurfaceOfTheSolidOverItsOwnVertices) {
    MustRun("refine lattice.vtu -o out.vtu --levels 2 --boundary out.obj");
    const Io::Mesh solid = ReadMesh("out.vtu"), boundary = ReadMesh("out.obj");
    EXPECT_EQ(boundary.topology.n_triangles(), 14 * 16);
    EXPECT_EQ(boundary.topology.n_vertices, 14 * 16 / 2 + 2);
    const auto json = Json("info out.obj");
    EXPECT_EQ(json["surface"]["components"][0]["genus"], 0);
    EXPECT_EQ(json["surface"]["components"][0]["vertices"], 14 * 16 / 2 + 2);
    std::set<std::vector<double>> points;
    for (std::size_t v = 0; v < solid.positions.size(); v += 3) {
        points.insert({solid.positions[v], solid.positions[v + 1], solid.positions[v + 2]});
    }
    for (std::size_t v = 0; v < boundary.positions.size(); v += 3) {
        EXPECT_TRUE(points.contains({boundary.positions[v], boundary.positions[v + 1], boundary.positions[v + 2]}));
    }
}

TEST_F(CliRefine, StencilsTimesControlPointsAreTheRefinedPoints) {
    for (const int levels : {0, 2}) {
        const std::string options = "refine lattice.vtu -o out.vtu --levels " + std::to_string(levels);
        const Outcome outcome = MustRun(options + " --stencils out.mtx");
        EXPECT_THAT(outcome.err, HasSubstr("rows over 16 control vertices"));
        EXPECT_THAT(outcome.err, HasSubstr("weights"));
        std::istringstream text(ReadText(folder / "out.mtx"));
        std::string line;
        std::getline(text, line);
        EXPECT_EQ(line, "%%MatrixMarket matrix coordinate real general");
        while (text.peek() == '%') std::getline(text, line);
        std::size_t n_rows = 0, n_columns = 0, n_weights = 0;
        text >> n_rows >> n_columns >> n_weights;
        const Io::Mesh lattice = ReadMesh("lattice.vtu"), out = ReadMesh("out.vtu");
        ASSERT_EQ(n_rows, static_cast<std::size_t>(out.topology.n_vertices));
        ASSERT_EQ(n_columns, 16u);
        std::vector<double> product(3 * n_rows, 0.0), sums(n_rows, 0.0);
        std::size_t row = 0, column = 0, n_read = 0;
        for (double weight = 0; text >> row >> column >> weight; ++n_read) {
            ASSERT_TRUE(row >= 1 && row <= n_rows && column >= 1 && column <= n_columns);
            sums[row - 1] += weight;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                product[3 * (row - 1) + axis] += weight * lattice.positions[3 * (column - 1) + axis];
            }
        }
        EXPECT_EQ(n_read, n_weights);
        EXPECT_LT(Difference(sums, std::vector<double>(n_rows, 1.0)), kRoundoff);
        EXPECT_LT(Difference(product, out.positions), kRoundoff);
    }
}

TEST_F(CliRefine, LimitDoesNotDependOnTheLevel) {
    WriteText("tetrahedron.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n");
    for (const std::string file : {"lattice.vtu", "tetrahedron.obj"}) {
        std::vector<std::vector<double>> limits;
        for (const std::string levels : {"0", "1", "2"}) {
            MustRun("refine " + file + " -o out.vtu --limit --levels " + levels);
            std::vector<double> positions = ReadMesh("out.vtu").positions;
            positions.resize(ReadMesh(file).positions.size());
            limits.push_back(positions);
        }
        // Limit rows come from eigenvectors that are known to about 1e-13.
        EXPECT_LT(Difference(limits[1], limits[0]), 1e-12) << file;
        EXPECT_LT(Difference(limits[2], limits[0]), 1e-12) << file;
        EXPECT_GT(Difference(limits[0], ReadMesh(file).positions), 1e-3) << "the limit is not the control mesh";
    }
}

TEST_F(CliRefine, TextFormIsTheSameMesh) {
    MustRun("refine lattice.vtu -o binary.vtu --levels 2");
    MustRun("refine lattice.vtu -o text.vtu --levels 2 --ascii");
    EXPECT_THAT(ReadText(folder / "text.vtu"), HasSubstr("format=\"ascii\""));
    EXPECT_EQ(ReadMesh("text.vtu").positions, ReadMesh("binary.vtu").positions);
    EXPECT_EQ(ReadMesh("text.vtu").topology.tets, ReadMesh("binary.vtu").topology.tets);
}

TEST_F(CliRefine, ThePictureHasPanelsThatAreNotEmpty) {
    if (MustRun("refine --help").out.find("--picture") == std::string::npos) {
        GTEST_SKIP() << "built without pictures (no Embree or libpng)";
    }
    MustRun("refine lattice.vtu -o out.vtu --levels 2 --picture out.png");
    const std::string png = ReadText(folder / "out.png");
    ASSERT_GT(png.size(), 24u);
    EXPECT_EQ(png.substr(1, 3), "PNG");
    const auto number = [&](std::size_t at) {
        int value = 0;
        for (std::size_t i = 0; i < 4; ++i) value = 256 * value + static_cast<unsigned char>(png[at + i]);
        return value;
    };
    EXPECT_GT(number(16), 1000) << "two panels wide";
    EXPECT_GT(number(20), 1000) << "two panels high";
    EXPECT_GT(png.size(), 20000u) << "an empty picture packs to a few kilobytes";
}

}  // namespace
}  // namespace SolidSubdiv::CliTesting
