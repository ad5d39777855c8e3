// SPDX-License-Identifier: Apache-2.0
// Writing: what a format can't hold is refused by name, and whatever fails leaves no file and harms none.
#include <sys/resource.h>
#include <sys/stat.h>

#include <algorithm>
#include <csignal>

#include "kit/io/support.h"

namespace SolidSubdiv::Io {
namespace {

TEST(Writing, KindsThatAFormatCannotHoldAreRefusedByName) {
    const struct {
        const char* file;
        const char* kinds;
        const char* says;
    } cases[] = {{"a.obj", "tT", "OBJ files can't hold tetrahedra, the mesh has 3"},
                 {"a.obj", "o", "OBJ files can't hold octahedra, the mesh has 2"},
                 {"a.ply", "hT", "PLY files can't hold hexahedra, the mesh has 1"},
                 {"a.ply", "TV", "PLY files can't hold single vertices, the mesh has 2"},
                 {"a.stl", "TQ", "STL files can't hold quadrilaterals, the mesh has 1"},
                 {"a.stl", "TE", "STL files can't hold edges, the mesh has 2"},
                 {"a.ele", "ty", "TetGen files can't hold pyramids, the mesh has 1"},
                 {"a.node", "w", "TetGen files can't hold wedges, the mesh has 2"},
                 {"a.msh", "p", "Gmsh files can't hold polyhedra, the mesh has 2"},
                 {"a.msh", "P", "Gmsh files can't hold polygons, the mesh has 2"},
                 {"a.mesh", "tV", "MEDIT files can't hold single vertices, the mesh has 2"}};
    for (const auto& c : cases) {
        TemporaryFolder folder;
        const std::string message = ErrorOf([&] { WriteMesh(folder / c.file, MeshOf(c.kinds)); });
        EXPECT_EQ(message,
                  (folder / c.file).string() + ": " + c.says + "; choose another format, .vtu holds everything");
        EXPECT_THAT(folder.Files(), testing::IsEmpty());
    }
}

TEST(Writing, AttributesSaidToBeLeftOutAreThoseThatDoNotComeBack) {
    for (const Format& format : Formats()) {
        SCOPED_TRACE(format.extension);
        Mesh mesh = MeshOf(format.solids ? "t" : "T");
        for (double& x : mesh.positions) x = std::clamp(x, -9.0, 9.0);  // STL's numbers have 32 bits
        mesh.point_data[1].name = "flow";                               // PLY's names have no spaces
        const auto n = static_cast<std::size_t>(mesh.topology.n_elements());
        mesh.point_data.push_back({"color", 3, std::vector<double>(36, 0.5)});
        mesh.cell_data.push_back({"physical", 1, std::vector<double>(n, 3)});
        mesh.cell_data.push_back({"reference", 1, std::vector<double>(n, 4)});

        TemporaryFolder folder;
        const auto path = folder / ("a" + std::string(format.extension));
        WriteMesh(path, mesh);
        const Mesh back = ReadMesh(path);
        std::vector<std::string> missing;
        for (const Attribute& a : mesh.point_data) {
            if (!back.FindPointData(a.name)) missing.push_back(a.name);
        }
        for (const Attribute& a : mesh.cell_data) {
            if (!back.FindCellData(a.name)) missing.push_back(a.name);
        }
        EXPECT_EQ(AttributesLeftOut(path, mesh), missing);
        EXPECT_EQ(missing.empty(), format.carries == nullptr);
    }
}

TEST(Writing, RefusalLeavesTheOldFileAsItWas) {
    TemporaryFolder folder;
    Save(folder / "a.obj", "old");
    EXPECT_NE(ErrorOf([&] { WriteMesh(folder / "a.obj", MeshOf("t")); }), "");
    EXPECT_EQ(Load(folder / "a.obj"), "old");
    EXPECT_EQ(folder.Files().size(), 1u);
}

TEST(Writing, FolderThatIsNotThereIsNamed) {
    TemporaryFolder folder;
    EXPECT_THAT(ErrorOf([&] { WriteMesh(folder / "none/a.vtu", MeshOf("t")); }),
                testing::HasSubstr("none/a.vtu: can't be written: No such file or directory"));
}

TEST(Writing, NameOfAFolderIsRefused) {
    TemporaryFolder folder;
    std::filesystem::create_directory(folder / "a.vtu");
    EXPECT_THAT(ErrorOf([&] { WriteMesh(folder / "a.vtu", MeshOf("t")); }), testing::HasSubstr("is a directory"));
    // TetGen's second file: the first one is not written either.
    std::filesystem::create_directory(folder / "b.ele");
    EXPECT_THAT(ErrorOf([&] { WriteMesh(folder / "b.node", MeshOf("t")); }), testing::HasSubstr("is a directory"));
    EXPECT_THAT(folder.Files(), testing::UnorderedElementsAre("a.vtu", "b.ele"));
}

/// A full disk, by the system's limit on the size of a file.
TEST(Writing, FullDiskLeavesNothingBehind) {
    std::signal(SIGXFSZ, SIG_IGN);
    rlimit before = {};
    ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
    for (const char* name : {"a.vtu", "a.vtk", "a.msh", "a.mesh", "a.ele"}) {
        SCOPED_TRACE(name);
        TemporaryFolder folder;
        const rlimit small = {100, before.rlim_max};
        ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
        const std::string message = ErrorOf([&] { WriteMesh(folder / name, MeshOf("t")); });
        ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &before), 0);
        EXPECT_THAT(message, testing::HasSubstr("can't be written: File too large"));
        EXPECT_THAT(folder.Files(), testing::IsEmpty());
    }
}

TEST(Writing, NewFileGetsTheUsualPermissions) {
    TemporaryFolder folder;
    const mode_t mask = umask(022);
    WriteMesh(folder / "a.vtu", MeshOf("t"));
    umask(mask);
    struct stat status = {};
    ASSERT_EQ(stat((folder / "a.vtu").c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 0777, 0644u);
}

TEST(Writing, InconsistentMeshIsTheCallersMistake) {
    TemporaryFolder folder;
    Mesh mesh = MeshOf("t");
    mesh.topology.tets[0] = 12;
    EXPECT_THROW(WriteMesh(folder / "a.vtu", mesh), InvalidInput);
    mesh = MeshOf("t");
    mesh.cell_data[0].values.pop_back();
    EXPECT_THROW(WriteMesh(folder / "a.vtu", mesh), InvalidInput);
    mesh = MeshOf("t");
    mesh.positions.pop_back();
    EXPECT_THROW(WriteMesh(folder / "a.vtu", mesh), InvalidInput);
    EXPECT_THAT(folder.Files(), testing::IsEmpty());
}

TEST(Writing, CoordinatesTooLargeForBinaryStlAreRefused) {
    TemporaryFolder folder;
    const Mesh mesh = MeshOf("T");
    EXPECT_THAT(ErrorOf([&] { WriteMesh(folder / "a.stl", mesh); }), testing::HasSubstr("32-bit numbers"));
    EXPECT_EQ(ErrorOf([&] { WriteMesh(folder / "a.stl", mesh, {.binary = false}); }), "");
}

TEST(Formats, ExtensionInAnyCaseChoosesTheFormat) {
    EXPECT_EQ(FormatOf("A.B.VTU").name, "VTK XML unstructured grid");
    for (const Format& format : Formats()) {
        EXPECT_EQ(&FormatOf("x" + std::string(format.extension)), &format);
        EXPECT_TRUE(format.solids || format.surfaces) << format.name;
    }
}

}  // namespace
}  // namespace SolidSubdiv::Io
