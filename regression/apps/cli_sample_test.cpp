// SPDX-License-Identifier: Apache-2.0
// Samples of the limit through the program: closed surfaces, tolerances, tets, normals, what is refused.
#include <solidsubdiv/kit/geometry/cell_volume.h>
#include <solidsubdiv/kit/geometry/surface_components.h>

#include "apps/cli_testing.h"

namespace SolidSubdiv::CliTesting {
namespace {

using testing::HasSubstr;

class CliSample : public CliTest {
  protected:
    void SetUp() override {
        CliTest::SetUp();
        WriteMesh("lattice.vtu", TwentyEightTets());
        WriteText("cube.obj", R"(v -1 -1 -1
v 1 -1 -1
v 1 1 -1
v -1 1 -1
v -1 -1 1
v 1 -1 1
v 1 1 1
v -1 1 1
f 1 4 3 2
f 5 6 7 8
f 1 2 6 5
f 2 3 7 6
f 3 4 8 7
f 4 1 5 8
)");
    }

    static Offset EulerCharacteristic(const Io::Mesh& mesh) {
        Offset sum = 0;
        for (const auto& piece : Geometry::SurfaceComponents(mesh.topology.triangles, mesh.topology.n_vertices)) {
            EXPECT_TRUE(piece.IsClosed());
            sum += piece.EulerCharacteristic();
        }
        return sum;
    }
};

TEST_F(CliSample, ClosedSurfacesStayClosedInEveryFormat) {
    for (const std::string file : {"out.ply", "out.obj", "out.vtu", "out.vtk", "out.stl"}) {
        const auto at_rate = Json("sample cube.obj -o " + file + " --rate 3");
        EXPECT_EQ(at_rate["triangles"], 2 * 9 * 6);
        EXPECT_EQ(EulerCharacteristic(ReadMesh(file)), 2) << file;
        const auto close = Json("sample cube.obj -o " + file + " --tolerance 0.01");
        EXPECT_LE(close["error"]["largest"], 0.01);
        EXPECT_GT(close["error"]["tests"], 100);
        EXPECT_EQ(EulerCharacteristic(ReadMesh(file)), 2) << file;
        EXPECT_EQ(ReadMesh(file).topology.n_triangles(), close["triangles"]);
    }
}

TEST_F(CliSample, ASmallerToleranceTakesMoreTriangles) {
    Offset before = 0;
    for (const std::string tolerance : {"0.1", "0.01", "0.001"}) {
        const auto json = Json("sample lattice.vtu -o out.ply --tolerance " + tolerance);
        EXPECT_LE(json["error"]["largest"], std::stod(tolerance));
        EXPECT_GT(json["triangles"], before);
        before = json["triangles"];
    }
}

TEST_F(CliSample, QuadsAreKeptWhereAskedFor) {
    const auto json = Json("sample cube.obj -o out.obj --rate 3 --quads");
    EXPECT_EQ(json["quads"], 9 * 6);
    EXPECT_EQ(json["triangles"], 0);
    EXPECT_EQ(ReadMesh("out.obj").topology.n_quads(), 9 * 6);
}

TEST_F(CliSample, ARateOfTwoIsTheLimitOfLevelOne) {
    MustRun("sample cube.obj -o out.obj --rate 2 --quads");
    MustRun("refine cube.obj -o refined.obj --levels 1 --limit");
    const auto sorted = [](const Io::Mesh& mesh) {
        std::vector<std::array<double, 3>> points;
        for (std::size_t i = 0; i < mesh.positions.size(); i += 3) {
            points.push_back({});
            for (std::size_t k = 0; k < 3; ++k) {  // round-off can't reorder them
                points.back()[k] = std::round(mesh.positions[i + k] * 1e10) / 1e10;
            }
        }
        std::sort(points.begin(), points.end());
        return points;
    };
    EXPECT_EQ(sorted(ReadMesh("out.obj")), sorted(ReadMesh("refined.obj")));
}

TEST_F(CliSample, SemiSharpVerticesHaveOneLimitWhateverTheLevel) {
    WriteText("sharp.obj", ReadText(folder / "cube.obj") + "t crease 2/1/0 0 1 2.5\nt corner 1/1/0 6 1.5\n");
    std::vector<double> late;
    for (const std::string levels : {"4", "1", "0"}) {
        EXPECT_EQ(MustRun("refine sharp.obj -o out.obj --limit --levels " + levels).err, "");
        std::vector<double> limits = ReadMesh("out.obj").positions;
        limits.resize(3 * 8);
        if (late.empty()) late = limits;
        EXPECT_LE(Difference(limits, late), 1e-14) << levels;
    }
    MustRun("sample sharp.obj -o out.obj --rate 1");
    EXPECT_LE(Difference(ReadMesh("out.obj").positions, late), 1e-14);
}

TEST_F(CliSample, TetsOfTheInsideAreThoseOfTheLimitOfALevel) {
    const auto json = Json("sample lattice.vtu -o inside.vtu --inside --rate 4 --scheme linear-solid");
    MustRun("refine lattice.vtu -o refined.vtu --levels 2 --limit --scheme linear-solid");
    const Io::Mesh inside = ReadMesh("inside.vtu"), refined = ReadMesh("refined.vtu");
    EXPECT_EQ(inside.topology.n_tets(), json["tetrahedra"]);
    EXPECT_EQ(inside.topology.n_tets(), refined.topology.n_tets());  // octahedra are cut alike
    EXPECT_LE(Difference(inside.positions, refined.positions), 1e-15);
    EXPECT_EQ(json["not_positive"], 0);
    double volume = 0;
    for (double v : Geometry::CellVolumes(inside.topology, inside.positions)) volume += v;
    EXPECT_NEAR(volume, json["volume"].get<double>(), 1e-12);
}

TEST_F(CliSample, NormalsPointOutwardsAndPointDataComeAlong) {
    Io::Mesh lattice = TwentyEightTets();
    for (Index v = 0; v < 16; ++v) {
        if (v == 0) lattice.point_data.push_back({"x", 1, {}});
        lattice.point_data[0].values.push_back(lattice.positions[3 * static_cast<std::size_t>(v)]);
    }
    WriteMesh("data.vtu", lattice);
    MustRun("sample data.vtu -o out.vtu");
    const Io::Mesh mesh = ReadMesh("out.vtu");
    const Io::Attribute *normals = mesh.FindPointData("Normals"), *x = mesh.FindPointData("x");
    ASSERT_NE(normals, nullptr);
    ASSERT_NE(x, nullptr);
    double flux = 0;  // of the facets' areas through the normals: nearly their sum
    double area = 0;
    for (std::size_t t = 0; t < mesh.topology.triangles.size(); t += 3) {
        std::array<std::array<double, 3>, 2> e{};
        for (std::size_t k = 0; k < 3; ++k) {
            const auto p = [&](std::size_t c) {
                return mesh.positions[3 * static_cast<std::size_t>(mesh.topology.triangles[t + c]) + k];
            };
            e[0][k] = p(1) - p(0);
            e[1][k] = p(2) - p(0);
        }
        const std::array<double, 3> n = {e[0][1] * e[1][2] - e[0][2] * e[1][1], e[0][2] * e[1][0] - e[0][0] * e[1][2],
                                         e[0][0] * e[1][1] - e[0][1] * e[1][0]};
        area += std::hypot(n[0], n[1], n[2]);
        for (std::size_t k = 0; k < 3; ++k) {
            flux += n[k] * normals->values[3 * static_cast<std::size_t>(mesh.topology.triangles[t]) + k];
        }
    }
    EXPECT_GT(flux, 0.9 * area);  // facets turn a little from corner to corner
    for (std::size_t v = 0; v < x->values.size(); ++v) EXPECT_NEAR(x->values[v], mesh.positions[3 * v], 1e-14);
    MustRun("sample data.vtu -o out.ply");
    EXPECT_NE(ReadMesh("out.ply").FindPointData("nz"), nullptr);
    EXPECT_EQ(MustRun("sample data.vtu -o out.obj").err, "solidsubdiv: out.obj: the format can't carry x, left out\n");
}

TEST_F(CliSample, TheSameFilesForAnyNumberOfThreads) {
    MustRun("sample lattice.vtu -o one.ply --tolerance 0.01 --threads 1");
    MustRun("sample lattice.vtu -o two.ply --tolerance 0.01 --threads 2");
    EXPECT_EQ(ReadText(folder / "one.ply"), ReadText(folder / "two.ply"));
}

TEST_F(CliSample, BadRequestsAreRefusedInOneLineAndLeaveNoFile) {
    const std::vector<std::array<std::string, 2>> bad = {
        {"lattice.vtu -o x.ply --inside", "PLY files can't hold tets"},
        {"lattice.vtu -o x.vtu --inside --rate 3", "--rate of 1, 2, 4, 8"},
        {"lattice.vtu -o x.vtu --inside --tolerance 1", "leave out --tolerance"},
        {"lattice.vtu -o x.stl --quads", "leave out --quads"},
        {"lattice.vtu -o x.mesh2 ", ".mesh2"},
        {"lattice.vtu -o x.ply --rate 2 --tolerance 1", "--rate"},
        {"lattice.vtu -o x.ply --tolerance -1", "--tolerance"},
        {"lattice.vtu -o x.ply --rate 0", "--rate"},
    };
    for (const auto& [arguments, text] : bad) {
        const Outcome outcome = Run("sample " + arguments);
        EXPECT_EQ(outcome.status, 2) << arguments;
        EXPECT_THAT(outcome.err, HasSubstr(text)) << arguments;
        EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    }
    const std::vector<std::array<std::string, 2>> impossible = {
        {"cube.obj -o x.vtu --inside", "has no cells; leave out --inside"},
        {"lattice.vtu -o x.ply --rate 4096", "more than the 20000000 allowed"},
        {"none.vtu -o x.ply", "none.vtu"},
    };
    for (const auto& [arguments, text] : impossible) {
        const Outcome outcome = Run("sample " + arguments);
        EXPECT_EQ(outcome.status, 1) << arguments;
        EXPECT_THAT(outcome.err, HasSubstr(text)) << arguments;
    }
    EXPECT_EQ(Names(), (std::set<std::string>{"cube.obj", "lattice.vtu"}));
}

}  // namespace
}  // namespace SolidSubdiv::CliTesting
