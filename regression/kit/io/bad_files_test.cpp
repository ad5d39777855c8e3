// SPDX-License-Identifier: Apache-2.0
// Bad files of every kind: one line that names the file, what is wrong and where.
#include <algorithm>
#include <cctype>

#include "kit/io/support.h"

namespace SolidSubdiv::Io {
namespace {

struct BadFile {
    std::string name;
    std::string bytes;
    std::string says;  // a part of the message
};

std::string VtuOf(const std::string& points, const std::string& connectivity, const std::string& offsets,
                  const std::string& types, const std::string& root = "byte_order=\"LittleEndian\"") {
    const auto array = [](const std::string& type, const std::string& name, const std::string& numbers) {
        return "<DataArray type=\"" + type + "\" Name=\"" + name + "\" format=\"ascii\">" + numbers + "</DataArray>";
    };
    return "<VTKFile type=\"UnstructuredGrid\" " + root +
           "><UnstructuredGrid><Piece NumberOfPoints=\"4\" NumberOfCells=\"1\"><Points>" +
           "<DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">" + points +
           "</DataArray></Points><Cells>" + array("Int32", "connectivity", connectivity) +
           array("Int32", "offsets", offsets) + array("UInt8", "types", types) +
           "</Cells></Piece></UnstructuredGrid></VTKFile>";
}

const std::string kFour = "0 0 0 1 0 0 0 1 0 0 0 1";
const std::string kVtkPoints =
    "# vtk DataFile Version 3.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 double\n" + kFour + "\n";
const std::string kMsh2 = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";
const std::string kMsh2Nodes = kMsh2 + "$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n$EndNodes\n";
const std::string kMedit = "MeshVersionFormatted 1\nDimension 3\nVertices 3\n0 0 0 0\n1 0 0 0\n0 1 0 0\n";
const std::string kPly =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n";

const std::vector<BadFile> kBadFiles = {
    {"empty.vtu", "", "the file is empty"},
    {"blank.obj", "f 1 2 3\n", "names vertex 1, but there are 0 vertices"},
    {"unknown.xyz", "1 2 3", "the extension '.xyz' is unknown; known are .vtu"},
    {"none", "1 2 3", "no extension"},

    {"real_offsets.vtk",
     "# vtk DataFile Version 5.1\nt\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 double\n" + kFour +
         "\nCELLS 2 4\nOFFSETS double\n0 4\nCONNECTIVITY vtktypeint64\n0 1 2 3\n",
     "OFFSETS must be of an integer type"},
    {"real_vertices.vtk",
     "# vtk DataFile Version 5.1\nt\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 double\n" + kFour +
         "\nCELLS 2 4\nOFFSETS vtktypeint64\n0 4\nCONNECTIVITY float\n0 1 2 3\n",
     "CONNECTIVITY must be of an integer type"},

    {"noxml.vtu", "hello", "no complete XML"},
    {"cut.vtu", "<VTKFile type=\"UnstructuredGrid\">\n<Unstr", "no complete XML"},
    {"other.vtu", "<html></html>", "no element VTKFile"},
    {"image.vtu", "<VTKFile type=\"ImageData\"><ImageData/></VTKFile>", "holds 'ImageData', not an UnstructuredGrid"},
    {"nopiece.vtu", "<VTKFile><UnstructuredGrid/></VTKFile>", "no Piece"},
    {"lz4.vtu", VtuOf(kFour, "0 1 2 3", "4", "10", "compressor=\"vtkLZ4DataCompressor\""), "vtkLZ4DataCompressor"},
    {"order.vtu", VtuOf(kFour, "0 1 2 3", "4", "10", "byte_order=\"Middle\""), "byte_order is 'Middle'"},
    {"nan.vtu", VtuOf("0 0 0 1 0 0 0 nan 0 0 0 1", "0 1 2 3", "4", "10"), "vertex 2 has a coordinate y that is not"},
    {"inf.vtu", VtuOf("0 0 0 1 0 0 0 1 0 0 0 1e999", "0 1 2 3", "4", "10"), "vertex 3 has a coordinate z that is not"},
    {"points.vtu", VtuOf("0 0 0", "0 1 2 3", "4", "10"), "4 rows of 3 are needed"},
    {"word.vtu", VtuOf("0 0 zero", "0 1 2 3", "4", "10"), "expected a number, found 'zero'"},
    {"range.vtu", VtuOf(kFour, "0 1 2 4", "4", "10"), "cell 0 names vertex 4, but there are 4 vertices"},
    {"negative.vtu", VtuOf(kFour, "0 1 2 -1", "4", "10"), "cell 0 names vertex -1"},
    {"ends.vtu", VtuOf(kFour, "0 1 2 3", "5", "10"), "cell 0 takes the numbers from 0 to 5"},
    {"quadratic.vtu", VtuOf(kFour, "0 1 2 3", "4", "24"), "a cell of second order (VTK type 24)"},
    {"size.vtu", VtuOf(kFour, "0 1 2 3", "4", "12"), "a hexahedron with 4 vertices; it needs 8"},

    {"first.vtk", "hello\n", "is no legacy VTK file"},
    {"format.vtk", "# vtk DataFile Version 3.0\nt\nTEXT\n", "line 3: expected ASCII or BINARY, found 'TEXT'"},
    {"dataset.vtk", "# vtk DataFile Version 3.0\nt\nASCII\nDATASET STRUCTURED_POINTS\n",
     "'STRUCTURED_POINTS' can't be used"},
    {"huge.vtk", "# vtk DataFile Version 3.0\nt\nASCII\nDATASET POLYDATA\nPOINTS 2000000000 float\n0 0 0\n",
     "line 5: 2000000000 rows of 3 for POINTS are announced"},
    {"short.vtk", "# vtk DataFile Version 3.0\r\nt\r\nASCII\r\nDATASET POLYDATA\r\nPOINTS 1 float\r\n0 0 x\r\n",
     "line 6: expected a number of POINTS, found 'x'"},
    {"lists.vtk", kVtkPoints + "CELLS 1 5\n5 0 1 2 3\nCELL_TYPES 1\n10\n", "list of cell 0 does not fit"},
    {"rest.vtk", kVtkPoints + "CELLS 1 6\n4 0 1 2 3 3\nCELL_TYPES 1\n10\n", "does not fit their lists"},
    {"types.vtk", kVtkPoints + "CELLS 1 5\n4 0 1 2 3\n", "has 1 CELLS but 0 CELL_TYPES"},
    {"data.vtk", kVtkPoints + "POINT_DATA 3\nSCALARS s float\nLOOKUP_TABLE default\n1 2 3\n",
     "POINT_DATA has 3 rows, but there are 4 points"},
    {"keyword.vtk", kVtkPoints + "CELSL 1 5\n", "line 7: unknown keyword 'celsl'"},

    {"zero.obj", "v 0 0 0\nf 0 1 2\n", "line 2: vertex 0: vertices are counted from 1"},
    {"back.obj", "v 0 0 0\nf -1 -2 -3\n", "line 2: vertex -2 counts back behind the first vertex"},
    {"beyond.obj", "v 0 0 0\nv 1 0 0\nf 1 2 3\n",
     "a triangle (element 1 of the file) names vertex 3, but there are 2 vertices"},
    {"two.obj", "v 0 0 0\rv 1 0 0\rf 1 2\r", "line 3: a face needs at least three vertices"},
    {"text.obj", "v 0 0\n", "line 1: expected a coordinate, found the end"},

    {"start.msh", "hello", "is no Gmsh mesh"},
    {"version.msh", "$MeshFormat\n3.0 0 8\n$EndMeshFormat\n", "line 2: version '3.0' can't be read; save the mesh as"},
    {"many.msh", kMsh2 + "$Nodes\n999999999999\n1 0 0 0\n", "999999999999 nodes are announced, but only"},
    {"twice.msh", kMsh2 + "$Nodes\n2\n1 0 0 0\n1 1 0 0\n$EndNodes\n", "node 1 is there twice"},
    {"high.msh", kMsh2Nodes + "$Elements\n1\n1 11 2 0 0 1 2 3 4 5 6 7 8 9 10\n$EndElements\n",
     "a tetrahedron of second order (Gmsh type 11)"},
    {"node.msh", kMsh2Nodes + "$Elements\n1\n17 4 2 0 0 1 2 3 9\n$EndElements\n",
     "element 17 names node 9, which is not there"},
    {"end.msh", kMsh2Nodes + "$Elements\n1\n1 4 2 0 0 1 2 3 4\n", "expected $EndElements, found the end"},
    {"missing.msh", kMsh2Nodes, "has no section of elements"},
    {"four.msh", "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n1 2 1 2\n0 1 0 1\n1\n0 0 0\n$EndNodes\n",
     "the blocks have 1 nodes, 2 are announced"},

    {"mfem.mesh", "MFEM mesh v1.0\n", "is no MEDIT mesh"},
    {"range.mesh", kMedit + "Triangles 1\n1 2 4 0\nEnd\n", "names vertex 4, but there are 3 vertices"},
    {"zero.mesh", kMedit + "Triangles 1\n0 1 2 0\nEnd\n", "line 8: an element names vertex 0"},
    {"ridge.mesh", kMedit + "Ridges 1\n2\nEdges 1\n1 2 0\nEnd\n", "a ridge is edge 2 of 1; edges are counted from 1"},
    {"corner.mesh", kMedit + "Corners 1\n0\nEnd\n", "line 8: a corner is vertex 0; vertices are counted from 1"},
    {"corners.mesh", kMedit + "Corners 1\n4\nEnd\n",
     "a single vertex (element 1 of the file) names vertex 4, but there"},
    {"many.mesh", kMedit + "Corners 1000000000\n1\n", "1000000000 corners are announced, but only 3 bytes follow"},
    {"order.mesh", kMedit + "TrianglesP2 1\n1 2 3 0\n", "higher order"},
    {"nothing.mesh", "MeshVersionFormatted 1\nEnd\n", "has no Vertices"},

    {"first.ply", "plyx\n", "is no PLY file"},
    {"header.ply", "ply\nformat ascii 1.0\nelement vertex 1\n", "the header has no end_header"},
    {"type.ply", "ply\nformat ascii 1.0\nelement vertex 1\nproperty quad x\n", "line 4: the type 'quad' is unknown"},
    {"axis.ply", "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\n0\n", "no property y"},
    {"rows.ply", kPly + "end_header\n0 0 0\n", "3 rows of the element 'vertex' are announced"},
    {"index.ply",
     kPly + "element face 1\nproperty list uchar float vertex_indices\nend_header\n" + "0 0 0 1 0 0 0 1 0 3 0 1 1.5\n",
     "a vertex of a face is no integer"},
    {"fewer.ply",
     kPly + "element face 1\nproperty list uchar int vertex_indices\nend_header\n" + "0 0 0 1 0 0 0 1 0 2 0 1\n",
     "a polygon of 2 vertices"},

    {"short.stl", "soli", "is no STL file"},
    {"count.stl", std::string(80, 'x') + std::string("\x02\0\0\0", 4) + std::string(50, '\0'),
     "2 triangles are announced, but the file has room for 1"},
    {"four.stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nvertex 1 1 1\n",
     "line 7: expected endloop, found 'vertex'"},
    {"inf.stl",
     "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 inf\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n",
     "triangle 0 has a coordinate that is not a finite number"},
};

class Bad : public testing::TestWithParam<BadFile> {};

TEST_P(Bad, FileGivesOneLineThatNamesIt) {
    TemporaryFolder folder;
    const auto path = folder / GetParam().name;
    Save(path, GetParam().bytes);
    const std::string message = ErrorOf([&] { ReadMesh(path); });
    EXPECT_THAT(message, testing::StartsWith(path.string() + ": "));
    EXPECT_THAT(message, testing::HasSubstr(GetParam().says));
    EXPECT_EQ(message.find('\n'), message.npos);
}

INSTANTIATE_TEST_SUITE_P(Files, Bad, testing::ValuesIn(kBadFiles), [](const auto& bad) {
    std::string name = bad.param.name;
    std::replace_if(
        name.begin(), name.end(), [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); }, '_');
    return name;
});

TEST(BadTetgen, EachOfTheTwoFilesIsNamed) {
    TemporaryFolder folder;
    const std::string nodes = "3 3 0 0\n0 0 0 0\n1 1 0 0\n2 0 1 0\n";
    const auto error = [&](const std::string& node_text, const std::string& element_text) {
        Save(folder / "a.node", node_text);
        Save(folder / "a.ele", element_text);
        return ErrorOf([&] { ReadMesh(folder / "a.ele"); });
    };
    EXPECT_THAT(error(nodes, "1 10 0\n0 0 1 2 0 1 2 0 1 2 0\n"),
                testing::HasSubstr("a.ele: line 1: elements of 10 points"));
    EXPECT_THAT(error(nodes, "1 4 0\n0 0 1 2 3\n"), testing::HasSubstr("a.ele: line 2: a tetrahedron names point 3"));
    EXPECT_THAT(error("2 3 0 0\n5 0 0 0\n6 0 0 0\n", "0 4 0\n"),
                testing::HasSubstr("a.node: line 2: points must be counted"));
    EXPECT_THAT(error("2 3 0 0\n0 0 0 0\n2 0 0 0\n", "0 4 0\n"), testing::HasSubstr("expected point 1, found 2"));
    EXPECT_THAT(error(nodes + "3 1 1 1\n", "0 4 0\n"), testing::HasSubstr("more follows"));
    std::filesystem::remove(folder / "a.node");
    EXPECT_THAT(ErrorOf([&] { ReadMesh(folder / "a.ele"); }), testing::HasSubstr("a.node: there is no such file"));
}

TEST(BadPlaces, MissingFileAndFolderAreNamed) {
    TemporaryFolder folder;
    std::filesystem::create_directory(folder / "folder.vtu");
    EXPECT_THAT(ErrorOf([&] { ReadMesh(folder / "folder.vtu"); }), testing::EndsWith("is a directory, not a file"));
    EXPECT_THAT(ErrorOf([&] { ReadMesh(folder / "missing.vtu"); }), testing::EndsWith("there is no such file"));
}

TEST(BadPlaces, ControlCharactersInNamesStayOnOneLine) {
    TemporaryFolder folder;
    const std::string message = ErrorOf([&] { ReadMesh(folder / "a\nb.vtu"); });
    EXPECT_THAT(message, testing::HasSubstr("a?b.vtu: there is no such file"));
}

TEST(ReadSolid, SurfaceIsRefused) {
    EXPECT_THAT(ErrorOf([] { ReadSolid(Corpus("hand_forms.obj")); }), testing::HasSubstr("holds no cells (8 elements"));
}

TEST(Attributes, OneThatIsNotFiniteIsLeftOutWithANote) {
    TemporaryFolder folder;
    Save(folder / "a.vtk", kVtkPoints + "POINT_DATA 4\nSCALARS bad float\nLOOKUP_TABLE default\n1 2 nan 4\n" +
                               "SCALARS good float 1\nLOOKUP_TABLE default\n1 2 3 4\n");
    const Mesh mesh = ReadMesh(folder / "a.vtk");
    ASSERT_EQ(mesh.point_data.size(), 1u);
    EXPECT_THAT(mesh.FindPointData("good")->values, testing::ElementsAre(1, 2, 3, 4));
    EXPECT_THAT(mesh.notes, testing::ElementsAre("point data 'bad' is left out: row 2 is not a finite number"));
}

}  // namespace
}  // namespace SolidSubdiv::Io
