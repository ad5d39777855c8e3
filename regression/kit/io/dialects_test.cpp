// SPDX-License-Identifier: Apache-2.0
// The corpus (regression/shapes/io_corpus): what other programs write, in every dialect, gives one and the same mesh.
#include "kit/io/support.h"

namespace SolidSubdiv::Io {
namespace {

/// The attributes that make_corpus.py gives row r, for rows in the mesh's order.
void ExpectCorpusAttributes(const std::vector<Attribute>& attributes, const std::vector<int>& rows) {
    ASSERT_EQ(attributes.size(), 5u);
    const char* names[] = {"a double", "flow", "number", "byte", "short"};
    for (int i = 0; i < 5; ++i) EXPECT_EQ(attributes[i].name, names[i]);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const int r = rows[i];
        EXPECT_EQ(attributes[0].values[i], r / 4.0);
        for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(attributes[1].values[3 * i + k], r + static_cast<double>(k) / 8);
        EXPECT_EQ(attributes[2].values[i], 1e10 + r);
        EXPECT_EQ(attributes[3].values[i], 255 - r);
        EXPECT_EQ(attributes[4].values[i], -r);
    }
}

std::vector<int> UpTo(int n) {
    std::vector<int> numbers;
    for (int i = 0; i < n; ++i) numbers.push_back(i);
    return numbers;
}

void ExpectCorpusPoints(const Mesh& mesh) {
    const std::vector<double> expected = {1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, -1, 0, 0, 1, 2, 0, 0,
                                          3, 0, 0, 3,  1, 0, 2, 1, 0, 2, 0,  1, 3, 0, 1,  3, 1, 1, 2, 1, 1};
    EXPECT_EQ(mesh.positions, expected);
    ExpectCorpusAttributes(mesh.point_data, UpTo(14));
}

class VtkGrid : public testing::TestWithParam<const char*> {};

TEST_P(VtkGrid, EveryEncodingGivesTheSameMesh) {
    const Mesh mesh = ReadMesh(Corpus(GetParam()));
    const Topology& t = mesh.topology;
    ExpectCorpusPoints(mesh);
    EXPECT_EQ(t.tets, (std::vector<Index>{6, 7, 8, 10, 7, 8, 9, 10}));
    EXPECT_EQ(t.octs, (std::vector<Index>{0, 1, 2, 3, 4, 5}));
    EXPECT_EQ(t.hexes, (std::vector<Index>{6, 7, 8, 9, 10, 11, 12, 13, 6, 7, 8, 9, 10, 11, 12, 13}));
    EXPECT_EQ(t.wedges, (std::vector<Index>{6, 8, 7, 10, 12, 11}));
    EXPECT_EQ(t.pyramids, (std::vector<Index>{6, 7, 8, 9, 10}));
    EXPECT_EQ(t.polyhedron_offsets, (std::vector<Offset>{0, 6}));
    EXPECT_EQ(t.polyhedron_face_offsets, (std::vector<Offset>{0, 4, 8, 12, 16, 20, 24}));
    EXPECT_EQ(t.polyhedron_vertices,
              (std::vector<Index>{6, 9, 8, 7, 10, 11, 12, 13, 6, 7, 11, 10, 7, 8, 12, 11, 8, 9, 13, 12, 9, 6, 10, 13}));
    EXPECT_EQ(t.triangles, (std::vector<Index>{0, 2, 5, 6, 7, 9, 9, 7, 8}));
    EXPECT_EQ(t.quads, (std::vector<Index>{6, 7, 8, 9, 6, 7, 8, 9}));
    EXPECT_EQ(t.polygon_vertices, (std::vector<Index>{0, 2, 5, 6, 7}));
    EXPECT_EQ(t.edges, (std::vector<Index>{0, 6, 1, 2, 2, 3}));
    EXPECT_EQ(t.vertices, (std::vector<Index>{4}));
    // Which row of the file each element has; strips and polylines give theirs to all their parts.
    ExpectCorpusAttributes(mesh.cell_data, {2, 15, 1, 0, 6, 3, 4, 5, 8, 12, 12, 9, 10, 11, 7, 13, 13, 14});
    EXPECT_EQ(mesh.cell_data[0].values.size(), 18u);
}

INSTANTIATE_TEST_SUITE_P(Corpus, VtkGrid,
                         testing::Values("vtk_text.vtu", "vtk_base64.vtu", "vtk_base64_zlib_big.vtu", "vtk_raw.vtu",
                                         "vtk_raw_zlib_big.vtu", "vtk_encoded_zlib.vtu", "vtk_42_text.vtk",
                                         "vtk_42_binary.vtk", "vtk_51_text.vtk", "vtk_51_binary.vtk"));

class VtkPolyData : public testing::TestWithParam<const char*> {};

TEST_P(VtkPolyData, EveryEncodingGivesTheSameMesh) {
    const Mesh mesh = ReadMesh(Corpus(GetParam()));
    const Topology& t = mesh.topology;
    ExpectCorpusPoints(mesh);
    EXPECT_EQ(t.triangles, (std::vector<Index>{0, 2, 5, 6, 7, 9, 9, 7, 8}));
    EXPECT_EQ(t.quads, (std::vector<Index>{6, 7, 8, 9}));
    EXPECT_EQ(t.polygon_vertices, (std::vector<Index>{0, 2, 5, 6, 7}));
    EXPECT_EQ(t.edges, (std::vector<Index>{0, 1, 1, 2}));
    EXPECT_EQ(t.vertices, (std::vector<Index>{3}));
    ExpectCorpusAttributes(mesh.cell_data, {2, 5, 5, 3, 4, 1, 1, 0});
}

INSTANTIATE_TEST_SUITE_P(Corpus, VtkPolyData,
                         testing::Values("vtk_42_text_poly.vtk", "vtk_42_binary_poly.vtk", "vtk_51_text_poly.vtk",
                                         "vtk_51_binary_poly.vtk"));

TEST(GmshDialects, EveryVersionGivesTheSameMesh) {
    const Mesh mesh = ReadMesh(Corpus("gmsh_2.2_text.msh"));
    EXPECT_EQ(mesh.topology.n_vertices, 14);
    EXPECT_EQ(mesh.topology.n_tets(), 24);
    EXPECT_THAT(std::vector<Index>(mesh.topology.tets.begin(), mesh.topology.tets.begin() + 4),
                testing::ElementsAre(9, 10, 11, 12));
    EXPECT_THAT(mesh.topology.triangles, testing::ElementsAre(1, 0, 8, 0, 2, 8, 3, 1, 8, 2, 3, 8));
    EXPECT_THAT(mesh.topology.edges, testing::ElementsAre(1, 0));
    EXPECT_THAT(mesh.topology.vertices, testing::ElementsAre(0));
    const Attribute* physical = mesh.FindCellData("physical");
    ASSERT_NE(physical, nullptr);
    std::vector<double> labels(24, 7);
    labels.insert(labels.end(), {5, 5, 5, 5, 4, 3});
    EXPECT_EQ(physical->values, labels);
    ASSERT_NE(mesh.FindPointData("height z"), nullptr);
    for (std::size_t v = 0; v < 14; ++v)
        EXPECT_EQ(mesh.FindPointData("height z")->values[v], mesh.positions[3 * v + 2]);
    // Data on tets only: their numbers (7 to 30), 1, 2; zeros on the others.
    const Attribute* flow = mesh.FindCellData("flow");
    ASSERT_NE(flow, nullptr);
    ASSERT_EQ(flow->values.size(), 90u);
    for (std::size_t i = 0; i < 30; ++i) {
        EXPECT_EQ(flow->values[3 * i], i < 24 ? static_cast<double>(i + 7) : 0);
        EXPECT_EQ(flow->values[3 * i + 2], i < 24 ? 2 : 0);
    }
    for (const char* name :
         {"gmsh_2.2_binary.msh", "gmsh_4.1_text.msh", "gmsh_4.1_binary.msh", "gmsh_4.1_binary_parametric.msh"}) {
        SCOPED_TRACE(name);
        ExpectSameMesh(ReadMesh(Corpus(name)), mesh);
    }

    Mesh bare = mesh;  // version 1 has no data
    bare.point_data.clear();
    bare.cell_data.erase(bare.cell_data.begin());
    ExpectSameMesh(ReadMesh(Corpus("gmsh_1_text.msh")), bare);
    // Gmsh's own MEDIT file: the same geometry, no single vertices.
    const Mesh medit = ReadMesh(Corpus("gmsh_box.mesh"));
    EXPECT_EQ(medit.positions, mesh.positions);
    EXPECT_EQ(medit.topology.tets, mesh.topology.tets);
    EXPECT_EQ(medit.topology.triangles, mesh.topology.triangles);
}

TEST(StlDialects, TextAndBinaryGiveTheSameMesh) {
    const Mesh mesh = ReadMesh(Corpus("gmsh_box_text.stl"));
    EXPECT_EQ(mesh.topology.n_vertices, 5);
    EXPECT_EQ(mesh.topology.n_triangles(), 4);
    EXPECT_THAT(mesh.topology.triangles, testing::ElementsAre(0, 1, 2, 1, 3, 2, 4, 0, 2, 3, 4, 2));
    ExpectSameMesh(ReadMesh(Corpus("gmsh_box_binary.stl")), mesh);
    EXPECT_THAT(mesh.notes, testing::ElementsAre("12 corners of triangles merged into 5 vertices"));
}

TEST(PlyDialects, TextAndBothByteOrdersGiveTheSameMesh) {
    const Mesh mesh = ReadMesh(Corpus("hand_crlf.ply"));
    EXPECT_THAT(mesh.topology.triangles, testing::ElementsAre(0, 1, 4));
    EXPECT_THAT(mesh.topology.quads, testing::ElementsAre(0, 3, 2, 1));
    EXPECT_THAT(mesh.topology.edges, testing::ElementsAre(0, 1));
    EXPECT_THAT(mesh.positions, testing::ElementsAre(0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0.5, 0.5, 1));
    EXPECT_THAT(mesh.FindPointData("red")->values, testing::ElementsAre(255, 254, 253, 252, 251));
    EXPECT_EQ(mesh.FindPointData("w")->width, 2);
    EXPECT_THAT(mesh.FindPointData("w")->values, testing::ElementsAre(0.5, -1, 1.5, -2, 2.5, -3, 3.5, -4, 4.5, -5));
    EXPECT_THAT(mesh.FindCellData("label")->values, testing::ElementsAre(7, 8, 0));
    EXPECT_THAT(mesh.FindCellData("sharpness")->values, testing::ElementsAre(0, 0, 2.5));
    ExpectSameMesh(ReadMesh(Corpus("ply_little.ply")), mesh);
    ExpectSameMesh(ReadMesh(Corpus("ply_big.ply")), mesh);
}

TEST(ObjDialects, EveryFormOfAnIndexIsRead) {
    const Mesh mesh = ReadMesh(Corpus("hand_forms.obj"));
    EXPECT_THAT(mesh.positions, testing::ElementsAre(0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0.5, 1.5, 0.1));
    EXPECT_THAT(mesh.topology.triangles, testing::ElementsAre(0, 1, 2, 0, 1, 2));
    EXPECT_THAT(mesh.topology.quads, testing::ElementsAre(0, 1, 2, 3));
    EXPECT_THAT(mesh.topology.polygon_vertices, testing::ElementsAre(0, 1, 2, 4, 3));
    EXPECT_THAT(mesh.topology.edges, testing::ElementsAre(0, 1, 1, 2));
    EXPECT_THAT(mesh.topology.vertices, testing::ElementsAre(3, 4));
    // The tags lie on the line and the point, so they add no elements.
    EXPECT_THAT(mesh.FindCellData("sharpness")->values, testing::ElementsAre(0, 0, 0, 0, 2, 0, 10, 0));
}

TEST(TetgenDialects, CommentsCountFromOneAttributesMarkersAndEitherName) {
    const Mesh mesh = ReadMesh(Corpus("hand_tets.node"));
    EXPECT_THAT(mesh.positions, testing::ElementsAre(0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1));
    EXPECT_THAT(mesh.topology.tets, testing::ElementsAre(0, 1, 2, 3, 1, 2, 3, 4));
    EXPECT_THAT(mesh.FindPointData("attribute1")->values, testing::ElementsAre(2.5, 3.5, 4.5, 5.5, 6.5));
    EXPECT_THAT(mesh.FindPointData("marker")->values, testing::ElementsAre(1, 1, 0, 0, 2));
    EXPECT_THAT(mesh.FindCellData("attribute1")->values, testing::ElementsAre(10, 20));
    ExpectSameMesh(ReadMesh(Corpus("hand_tets.ele")), mesh);
}

TEST(MeditDialects, OldLineEndsUnknownSectionsAndTurnedPrisms) {
    const Mesh mesh = ReadMesh(Corpus("hand_mac.mesh"));
    EXPECT_EQ(mesh.topology.n_vertices, 7);
    EXPECT_THAT(mesh.topology.wedges, testing::ElementsAre(0, 2, 1, 3, 5, 4));
    EXPECT_THAT(mesh.topology.tets, testing::ElementsAre(3, 4, 5, 6));
    EXPECT_THAT(mesh.topology.triangles, testing::ElementsAre(0, 2, 1));
    EXPECT_THAT(mesh.FindPointData("reference")->values, testing::ElementsAre(1, 1, 1, 2, 2, 2, 0));
    EXPECT_THAT(mesh.topology.edges, testing::ElementsAre(0, 1, 2, 3));
    EXPECT_THAT(mesh.topology.vertices, testing::ElementsAre(0, 1));
    EXPECT_THAT(mesh.FindCellData("reference")->values, testing::ElementsAre(8, 9, 4, 5, 6, 0, 0));
    EXPECT_THAT(mesh.FindCellData("sharpness")->values, testing::ElementsAre(0, 0, 0, 0, 10, 10, 10));
    EXPECT_THAT(mesh.notes, testing::ElementsAre("section 'RequiredVertices' is left out"));
}

TEST(VtuDialects, Vtk94LayoutOfPolyhedraIsRead) {
    const Mesh mesh = ReadMesh(Corpus("hand_new_polyhedra.vtu"));
    EXPECT_THAT(mesh.topology.tets, testing::ElementsAre(6, 7, 8, 9));
    EXPECT_THAT(mesh.topology.octs, testing::ElementsAre(0, 1, 2, 3, 4, 5));
    EXPECT_THAT(mesh.topology.polyhedron_vertices, testing::ElementsAre(6, 8, 7, 6, 7, 9, 7, 8, 9, 6, 9, 8));
}

TEST(Corpus, OctahedraAndWedgesOfTheGridAreKeptByItsOwnWriters) {
    TemporaryFolder folder;
    const Mesh mesh = ReadMesh(Corpus("vtk_text.vtu"));
    for (const char* name : {"a.vtu", "a.vtk"}) {
        WriteMesh(folder / name, mesh, {.keep_octahedra = true});
        ExpectSameMesh(ReadMesh(folder / name), mesh);
    }
}

}  // namespace
}  // namespace SolidSubdiv::Io
