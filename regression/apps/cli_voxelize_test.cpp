// SPDX-License-Identifier: Apache-2.0
// Voxels through the program: distances, fog, attributes, levels by tolerance, other programs that read the files.
#include <solidsubdiv/apps/voxel/grids.h>

#include <cmath>
#include <map>

#include "apps/cli_testing.h"
#include "sanitized.h"

namespace SolidSubdiv::CliTesting {
namespace {

using testing::HasSubstr;

/// A hexahedron over [-1, 1]^3 with heat 3 + x + 2 y - z, and its position as a vector.
Io::Mesh Cube() {
    Io::Mesh mesh;
    mesh.topology.n_vertices = 8;
    mesh.positions = {-1, -1, -1, 1, -1, -1, 1, 1, -1, -1, 1, -1, -1, -1, 1, 1, -1, 1, 1, 1, 1, -1, 1, 1};
    mesh.topology.hexes = {0, 1, 2, 3, 4, 5, 6, 7};
    mesh.point_data = {{"heat", 1, {}}, {"place", 3, mesh.positions}, {"pair", 2, std::vector<double>(16)}};
    for (std::size_t i = 0; i < 24; i += 3) {
        const double* p = &mesh.positions[i];
        mesh.point_data[0].values.push_back(3 + p[0] + 2 * p[1] - p[2]);
    }
    return mesh;
}

/// Sizes by which faces of the cube lie between voxels: +-1 is 12.5 voxels from 0.
constexpr char kAligned[] = " --scheme linear-solid --voxel-size 0.08 ";
// Values are floats of magnitude up to 6.
constexpr double kFloat = 1e-6;

class CliVoxelize : public CliTest {
  protected:
    void SetUp() override {
        CliTest::SetUp();
        WriteMesh("cube.vtu", Cube());
        WriteMesh("tets.vtu", TwentyEightTets());
    }
    Voxel::Grids Grids(const std::string& name) const { return Voxel::Grids::Read(folder / name); }
    double ValueAt(const Voxel::Grids& grids, const std::string& name, int x, int y, int z) const {
        return grids.Values(name, {x, y, z}, {x, y, z})[0];
    }
    /// What a command prints, which must succeed.
    std::string Tool(const std::string& command) const {
        const std::string out = (folder / "tool.txt").string();
        const int status = std::system(("cd '" + folder.string() + "' && " + command + " >'" + out + "' 2>&1").c_str());
        EXPECT_EQ(status, 0) << ReadText(out);
        return ReadText(out);
    }
};

TEST_F(CliVoxelize, LevelSetsAreDistances_NegativeInside) {
    const auto json = Json("voxelize cube.vtu -o cube.vdb --levels 1" + std::string(kAligned));
    const Voxel::Grids grids = Grids("cube.vdb");
    for (int i = 11; i <= 14; ++i) EXPECT_NEAR(ValueAt(grids, "surface", i, 0, 0), 0.08 * i - 1, kFloat) << i;
    EXPECT_NEAR(ValueAt(grids, "surface", 14, 14, 0), std::hypot(0.12, 0.12), kFloat);
    EXPECT_NEAR(ValueAt(grids, "surface", 0, 0, 0), -0.24, kFloat);
    EXPECT_NEAR(ValueAt(grids, "surface", 40, 0, 0), 0.24, kFloat);
    ASSERT_EQ(json["grids"].size(), 1u);
    EXPECT_EQ(json["grids"][0]["class"], "level set");
    EXPECT_EQ(json["solid"]["cells"], 8);
    EXPECT_EQ(json["solid"]["triangles"], 48);
    EXPECT_NEAR(json["solid"]["volume"].get<double>(), 8, 1e-12);  // sums of eight products
}

TEST_F(CliVoxelize, FogIsOneInEveryVoxelThatIsFilled) {
    for (const std::string levels : {"0", "1", "3"}) {
        const auto json = Json("voxelize cube.vtu -o cube.vdb --kind fog --levels " + levels + kAligned);
        EXPECT_EQ(json["grids"][0]["active_voxels"], 25 * 25 * 25) << levels;
        EXPECT_EQ(json["grids"][0]["least"], 1) << levels;
        EXPECT_EQ(json["grids"][0]["greatest"], 1) << levels;
    }
    // Half of each voxel at the faces where they go through its centre, a quarter at edges, an eighth at corners.
    Json("voxelize cube.vtu -o half.vdb --kind fog --scheme linear-solid --voxel-size 0.1");
    const Voxel::Grids grids = Grids("half.vdb");
    EXPECT_EQ(ValueAt(grids, "density", 10, 0, 0), 0.5);
    EXPECT_EQ(ValueAt(grids, "density", 10, 10, 0), 0.25);
    EXPECT_EQ(ValueAt(grids, "density", -10, 10, -10), 0.125);
}

TEST_F(CliVoxelize, FogAddsUpToTheVolumeOfTheCells) {
    const auto json = Json("voxelize tets.vtu -o fog.vdb --kind fog --resolution 64");
    const double h = json["settings"]["voxel_size"], volume = json["solid"]["volume"];
    const auto low = json["grids"][0]["low"].get<std::array<int, 3>>();
    const auto high = json["grids"][0]["high"].get<std::array<int, 3>>();
    double sum = 0;
    for (double part : Grids("fog.vdb").Values("density", low, high)) sum += part;
    // Thousands of voxels at the boundary, each wrong by less than 1/64 to either side.
    EXPECT_NEAR(sum * h * h * h, volume, 2e-3 * volume);
}

TEST_F(CliVoxelize, AttributesAreThoseOfThePlace) {
    const auto json = Json(
        "voxelize cube.vtu -o cube.vdb --levels 1 --attribute heat --attribute place --attribute jacobian --attribute "
        "cell_id --attribute level" +
        std::string(kAligned));
    const Voxel::Grids grids = Grids("cube.vdb");
    for (const auto& [x, y, z] : {std::array{0, 0, 0}, {12, -7, 3}, {-12, -12, 12}}) {
        EXPECT_NEAR(ValueAt(grids, "heat", x, y, z), 3 + 0.08 * (x + 2 * y - z), kFloat);
        const auto place = grids.Vectors("place", {x, y, z}, {x, y, z});
        EXPECT_NEAR(place[0], 0.08 * x, kFloat);
        EXPECT_NEAR(place[2], 0.08 * z, kFloat);
        EXPECT_NEAR(ValueAt(grids, "jacobian", x, y, z), 1, kFloat);  // cells of side 1
        EXPECT_EQ(ValueAt(grids, "level", x, y, z), 1);
    }
    EXPECT_EQ(ValueAt(grids, "heat", 13, 0, 0), 0);
    EXPECT_EQ(ValueAt(grids, "cell_id", 13, 0, 0), -1);
    std::map<std::string, nlohmann::json> by_name;
    for (const auto& grid : json["grids"]) by_name[grid["name"]] = grid;
    EXPECT_EQ(by_name["cell_id"]["least"], 0);
    EXPECT_EQ(by_name["cell_id"]["greatest"], 7);
    EXPECT_EQ(by_name["place"]["type"], "vec3s");
    EXPECT_EQ(by_name["heat"]["active_voxels"], 25 * 25 * 25);
}

TEST_F(CliVoxelize, OwnDataGoFirst_UnderNamesOfTheirOwn) {
    Io::Mesh mesh = Cube();
    mesh.point_data = {{"density", 1, std::vector<double>(8, 5)}, {"level", 1, std::vector<double>(8, 7)}};
    WriteMesh("named.vtu", mesh);
    const std::string asked = "voxelize named.vtu -o named.vdb --attribute density --attribute level --resolution 8 ";
    EXPECT_THAT(MustRun(asked + "--kind fog").err, HasSubstr("become grid 'point_density'"));
    EXPECT_EQ(ValueAt(Grids("named.vdb"), "point_density", 0, 0, 0), 5);
    EXPECT_EQ(ValueAt(Grids("named.vdb"), "density", 0, 0, 0), 1);
    EXPECT_EQ(ValueAt(Grids("named.vdb"), "point_level", 0, 0, 0), 7);
    MustRun(asked);  // a level set: the same names
    EXPECT_EQ(ValueAt(Grids("named.vdb"), "point_density", 0, 0, 0), 5);
    EXPECT_EQ(Json("info named.vdb")["grids"].size(), 3u);
}

TEST_F(CliVoxelize, OrderOfOptionsAndNumberOfThreadsChangeNothing) {
    const auto a = Json("voxelize tets.vtu -o a.vdb --kind both --attribute jacobian --resolution 40 --levels 1");
    const auto b =
        Json("voxelize --levels 1 --resolution 40 --threads 1 --attribute jacobian -o b.vdb --kind both tets.vtu");
    EXPECT_EQ(a["grids"], b["grids"]);
    for (const char* name : {"surface", "density", "jacobian"}) {
        EXPECT_EQ(Grids("a.vdb").Values(name, {-20, -20, -20}, {40, 40, 40}),
                  Grids("b.vdb").Values(name, {-20, -20, -20}, {40, 40, 40}));
    }
}

TEST_F(CliVoxelize, ResolutionIsOfTheLongestSide) {
    const auto json = Json("voxelize cube.vtu -o cube.vdb --resolution 50 --scheme linear-solid --half-width 2");
    EXPECT_NEAR(json["settings"]["voxel_size"].get<double>(), 0.04, 1e-15);
    EXPECT_NEAR(json["grids"][0]["background"].get<double>(), 0.08, kFloat);
    EXPECT_NEAR(Json("voxelize cube.vtu -o cube.vdb --scheme linear-solid")["settings"]["voxel_size"].get<double>(),
                2.0 / 128, 1e-15);
}

TEST_F(CliVoxelize, ToleranceTakesTheFewestLevels_AndTellsWhatWasMeasured) {
    const auto json = Json("voxelize tets.vtu -o t.vdb --tolerance 0.02 --resolution 32");
    const int level = json["solid"]["level"];
    ASSERT_GE(level, 1);
    EXPECT_LE(json["tolerance"]["error"].get<double>(), 0.02);
    EXPECT_GT(json["tolerance"]["tests"].get<int>(), 100);
    EXPECT_EQ(json["settings"]["limit"], true);
    // A level less is not enough: `sample` at its rate measures so.
    const auto before = Json("sample tets.vtu -o s.ply --rate " + std::to_string(1 << (level - 1)));
    EXPECT_GT(before["error"]["largest"].get<double>(), 0.02);
    const auto at = Json("sample tets.vtu -o s.ply --rate " + std::to_string(1 << level));
    EXPECT_EQ(json["tolerance"]["error"], at["error"]["largest"]);
    // Flat faces need none; what is never reached ends at the most there are, with a word.
    EXPECT_EQ(Json("voxelize cube.vtu -o c.vdb --tolerance 1e-9 --scheme linear-solid")["solid"]["level"], 0);
    if (kIsSanitized) return;  // six levels take ten seconds there
    WriteMesh("one.vtu", OneTet());
    const Outcome never = MustRun("voxelize one.vtu -o n.vdb --tolerance 1e-9 --resolution 8");
    EXPECT_THAT(never.err, HasSubstr("one.vtu: the tolerance of 1e-09 is not reached at level 6"));
    const auto info = Json("info n.vdb");
    EXPECT_EQ(info["grids"][0]["metadata"]["tolerance"], "1e-09");
    EXPECT_GT(std::stod(info["grids"][0]["metadata"]["measured_error"].get<std::string>()), 1e-9);
}

TEST_F(CliVoxelize, HalfNumbersAreCloseAndSmaller) {
    Json("voxelize tets.vtu -o full.vdb --resolution 64");
    Json("voxelize tets.vtu -o half.vdb --resolution 64 --half");
    EXPECT_LT(fs::file_size(folder / "half.vdb"), 0.8 * static_cast<double>(fs::file_size(folder / "full.vdb")));
    const auto a = Grids("full.vdb").Values("surface", {0, 0, 0}, {40, 40, 40});
    const auto b = Grids("half.vdb").Values("surface", {0, 0, 0}, {40, 40, 40});
    double largest = 0, difference = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        largest = std::max(largest, std::abs(a[i]));
        difference = std::max(difference, std::abs(a[i] - b[i]));
    }
    EXPECT_GT(difference, 0);
    EXPECT_LE(difference, largest / 2048);  // eleven bits
}

TEST_F(CliVoxelize, InfoTellsWhatIsInAFile) {
    MustRun("voxelize tets.vtu -o solid.vdb --kind both --attribute cell_id --scheme interpolatory --tension 0.05");
    const auto json = Json("info solid.vdb");
    ASSERT_EQ(json["grids"].size(), 3u);
    for (const auto& grid : json["grids"]) {
        const auto& metadata = grid["metadata"];
        EXPECT_EQ(metadata["scheme"], "interpolatory");
        EXPECT_EQ(metadata["tension"], "0.05");
        EXPECT_EQ(metadata["levels"], "2");
        EXPECT_EQ(metadata["source"], "tets.vtu");
        EXPECT_THAT(metadata["creator"].get<std::string>(), testing::StartsWith("solidsubdiv "));
        EXPECT_GT(grid["active_voxels"].get<int>(), 1000);
        EXPECT_GT(grid["bytes"].get<int>(), 1000);
    }
    const std::string text = MustRun("info solid.vdb").out;
    for (const char* part : {"surface: float, level set, ", "density: float, fog volume, ", "cell_id: int32, ",
                             "scheme interpolatory", "tension 0.05", "source tets.vtu"}) {
        EXPECT_THAT(text, HasSubstr(part));
    }
    EXPECT_THAT(ErrorOf("info solid.vdb --quality", 2), HasSubstr("solid.vdb: --quality"));
    EXPECT_THAT(ErrorOf("info tets.vtu --grid surface", 2), HasSubstr("tets.vtu: --grid"));
    WriteText("junk.vdb", "no grids");
    EXPECT_THAT(ErrorOf("info junk.vdb"), HasSubstr("junk.vdb: can't be read as OpenVDB"));
    EXPECT_THAT(ErrorOf("info nowhere.vdb"), HasSubstr("nowhere.vdb: "));
    const std::string bytes = ReadText(folder / "solid.vdb");
    WriteText("short.vdb", bytes.substr(0, bytes.size() / 2));
    EXPECT_THAT(ErrorOf("info short.vdb"), HasSubstr("short.vdb: can't be read"));
}

TEST_F(CliVoxelize, PicturesOfEveryKindOfGrid) {
    SOLIDSUBDIV_LONG_TEST();
    if (MustRun("info --help").out.find("--picture") == std::string::npos) GTEST_SKIP() << "built without pictures";
    MustRun(
        "voxelize cube.vtu -o cube.vdb --kind both --attribute heat --attribute place --attribute level --resolution "
        "16 --picture all.png");
    const std::vector<std::string> names = {"place", "surface", "density", "heat", "level"};
    for (int i = 0; i < FewerIfSanitized(5); ++i) {
        MustRun("info cube.vdb --picture " + names[i] + ".png --grid " + names[i]);
        EXPECT_GT(fs::file_size(folder / (names[i] + ".png")), 10'000u);  // an empty panel has 3 kB
    }
    EXPECT_THAT(ErrorOf("info cube.vdb --picture x.png --grid cold"),
                HasSubstr("cube.vdb: there is no grid 'cold'; there are "));
}

TEST_F(CliVoxelize, PicturesOfSlicesAtAnyPlace) {
    if (MustRun("info --help").out.find("--slice") == std::string::npos) GTEST_SKIP() << "built without pictures";
    MustRun("voxelize tets.vtu -o tets.vdb --resolution 12 --levels 0");
    const auto picture_at = [&](const std::string& slice) {
        MustRun("info tets.vdb --picture slice.png" + slice);
        return ReadText(folder / "slice.png");
    };
    const std::string middle = picture_at("");
    std::set<std::string> pictures = {middle};
    const std::vector<std::string> places = {"y:0.25", "x:1", "z:1e-1"};
    for (int i = 0; i < FewerIfSanitized(3); ++i) {
        EXPECT_TRUE(pictures.insert(picture_at(" --slice " + places[i])).second) << places[i];
    }
    if (!kIsSanitized) {
        EXPECT_EQ(picture_at(" --slice z:0.5"), middle);
    }
    for (const char* bad : {"w:0.5", "y", "y:", "y0.5", "y:-0.1", "y:1.01", "y:nan", "y:0.5x", ":0.5", "y:0,5"}) {
        EXPECT_THAT(ErrorOf("info tets.vdb --picture x.png --slice " + std::string(bad), 2),
                    HasSubstr("--slice '" + std::string(bad) + "': is not x, y or z with a number from 0 to 1"));
    }
    EXPECT_THAT(ErrorOf("info tets.vdb --slice y:0.5", 2), HasSubstr("--picture"));
    EXPECT_THAT(ErrorOf("info tets.vtu --picture x.png --slice y:0.5", 2), HasSubstr("tets.vtu: --slice"));
}

TEST_F(CliVoxelize, OpenVdbsOwnProgramReadsTheFile) {
    if (std::system("command -v vdb_print >/dev/null 2>&1") != 0) {
        GTEST_SKIP() << "there is no vdb_print (Debian: libopenvdb-tools)";
    }
    MustRun("voxelize cube.vtu -o cube.vdb --kind both --attribute heat" + std::string(kAligned));
    const std::string out = Tool("vdb_print -l cube.vdb");
    for (const char* part : {"surface", "density", "heat", "level set", "fog volume", "cube.vtu", "linear-solid"}) {
        EXPECT_THAT(out, HasSubstr(part));
    }
}

TEST_F(CliVoxelize, OpenVdbsPythonModuleReadsTheFile) {
    // Debian's own Python has its modules; that of the PATH may not.
    if (std::system("/usr/bin/python3 -c 'import pyopenvdb' >/dev/null 2>&1") != 0) {
        GTEST_SKIP() << "/usr/bin/python3 can't import pyopenvdb (Debian: python3-openvdb)";
    }
    for (const std::string half : {"", " --half"}) {
        MustRun("voxelize cube.vtu -o cube.vdb --kind both --attribute heat --attribute place" + half + kAligned);
        WriteText("read.py",
                  "import pyopenvdb as vdb\n"
                  "grids = {g.name: g for g in vdb.readAll('cube.vdb')[0]}\n"
                  "at = lambda name, *voxel: grids[name].getConstAccessor().getValue(voxel)\n"
                  "print(sorted(grids), grids['heat'].activeVoxelCount(), grids['heat'].metadata['scheme'])\n"
                  "print(round(at('surface', 12, 0, 0), 3), at('density', 3, 3, 0), round(at('heat', 5, 0, 0), 2))\n"
                  "print(round(at('place', 5, 0, 0)[0], 2), round(grids['heat'].transform.voxelSize()[0], 9))\n");
        EXPECT_EQ(Tool("/usr/bin/python3 read.py"),
                  "['density', 'heat', 'place', 'surface'] 15625 linear-solid\n-0.04 1.0 3.4\n0.4 0.08\n")
            << half;
    }
}

TEST_F(CliVoxelize, BadSizesAreRefused_WithTheirCount) {
    for (const char* size : {"0", "-1", "nan", "inf", "x", "1x", "-0.0"}) {
        EXPECT_THAT(ErrorOf("voxelize cube.vtu -o out.vdb --voxel-size=" + std::string(size), 2),
                    HasSubstr("is no length above 0"));
        EXPECT_THAT(ErrorOf("voxelize cube.vtu -o out.vdb --tolerance=" + std::string(size), 2),
                    HasSubstr("is no length above 0"));
    }
    for (const char* n : {"0", "-5", "1.5", "nan"}) {
        EXPECT_THAT(ErrorOf("voxelize cube.vtu -o out.vdb --resolution=" + std::string(n), 2),
                    HasSubstr("--resolution"));
    }
    // 2e12 voxels and one more a side.
    const std::string error = ErrorOf("voxelize cube.vtu -o out.vdb --scheme linear-solid --voxel-size 1e-12");
    EXPECT_THAT(error, HasSubstr("cube.vtu: voxels of size 1e-12 make a box of 2e+12 x 2e+12 x 2e+12 = 8e+36 of them"));
    EXPECT_THAT(ErrorOf("voxelize cube.vtu -o out.vdb --resolution 1000000"), HasSubstr("= 1e+18 of them"));
    // Boxes that fit, but not what is inside of them: 1.25e11 voxels of five numbers.
    EXPECT_THAT(ErrorOf("voxelize cube.vtu -o out.vdb --levels 0 --resolution 5000 --attribute heat --attribute place "
                        "--attribute level --scheme linear-solid"),
                HasSubstr("too many (about 2.5"));
    for (const char* width : {"0", "0.5", "101", "nan"}) {
        EXPECT_THAT(ErrorOf("voxelize cube.vtu -o out.vdb --half-width " + std::string(width), 2),
                    HasSubstr("is not from 1 to 100 voxels"));
    }
}

TEST_F(CliVoxelize, WhatCannotBeFilledOrNamedIsRefused) {
    WriteText("surface.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    EXPECT_THAT(ErrorOf("voxelize surface.obj -o out.vdb"),
                HasSubstr("surface.obj: has no cells to fill; name a solid"));
    EXPECT_THAT(ErrorOf("voxelize nowhere.vtu -o out.vdb"), HasSubstr("nowhere.vtu: "));
    EXPECT_THAT(ErrorOf("voxelize cube.vtu -o out.vdb --attribute cold"),
                HasSubstr("no point data 'cold' of 1 or 3 numbers a point; there are heat, place, jacobian, cell_id"));
    EXPECT_THAT(ErrorOf("voxelize cube.vtu -o out.vdb --attribute pair"), HasSubstr("'pair'"));
    EXPECT_THAT(ErrorOf("voxelize cube.vtu -o out.vdb --attribute heat --attribute heat", 2), HasSubstr("twice"));
    EXPECT_THAT(ErrorOf("voxelize cube.vtu -o out.vdb --kind solid", 2), HasSubstr("level-set"));
    EXPECT_THAT(ErrorOf("voxelize cube.vtu -o out.vdb --tolerance 1 --levels 1", 2), HasSubstr("--levels"));
    EXPECT_THAT(ErrorOf("voxelize cube.vtu -o out.vdb --voxel-size 1 --resolution 1", 2), HasSubstr("--resolution"));
    EXPECT_THAT(ErrorOf("voxelize cube.vtu -o out.vdb --scheme loop"), HasSubstr("cube.vtu: has 1 hexahedron"));
    EXPECT_THAT(ErrorOf("voxelize cube.vtu -o out.vtu", 2), HasSubstr("out.vtu: grids are written to .vdb files"));
    EXPECT_THAT(ErrorOf("voxelize cube.vtu -o nowhere/out.vdb"), HasSubstr("no folder nowhere"));
    EXPECT_THAT(ErrorOf("voxelize cube.vtu -o out.vdb --picture nowhere/out.png"), HasSubstr("no folder nowhere"));
    fs::create_directory(folder / "folder.vdb");
    EXPECT_THAT(ErrorOf("voxelize cube.vtu -o folder.vdb"), HasSubstr("folder.vdb: is a directory"));
    EXPECT_THAT(ErrorOf("voxelize cube.vtu -o /dev/null/x.vdb"), HasSubstr("/dev/null/x.vdb: can't be written"));
}

TEST_F(CliVoxelize, SolidsOfMixedDimensionAreFilledWhereTheyHaveCells) {
    Io::Mesh mesh = TetMesh({0, 0, 0, 4, 0, 0, 0, 4, 0, 0, 0, 4, 9, 0, 0, 9, 4, 0, 9, 0, 4}, {0, 1, 2, 3});
    mesh.topology.triangles = {4, 5, 6};
    mesh.cell_data = {{"hole", 1, {0, 1}}};
    WriteMesh("mixed.vtu", mesh);
    const auto json = Json("voxelize mixed.vtu -o mixed.vdb --scheme linear-solid --voxel-size 0.25 --kind fog");
    EXPECT_NEAR(json["solid"]["volume"].get<double>(), 32.0 / 3, 1e-12);
    EXPECT_LE(json["grids"][0]["high"][0].get<int>(), 16);
}

}  // namespace
}  // namespace SolidSubdiv::CliTesting
