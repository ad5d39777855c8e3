// SPDX-License-Identifier: Apache-2.0
// Lattices around models through the program: kinds, hierarchies, local splits, odd models, what is refused.
#include <solidsubdiv/kit/geometry/cell_volume.h>

#include <cmath>
#include <numeric>

#include "apps/cli_testing.h"

namespace SolidSubdiv::CliTesting {
namespace {

using testing::HasSubstr;

/// A sphere of latitudes and longitudes, radius 1.
std::string Sphere() {
    std::string text;
    const int n = 24, m = 12;
    const double pi = std::acos(-1.0);
    for (int i = 0; i <= m; ++i) {
        for (int j = 0; j < n; ++j) {
            const double a = pi * i / m, b = 2 * pi * j / n;
            text += "v " + std::to_string(std::sin(a) * std::cos(b)) + " " + std::to_string(std::sin(a) * std::sin(b)) +
                    " " + std::to_string(std::cos(a)) + "\n";
        }
    }
    for (int i = 0; i < m; ++i) {
        for (int j = 0; j < n; ++j) {
            const int a = i * n + j + 1, b = i * n + (j + 1) % n + 1;
            text += "f " + std::to_string(a) + " " + std::to_string(b) + " " + std::to_string(b + n) + " " +
                    std::to_string(a + n) + "\n";
        }
    }
    return text;
}

class CliLattice : public CliTest {
  protected:
    void SetUp() override {
        CliTest::SetUp();
        WriteText("sphere.obj", Sphere());
    }
    /// Positive cells, in all of this volume.
    void ExpectVolume(const std::string& file, double expected) const {
        const Io::Mesh mesh = ReadMesh(file);
        double volume = 0;
        for (double v : Geometry::CellVolumes(mesh.topology, mesh.positions)) {
            EXPECT_GT(v, 0) << file;
            volume += v;
        }
        EXPECT_NEAR(volume, expected, 1e-9 * expected) << file;
    }
};

TEST_F(CliLattice, OfOneCell_HasThePublishedCounts) {
    // ono2002ffd, table 1; the last, 32768, is the validator's.
    const auto json = Json("lattice sphere.obj -o all.vtu --cut none --levels 4");
    std::vector<int> cells;
    for (const auto& level : json["levels"]) cells.push_back(level["cells"]);
    EXPECT_EQ(cells, (std::vector<int>{1, 8, 64, 512, 4096}));
    ExpectVolume("all.vtu", 8);
}

TEST_F(CliLattice, EveryKindHoldsTheModel) {
    for (const std::string kind : {"octree", "shrink --offset 0.02", "tet"}) {
        for (const std::string box : {"aabb", "obb", "minimum"}) {
            MustRun("lattice sphere.obj -o l.vtu --levels 3 --kind " + kind + " --box " + box);
            // At level 0 each cell is what it is; later the border of a smooth scheme draws in at dents.
            const auto json = Json("deform sphere.obj --lattice l.vtu --to l.vtu -o same.obj --levels 0");
            EXPECT_EQ(json["outside"]["count"], 0) << kind << " " << box;
            EXPECT_LT(json["states"][0]["largest_move"]["distance"], 1e-14);
            EXPECT_EQ(json["lattice"]["folded"].size(), 0u);
        }
    }
}

TEST_F(CliLattice, HierarchiesSayWhoseChildrenCellsAndPointsAre) {
    fs::create_directory(folder / "h");
    MustRun("lattice sphere.obj --hierarchy h --levels 3 -o last.vtu");
    const auto json = nlohmann::json::parse(ReadText(folder / "h/hierarchy.json"));
    ASSERT_EQ(json["levels"].size(), 4u);
    EXPECT_EQ(ReadText(folder / "h/level3.vtu"), ReadText(folder / "last.vtu"));
    for (std::size_t i = 1; i < 4; ++i) {
        const Io::Mesh coarse = ReadMesh("h/" + json["levels"][i - 1]["file"].get<std::string>());
        const Io::Mesh fine = ReadMesh("h/" + json["levels"][i]["file"].get<std::string>());
        const auto& points = json["levels"][i]["parent_points"];
        ASSERT_EQ(points.size(), static_cast<std::size_t>(fine.topology.n_vertices));
        for (std::size_t p = 0; p < points.size(); ++p) {
            for (std::size_t c = 0; c < 3; ++c) {
                double mean = 0;
                for (const auto& parent : points[p]) mean += coarse.positions[3 * parent.get<std::size_t>() + c];
                EXPECT_NEAR(fine.positions[3 * p + c], mean / static_cast<double>(points[p].size()), 1e-14);
            }
        }
        const auto parents = json["levels"][i]["parent_cells"].get<std::vector<double>>();
        EXPECT_EQ(fine.FindCellData("parent")->values, parents);
        EXPECT_LT(*std::max_element(parents.begin(), parents.end()), static_cast<double>(coarse.topology.n_hexes()));
    }
}

TEST_F(CliLattice, ChosenCellsAreSplit_AndTheResultIsALattice) {
    MustRun("lattice sphere.obj -o split.vtu --levels 1 --split 0 7");
    EXPECT_GT(ReadMesh("split.vtu").topology.n_polyhedra(), 0);
    ExpectVolume("split.vtu", 8);
    const auto json = Json("lattice sphere.obj -o split.vtu --levels 1 --split-region 0 0 0 1 1 1");
    EXPECT_EQ(json["settings"]["split"].size(), 1u);
    EXPECT_EQ(json["levels"][2]["cells"], 7 + 8);
    MustRun("deform sphere.obj --lattice split.vtu --to split.vtu -o same.obj");
    EXPECT_THAT(ErrorOf("lattice sphere.obj -o split.vtu --levels 1 --split 8"), HasSubstr("8"));
    EXPECT_THAT(ErrorOf("lattice sphere.obj -o split.vtu --split-region 5 5 5 6 6 6"), HasSubstr("--split-region"));
}

TEST_F(CliLattice, ARegionTakesAPartOfTheModel) {
    MustRun("lattice sphere.obj -o part.vtu --levels 1 --cut none --region 0 -1 -1 1 1 1");
    ExpectVolume("part.vtu", 4);
    const auto json = Json("deform sphere.obj --lattice part.vtu --to part.vtu -o same.obj --outside leave");
    EXPECT_GT(json["outside"]["count"], 0);
}

TEST_F(CliLattice, TetsFillClosedModels_WithOctahedraInside) {
    const auto json = Json("lattice sphere.obj -o tets.vtu --kind tet --levels 4");
    EXPECT_EQ(json["settings"]["cut"], "outside");
    const auto skin = Json("lattice sphere.obj -o skin.vtu --kind tet --levels 4 --cut vertices");
    EXPECT_EQ(skin["tet_lattice"]["octahedra"], 0);
    // One at least around every odd corner of the grid that is in the model, whose faces are .98 away from its middle.
    int n_odd_inside = 0;
    for (int i = 0; i < 17 * 17 * 17; ++i) {
        const int x = i % 17 - 8, y = i / 17 % 17 - 8, z = i / 289 - 8;
        n_odd_inside += (x + y + z) % 2 != 0 && std::hypot(x, y, z) / 8 < .98;
    }
    EXPECT_GE(json["tet_lattice"]["octahedra"], n_odd_inside);
    EXPECT_EQ(ReadMesh("tets.vtu").topology.n_octs(), json["tet_lattice"]["octahedra"]);
    // Bricks are the same without tets, and only if asked for.
    EXPECT_EQ(Json("lattice sphere.obj -o all.vtu --levels 4 --cut outside")["levels"], json["levels"]);
    EXPECT_EQ(Json("lattice sphere.obj -o all.vtu --levels 4")["levels"], skin["levels"]);
    EXPECT_EQ(Json("lattice sphere.obj -o all.vtu --levels 4")["settings"]["cut"], "vertices");
}

TEST_F(CliLattice, AFilledLatticeFollowsWithItsInside) {
    MustRun("lattice sphere.obj -o rest.vtu --levels 4 --cut outside");
    WriteText("middle.obj", "v 0 0 0\nv .3 .2 .1\np 1 2\n");
    EXPECT_EQ(Json("deform middle.obj --lattice rest.vtu --to rest.vtu -o same.obj --levels 0")["outside"]["count"], 0);
    MustRun("lattice sphere.obj -o skin.vtu --levels 4 --cut triangles");
    EXPECT_EQ(Json("deform middle.obj --lattice skin.vtu --to skin.vtu -o same.obj --levels 0")["outside"]["count"], 2);
}

TEST_F(CliLattice, OddModelsHaveLattices) {
    WriteText("point.obj", "v 3 4 5\np 1\n");
    WriteText("line.obj", "v 0 0 0\nv 1 2 3\nl 1 2\n");
    WriteText("flat.obj", "v 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\nf 1 2 3 4\n");
    WriteText("loose.obj", Sphere() + "v 9 9 9\nv 9 9 10\nf 1 2 30\nf 1 2 40\n");  // non-manifold, open, a far point
    for (const std::string model : {"point", "line", "flat", "loose"}) {
        for (const std::string options :
             {"", " --cut triangles --box obb", " --kind shrink --box minimum", " --kind tet"}) {
            MustRun("lattice " + model + ".obj -o l.vtu --levels 2" + options);
            const auto json = Json("deform " + model + ".obj --lattice l.vtu --to l.vtu -o same.obj --levels 0");
            EXPECT_EQ(json["outside"]["count"], 0) << model << options;
        }
    }
}

TEST_F(CliLattice, BadUsageAndInput_AreRefused) {
    EXPECT_THAT(ErrorOf("lattice sphere.obj", 2), HasSubstr("-o"));
    EXPECT_THAT(ErrorOf("lattice sphere.obj -o l.obj", 2), HasSubstr("l.obj"));
    EXPECT_THAT(ErrorOf("lattice sphere.obj --hierarchy nowhere", 2), HasSubstr("no such folder"));
    EXPECT_THAT(ErrorOf("lattice sphere.obj -o l.vtu --levels 11", 2), HasSubstr("--levels"));
    EXPECT_THAT(ErrorOf("lattice sphere.obj -o l.vtu --kind ball", 2), HasSubstr("octree"));
    EXPECT_THAT(ErrorOf("lattice sphere.obj -o l.vtu --offset 1", 2), HasSubstr("--padding"));
    EXPECT_THAT(ErrorOf("lattice sphere.obj -o l.vtu --padding -1", 2), HasSubstr("no distance"));
    EXPECT_THAT(ErrorOf("lattice sphere.obj -o l.vtu --region 1 1 1 0 0 0", 2), HasSubstr("low corner"));
    EXPECT_THAT(ErrorOf("lattice sphere.obj -o l.vtu --region 1 1 1", 2), HasSubstr("--region"));
    EXPECT_THAT(ErrorOf("lattice sphere.obj -o l.vtu --kind tet --split 0", 2), HasSubstr("--split"));
    EXPECT_THAT(ErrorOf("lattice sphere.obj -o l.vtu --region 5 5 5 6 6 6"), HasSubstr("sphere.obj: "));
    EXPECT_THAT(ErrorOf("lattice sphere.obj -o l.vtu --cut none --levels 10"), HasSubstr("sphere.obj: "));
    WriteText("empty.obj", "# nothing\n");
    EXPECT_THAT(ErrorOf("lattice empty.obj -o l.vtu"), HasSubstr("empty.obj: "));
}

}  // namespace
}  // namespace SolidSubdiv::CliTesting
