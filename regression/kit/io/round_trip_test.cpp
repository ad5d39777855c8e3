// SPDX-License-Identifier: Apache-2.0
// What is written in any format is read back the same: every index and every number, exactly.
#include <algorithm>

#include "kit/io/support.h"

namespace SolidSubdiv::Io {
namespace {

struct Case {
    std::string name;
    std::string extension;
    std::string kinds;  // as in MeshOf
    WriteOptions options;
};

class RoundTrip : public testing::TestWithParam<Case> {
  protected:
    Mesh Through(const Mesh& mesh, const std::string& name = "mesh") {
        const auto path = folder_ / (name + GetParam().extension);
        WriteMesh(path, mesh, GetParam().options);
        return ReadMesh(path);
    }
    /// PLY has no way to write a blank in a name.
    Mesh Sample(const std::string& kinds) const {
        Mesh mesh = MeshOf(kinds);
        if (GetParam().extension == ".ply") mesh.point_data[1].name = "flow";
        return mesh;
    }
    TemporaryFolder folder_;
};

TEST_P(RoundTrip, AllKindsAndAttributesComeBackExactly) {
    const Mesh mesh = Sample(GetParam().kinds);
    ExpectSameMesh(Through(mesh), mesh);
}

TEST_P(RoundTrip, EachKindAloneComesBackExactly) {
    for (const char kind : GetParam().kinds) {
        SCOPED_TRACE(kind);
        const Mesh mesh = Sample({kind});
        ExpectSameMesh(Through(mesh), mesh);
    }
}

TEST_P(RoundTrip, MeshWithoutAttributesComesBackExactly) {
    Mesh mesh = Sample(GetParam().kinds);
    mesh.point_data.clear();
    mesh.cell_data.clear();
    ExpectSameMesh(Through(mesh), mesh);
}

TEST_P(RoundTrip, WritingTwiceGivesTheSameBytes) {
    const Mesh mesh = Sample(GetParam().kinds);
    const Mesh again = Through(mesh, "first");
    WriteMesh(folder_ / ("second" + GetParam().extension), again, GetParam().options);
    EXPECT_EQ(Load(folder_ / ("first" + GetParam().extension)), Load(folder_ / ("second" + GetParam().extension)));
}

TEST_P(RoundTrip, NothingButTheMeshIsLeftInTheFolder) {
    Through(Sample(GetParam().kinds));
    const bool two_files = GetParam().extension == ".ele" || GetParam().extension == ".node";
    EXPECT_EQ(folder_.Files().size(), two_files ? 2u : 1u);
}

const WriteOptions kBinary = {.keep_octahedra = true, .binary = true};
const WriteOptions kText = {.keep_octahedra = true, .binary = false};

INSTANTIATE_TEST_SUITE_P(
    Formats, RoundTrip,
    testing::Values(Case{"VtuBinary", ".vtu", "tohwypTQPEV", kBinary}, Case{"VtuText", ".vtu", "tohwypTQPEV", kText},
                    Case{"VtkBinary", ".vtk", "tohwypTQPEV", kBinary}, Case{"VtkText", ".vtk", "tohwypTQPEV", kText},
                    Case{"Gmsh", ".msh", "thwyTQEV", kText}, Case{"TetgenEle", ".ele", "t", kText},
                    Case{"TetgenNode", ".node", "t", kText}, Case{"PlyBinary", ".ply", "TQPE", kBinary},
                    Case{"PlyText", ".ply", "TQPE", kText}),
    [](const auto& c) { return c.param.name; });

TEST(RoundTripObj, GeometryComesBackExactly) {
    TemporaryFolder folder;
    Mesh mesh = MeshOf("TQPEV");
    mesh.point_data.clear();
    mesh.cell_data.clear();
    WriteMesh(folder / "mesh.obj", mesh);
    ExpectSameMesh(ReadMesh(folder / "mesh.obj"), mesh);
}

TEST(RoundTripObj, ColorsOfVerticesComeBackExactly) {
    TemporaryFolder folder;
    Mesh mesh = MeshOf("T");
    mesh.cell_data.clear();
    mesh.point_data = {{"color", 3, {}}};
    for (int i = 0; i < 36; ++i) mesh.point_data[0].values.push_back(i / 36.0);
    WriteMesh(folder / "mesh.obj", mesh);
    ExpectSameMesh(ReadMesh(folder / "mesh.obj"), mesh);
}

TEST(RoundTripMedit, GeometryAndReferencesComeBackExactly) {
    TemporaryFolder folder;
    Mesh mesh = MeshOf("thwyTQE");
    mesh.point_data = {{"reference", 1, {}}};
    for (int i = 0; i < 12; ++i) mesh.point_data[0].values.push_back(i - 3);
    mesh.cell_data = {{"reference", 1, {}}};
    for (int i = 0; i < mesh.topology.n_elements(); ++i) mesh.cell_data[0].values.push_back(100 + i);
    WriteMesh(folder / "mesh.mesh", mesh);
    ExpectSameMesh(ReadMesh(folder / "mesh.mesh"), mesh);
}

TEST(RoundTripGmsh, LabelsAreElementTagsAndComeBackExactly) {
    TemporaryFolder folder;
    Mesh mesh = MeshOf("tT");
    mesh.point_data.clear();
    mesh.cell_data = {{"physical", 1, {1, 2, 3, 4, 0}}, {"elementary", 1, {9, 8, 7, 6, 5}}};
    WriteMesh(folder / "mesh.msh", mesh);
    EXPECT_THAT(Load(folder / "mesh.msh"), testing::HasSubstr("\n1 4 2 1 9 1 2 3 4\n"));
    ExpectSameMesh(ReadMesh(folder / "mesh.msh"), mesh);
}

/// STL keeps triangles by their corners' places; with binary floats if the numbers are floats.
TEST(RoundTripStl, TrianglesComeBackExactly) {
    TemporaryFolder folder;
    for (const bool binary : {false, true}) {
        Mesh mesh = MeshOf("T");
        mesh.point_data.clear();
        mesh.cell_data.clear();
        mesh.topology.n_vertices = 4;  // in the order of first use
        mesh.positions = {0, 0, 0, 1, 0, 0.5, 0, 1, 0.25, 2, 3, 4};
        if (!binary) mesh.positions[5] = 1.0 / 3;
        WriteMesh(folder / "mesh.stl", mesh, {.binary = binary});
        ExpectSameMesh(ReadMesh(folder / "mesh.stl"), mesh);
    }
}

TEST(RoundTripPly, BlanksInNamesBecomeUnderscores) {
    TemporaryFolder folder;
    WriteMesh(folder / "mesh.ply", MeshOf("T"));
    EXPECT_NE(ReadMesh(folder / "mesh.ply").FindPointData("the_flow"), nullptr);
}

TEST(RoundTripTetgen, MarkersComeBackAsMarkers) {
    TemporaryFolder folder;
    Mesh mesh = MeshOf("t");
    mesh.point_data.push_back({"marker", 1, std::vector<double>(12, 3)});
    WriteMesh(folder / "mesh.node", mesh);
    EXPECT_THAT(Load(folder / "mesh.node"), testing::HasSubstr("\n12 3 4 1\n"));
    ExpectSameMesh(ReadMesh(folder / "mesh.node"), mesh);
}

/// More than one block of compressed bytes, and a last block that is a full one.
TEST(RoundTripVtu, ArraysOfManyBlocksComeBackExactly) {
    TemporaryFolder folder;
    for (const int n : {131072, 300001}) {
        Mesh mesh;
        mesh.topology.n_vertices = n;
        for (int i = 0; i < n; ++i) mesh.positions.insert(mesh.positions.end(), {1.0 / (i + 1), i * 0.1, -i * 0.2});
        for (int i = 0; i + 3 < n; ++i) mesh.topology.tets.insert(mesh.topology.tets.end(), {i, i + 1, i + 2, i + 3});
        WriteMesh(folder / "mesh.vtu", mesh);
        ExpectSameMesh(ReadMesh(folder / "mesh.vtu"), mesh);
    }
}

}  // namespace
}  // namespace SolidSubdiv::Io
