// SPDX-License-Identifier: Apache-2.0
// Free-form deformation through the program: results, sequences, embeddings, normals, what is refused.
#include <cmath>
#include <cstdio>

#include "apps/cli_testing.h"

namespace SolidSubdiv::CliTesting {
namespace {

using testing::HasSubstr;

/// A block of n^3 hexahedra over [-1, 1]^3.
Io::Mesh Block(int n) {
    Io::Mesh mesh;
    const int m = n + 1;
    mesh.topology.n_vertices = m * m * m;
    for (int i = 0; i < m * m * m; ++i) {
        for (int c : {i % m, i / m % m, i / m / m}) mesh.positions.push_back(2.0 * c / n - 1);
    }
    const auto id = [&](int x, int y, int z) { return x + m * (y + m * z); };
    for (int i = 0; i < n * n * n; ++i) {
        const int x = i % n, y = i / n % n, z = i / n / n;
        mesh.topology.hexes.insert(mesh.topology.hexes.end(),
                                   {id(x, y, z), id(x + 1, y, z), id(x + 1, y + 1, z), id(x, y + 1, z), id(x, y, z + 1),
                                    id(x + 1, y, z + 1), id(x + 1, y + 1, z + 1), id(x, y + 1, z + 1)});
    }
    return mesh;
}

/// A tent of four triangles with an attribute and normals; its top is at (0, 0, 0.5), outside are none.
Io::Mesh Tent() {
    Io::Mesh mesh;
    mesh.topology.n_vertices = 5;
    mesh.positions = {-.5, -.5, 0, .5, -.5, 0, .5, .5, 0, -.5, .5, 0, 0, 0, .5};
    mesh.topology.triangles = {0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4};
    mesh.point_data = {{"heat", 1, {1, 2, 3, 4, 5}},
                       {"Normals", 3, {-.6, 0, .8, .6, 0, .8, 0, .6, .8, 0, -.6, .8, 0, 0, 1}}};
    mesh.cell_data = {{"region", 1, {7, 8, 9, 10}}};
    return mesh;
}

class CliDeform : public CliTest {
  protected:
    void SetUp() override {
        CliTest::SetUp();
        WriteMesh("model.vtu", Tent());
        WriteMesh("l0.vtu", Block(2));
        Io::Mesh sheared = Block(2);
        for (std::size_t i = 0; i < sheared.positions.size(); i += 3) {
            sheared.positions[i] += 0.5 * sheared.positions[i + 2];
            sheared.positions[i + 1] *= 2;
        }
        WriteMesh("sheared.vtu", sheared);
        Io::Mesh bulged = Block(2);
        bulged.positions[3 * 13 + 2] += 0.25;  // the middle point
        WriteMesh("bulged.vtu", bulged);
    }
};

TEST_F(CliDeform, AffineMapsOfTheLattice_AreThoseOfTheModelAndItsNormals) {
    const auto json = Json("deform model.vtu --lattice l0.vtu --to sheared.vtu -o out.vtu");
    const Io::Mesh in = Tent(), out = ReadMesh("out.vtu");
    const auto& normals = in.FindPointData("Normals")->values;
    const auto& turned = out.FindPointData("Normals")->values;
    for (std::size_t i = 0; i < 15; i += 3) {
        EXPECT_NEAR(out.positions[i], in.positions[i] + 0.5 * in.positions[i + 2], 1e-14);
        EXPECT_NEAR(out.positions[i + 1], 2 * in.positions[i + 1], 1e-14);
        EXPECT_NEAR(out.positions[i + 2], in.positions[i + 2], 1e-14);
        // By the transposed inverse; tangents are differences over 1e-5 of the size: ten digits are left.
        double n[3] = {normals[i], normals[i + 1] / 2, normals[i + 2] - 0.5 * normals[i]};
        const double length = std::hypot(n[0], n[1], n[2]);
        for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(turned[i + c], n[c] / length, 1e-9);
    }
    EXPECT_EQ(out.FindPointData("heat")->values, in.FindPointData("heat")->values);
    EXPECT_EQ(out.FindCellData("region")->values, in.FindCellData("region")->values);
    EXPECT_EQ(out.topology.triangles, in.topology.triangles);
    EXPECT_EQ(json["outside"]["count"], 0);
    EXPECT_EQ(json["settings"]["scheme"], "catmull-clark-solid");
    EXPECT_NEAR(json["states"][0]["largest_move"]["distance"].get<double>(), 0.5, 1e-14);
}

TEST_F(CliDeform, TheMiddleOfABlock_MovesByTheTricubicWeight) {
    // In the limit a control point weighs (4/6)^3 at its place; the tent's top is not there, a vertex there is.
    WriteText("middle.obj", "v 0 0 0\nv .1 0 0\nv 0 .1 0\nf 1 2 3\n");
    MustRun("deform middle.obj --lattice l0.vtu --to bulged.vtu -o out.obj --limit");
    EXPECT_NEAR(ReadMesh("out.obj").positions[2], 0.25 * 8 / 27, 1e-14);
}

TEST_F(CliDeform, ObjFilesKeepAllElse_AndTheirNormalsTurn) {
    WriteText("in.obj",
              "mtllib m.mtl\nv 0 0 0\nv .1 0 0\nv 0 .1 0\nvt 0 0\nvn 1 0 0\nusemtl skin\nf 1/1/1 2/1/1 3/1/1\n");
    EXPECT_EQ(MustRun("deform in.obj --lattice l0.vtu --to sheared.vtu -o out.obj").err, "");
    const std::string out = ReadText(folder / "out.obj");
    EXPECT_THAT(out, HasSubstr("mtllib m.mtl\n"));
    EXPECT_THAT(out, HasSubstr("usemtl skin\n"));
    EXPECT_THAT(out, HasSubstr("f 1/1/1 2/1/2 3/1/3\n"));
    double n[3] = {};
    ASSERT_EQ(std::sscanf(out.c_str() + out.find("vn "), "vn %lf %lf %lf", &n[0], &n[1], &n[2]), 3);
    // By the transposed inverse of x + z / 2.
    EXPECT_NEAR(n[0], 1 / std::hypot(1, 0.5), 1e-9);
    EXPECT_NEAR(n[2], -0.5 / std::hypot(1, 0.5), 1e-9);
    EXPECT_THAT(MustRun("deform in.obj --lattice l0.vtu --to sheared.vtu -o out.ply").err, HasSubstr("not kept"));
}

TEST_F(CliDeform, SequencesAreNumbered_AndEmbeddingsGiveTheSame) {
    MustRun("deform model.vtu --lattice l0.vtu --to sheared.vtu bulged.vtu -o walk.vtu --save-embedding model.embed");
    MustRun("deform model.vtu --embedding model.embed --to bulged.vtu -o out.vtu");
    EXPECT_EQ(ReadMesh("walk_0002.vtu").positions, ReadMesh("out.vtu").positions);
    EXPECT_NE(ReadMesh("walk_0001.vtu").positions, ReadMesh("out.vtu").positions);
    EXPECT_EQ(Names().count("walk.vtu"), 0u);
    const auto only = Json("deform model.vtu --lattice l0.vtu --save-embedding again.embed");
    EXPECT_EQ(ReadText(folder / "again.embed"), ReadText(folder / "model.embed"));
    EXPECT_EQ(only["outputs"].size(), 1u);
}

TEST_F(CliDeform, VerticesOutside_AreNamedAndDoAsAsked) {
    WriteText("long.obj", "v 0 0 0\nv 1.5 0 0\nv 5 0 0\nf 1 2 3\n");
    const auto moved_x = [&](const std::string& options) {
        const auto json = Json("deform long.obj --lattice l0.vtu --to sheared.vtu -o out.obj " + options);
        EXPECT_EQ(json["outside"]["count"], 2);
        EXPECT_EQ(json["outside"]["vertices"][1]["vertex"], 2);
        EXPECT_NEAR(json["outside"]["farthest"].get<double>(), 4, 1e-12);
        return ReadMesh("out.obj").positions;
    };
    const std::string note = MustRun("deform long.obj --lattice l0.vtu --to l0.vtu -o out.obj").err;
    EXPECT_THAT(note, HasSubstr("2 vertices lie outside the lattice, at most 4 away (--outside carry): 1, 2"));
    EXPECT_EQ(moved_x("--outside leave")[3], 1.5);
    WriteMesh("sheared.vtu", [] {
        Io::Mesh shifted = Block(2);
        for (std::size_t i = 0; i < shifted.positions.size(); i += 3) shifted.positions[i] *= 3;
        return shifted;
    }());
    EXPECT_NEAR(moved_x("--outside clamp")[3], 3.5, 1e-12);                // with the face at 1, which moves by 2
    EXPECT_NEAR(moved_x("--outside carry --falloff inf")[3], 4.5, 1e-12);  // as the affine map has it
    const double factor = (1 - 0.25 * 0.25) * (1 - 0.25 * 0.25);           // at a distance of 0.5 of 2
    EXPECT_NEAR(moved_x("--falloff 2")[3], 1.5 + 3 * factor, 1e-12);
    EXPECT_EQ(moved_x("--falloff 2")[6], 5);
}

TEST_F(CliDeform, FoldedLattices_AreReportedWithTheirCells) {
    Io::Mesh folded = Block(2);
    folded.positions[0] = 3;  // a corner of the first cell, through it
    WriteMesh("folded.vtu", folded);
    const Outcome outcome = MustRun("deform model.vtu --lattice l0.vtu --to folded.vtu -o out.vtu --json r.json");
    EXPECT_THAT(outcome.err, HasSubstr("folded.vtu: 1 cell is folded or inverted: 0"));
    EXPECT_EQ(nlohmann::json::parse(ReadText(folder / "r.json"))["states"][0]["folded"].dump(), "[0]");
}

TEST_F(CliDeform, SolidsAndSchemesOfTets) {
    WriteMesh("tets.vtu", TwentyEightTets());
    Io::Mesh moved = TwentyEightTets();
    for (double& x : moved.positions) x *= 2;
    WriteMesh("moved.vtu", moved);
    WriteMesh("solid.vtu", TetMesh({.4, .4, .4, 1, .5, .5, .5, 1, .5, .5, .5, 1}, {0, 1, 2, 3}));
    for (const std::string scheme : {"box-spline", "smooth-tet", "interpolatory", "linear-solid", "mlca"}) {
        MustRun("deform solid.vtu --lattice tets.vtu --to moved.vtu -o out.vtu --scheme " + scheme);
        EXPECT_NEAR(ReadMesh("out.vtu").positions[3], 2, 1e-13) << scheme;
        EXPECT_EQ(ReadMesh("out.vtu").topology.n_tets(), 1);
    }
}

TEST_F(CliDeform, DraggedVertices_GoWhereTheyShould) {
    WriteText("drag.txt", "# the top\n4 0 0.1 0.75\n0 -.5 -.5 0 2.5\n");
    const auto json = Json("deform model.vtu --lattice l0.vtu --drag drag.txt -o out.vtu --save-lattice moved.vtu");
    EXPECT_NEAR(ReadMesh("out.vtu").positions[13], 0.1, 1e-9);
    EXPECT_NEAR(ReadMesh("out.vtu").positions[14], 0.75, 1e-9);
    EXPECT_TRUE(json["states"][0]["drag"]["is_consistent"]);
    EXPECT_EQ(json["states"][0]["drag"]["targets"], 2);
    MustRun("deform model.vtu --lattice l0.vtu --to moved.vtu -o again.vtu");
    EXPECT_EQ(ReadMesh("again.vtu").positions, ReadMesh("out.vtu").positions);

    const std::string all = "0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20 21 22 23 24 25 26";
    const Outcome locked = MustRun("deform model.vtu --lattice l0.vtu --drag drag.txt -o out.vtu --lock " + all);
    EXPECT_THAT(locked.err, HasSubstr("no control point moves 2 vertices: 0, 4"));
    EXPECT_EQ(ReadMesh("out.vtu").positions[14], 0.5);

    WriteText("cube.obj",
              "v -.5 -.5 -.5\nv .5 -.5 -.5\nv .5 .5 -.5\nv -.5 .5 -.5\nv -.5 -.5 .5\nv .5 -.5 .5\nv .5 .5 .5\nv -.5 .5 "
              ".5\nf 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n");
    WriteText("pull.txt", "6 .8 .7 .9\n");
    const auto kept = Json("deform cube.obj --lattice l0.vtu --drag pull.txt -o out.obj --preserve-volume");
    EXPECT_NEAR(kept["states"][0]["drag"]["volume_after"].get<double>(), 1, 1e-9);
    EXPECT_NEAR(ReadMesh("out.obj").positions[18], 0.8, 1e-9);
}

TEST_F(CliDeform, BadDrags_AreRefusedWithTheirLine) {
    const auto error = [&](const std::string& text) {
        WriteText("drag.txt", text);
        return ErrorOf("deform model.vtu --lattice l0.vtu --drag drag.txt -o out.vtu");
    };
    EXPECT_THAT(error(""), HasSubstr("drag.txt: has no targets"));
    EXPECT_THAT(error("# nothing\n\n"), HasSubstr("has no targets"));
    EXPECT_THAT(error("0 0 0 0\n5 0 0 0\n"), HasSubstr("line 2: there is no vertex 5; the model has 5"));
    EXPECT_THAT(error("-1 0 0 0\n"), HasSubstr("no vertex -1"));
    EXPECT_THAT(error("0 0 0\n"), HasSubstr("three coordinates"));
    EXPECT_THAT(error("0 0 0 x\n"), HasSubstr("three coordinates"));
    EXPECT_THAT(error("0 0 0 0 0\n"), HasSubstr("above 0"));
    EXPECT_THAT(error("0 0 0 0 1 1\n"), HasSubstr("nothing may follow"));
    EXPECT_THAT(error("0 0 0 nan\n"), HasSubstr("drag.txt: "));
    EXPECT_THAT(ErrorOf("deform model.vtu --lattice l0.vtu --drag nowhere.txt -o out.vtu"), HasSubstr("nowhere.txt"));
    WriteText("drag.txt", "0 0 0 0\n");
    EXPECT_THAT(ErrorOf("deform model.vtu --lattice l0.vtu --drag drag.txt --lock 99 -o out.vtu"), HasSubstr("99"));
    EXPECT_THAT(ErrorOf("deform model.vtu --lattice l0.vtu --drag drag.txt --to l0.vtu -o out.vtu", 2),
                HasSubstr("--drag"));
}

TEST_F(CliDeform, BadUsage_IsRefused) {
    EXPECT_THAT(ErrorOf("deform model.vtu --to l0.vtu -o out.vtu", 2), HasSubstr("--lattice"));
    EXPECT_THAT(ErrorOf("deform model.vtu --lattice l0.vtu", 2), HasSubstr("nothing to do"));
    EXPECT_THAT(ErrorOf("deform model.vtu --lattice l0.vtu --to l0.vtu", 2), HasSubstr("-o"));
    EXPECT_THAT(ErrorOf("deform model.vtu --lattice l0.vtu -o out.vtu", 2), HasSubstr("--to"));
    EXPECT_THAT(ErrorOf("deform model.vtu --lattice l0.vtu --to l0.vtu -o out.xyz9", 2), HasSubstr("out.xyz9"));
    EXPECT_THAT(ErrorOf("deform model.vtu --lattice l0.vtu --to l0.vtu -o out.vtu --falloff -1", 2),
                HasSubstr("no distance above 0"));
    EXPECT_THAT(ErrorOf("deform model.vtu --lattice l0.vtu --to l0.vtu -o out.vtu --outside fly", 2),
                HasSubstr("carry"));
    EXPECT_THAT(ErrorOf("deform model.vtu --lattice l0.vtu --embedding e --to l0.vtu -o out.vtu", 2),
                HasSubstr("--embedding"));
    EXPECT_THAT(ErrorOf("deform model.vtu --embedding e --scheme mlca --to l0.vtu -o out.vtu", 2), HasSubstr("scheme"));
}

TEST_F(CliDeform, BadInput_IsRefusedWithOneLine) {
    WriteMesh("larger.vtu", Block(3));
    EXPECT_THAT(ErrorOf("deform model.vtu --lattice l0.vtu --to larger.vtu -o out.vtu"),
                HasSubstr("larger.vtu: has 64 control points, l0.vtu 27; a moved lattice keeps its cells"));
    Io::Mesh other = Block(2);
    std::swap(other.topology.hexes[8], other.topology.hexes[9]);
    WriteMesh("other.vtu", other);
    EXPECT_THAT(ErrorOf("deform model.vtu --lattice l0.vtu --to other.vtu -o out.vtu"),
                HasSubstr("other.vtu: hexahedron 1 has other vertices than in l0.vtu"));
    Io::Mesh fewer = Block(2);
    fewer.topology.hexes.resize(8 * 7);
    WriteMesh("fewer.vtu", fewer);
    EXPECT_THAT(ErrorOf("deform model.vtu --lattice l0.vtu --to fewer.vtu -o out.vtu"),
                HasSubstr("fewer.vtu: has 7 hexahedra, l0.vtu 8"));
    EXPECT_THAT(ErrorOf("deform model.vtu --lattice model.vtu --to model.vtu -o out.vtu"), HasSubstr("no cells"));
    EXPECT_THAT(ErrorOf("deform model.vtu --lattice l0.vtu --to nowhere.vtu -o out.vtu"), HasSubstr("nowhere.vtu"));
    EXPECT_THAT(ErrorOf("deform model.vtu --lattice l0.vtu --scheme loop --to l0.vtu -o out.vtu"),
                HasSubstr("l0.vtu: has 8 hexahedra"));
    WriteText("bad.embed", "SSDEMBED and more than that, but no tables");
    EXPECT_THAT(ErrorOf("deform model.vtu --embedding bad.embed --to l0.vtu -o out.vtu"), HasSubstr("bad.embed: "));
    MustRun("deform model.vtu --lattice l0.vtu --save-embedding model.embed");
    WriteText("short.obj", "v 0 0 0\nv .1 0 0\nv 0 .1 0\nf 1 2 3\n");
    EXPECT_THAT(ErrorOf("deform short.obj --embedding model.embed --to l0.vtu -o out.obj"),
                HasSubstr("model.embed: holds 5 points, short.obj has 3 vertices"));
    EXPECT_THAT(ErrorOf("deform model.vtu --embedding model.embed --to larger.vtu -o out.vtu"),
                HasSubstr("64 control points"));
    WriteMesh("solid.vtu", Block(1));
    EXPECT_THAT(ErrorOf("deform solid.vtu --lattice l0.vtu --to l0.vtu -o out.obj"), HasSubstr("can't hold the cells"));
}

}  // namespace
}  // namespace SolidSubdiv::CliTesting
