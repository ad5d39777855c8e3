// SPDX-License-Identifier: Apache-2.0
// The list of formats, and reading and writing through it.
#include <solidsubdiv/kit/io/formats.h>

#include <array>

#include <solidsubdiv/kit/io/internal/files.h>
#include <solidsubdiv/kit/io/internal/format_choice.h>
#include <solidsubdiv/kit/io/internal/readers.h>
#include <solidsubdiv/kit/io/internal/text.h>
#include <solidsubdiv/kit/io/internal/writers.h>
#include <solidsubdiv/kit/io/internal/writing.h>

namespace SolidSubdiv::Io {

namespace {

/// Most formats are one file: read as a whole, then parsed.
template <Mesh (*Parse)(std::string_view, const std::string&)>
Mesh ReadOneFile(const std::filesystem::path& path) {
    return Parse(Internal::ReadWholeFile(path), Internal::NameOf(path));
}

// extension, name, reader, writer, holds solids, surfaces, creases, which attributes it carries
constexpr std::array kFormats = {
    Format{".vtu", "VTK XML unstructured grid", ReadOneFile<Internal::ParseVtu>, Internal::WriteVtu, true, true, true},
    Format{".vtk", "legacy VTK", ReadOneFile<Internal::ParseVtk>, Internal::WriteVtk, true, true, true},
    Format{".msh", "Gmsh", ReadOneFile<Internal::ParseGmsh>, Internal::WriteGmsh, true, true, true},
    Format{".mesh", "MEDIT", ReadOneFile<Internal::ParseMedit>, Internal::WriteMedit, true, true, false,
           Internal::MeditCarries},
    Format{".node", "TetGen points", Internal::ReadTetgen, Internal::WriteTetgen, true, false, false},
    Format{".ele", "TetGen tetrahedra", Internal::ReadTetgen, Internal::WriteTetgen, true, false, false},
    Format{".ply", "PLY", ReadOneFile<Internal::ParsePly>, Internal::WritePly, false, true, false},
    Format{".stl", "STL", ReadOneFile<Internal::ParseStl>, Internal::WriteStl, false, true, false,
           Internal::StlCarries},
    Format{".obj", "Wavefront OBJ", ReadOneFile<Internal::ParseObj>, Internal::WriteObj, false, true, true,
           Internal::ObjCarries},
};

}  // namespace

std::span<const Format> Formats() { return kFormats; }

const Format& FormatOf(const std::filesystem::path& path) { return Internal::ChooseFormat(Formats(), path); }

Mesh ReadMesh(const std::filesystem::path& path) {
    return Internal::ReadWithinMemory(path, "split the mesh", [&] { return FormatOf(path).read(path); });
}

Mesh ReadSolid(const std::filesystem::path& path) {
    Mesh mesh = ReadMesh(path);
    if (mesh.topology.n_cells() == 0) {
        Internal::Fail(Internal::NameOf(path),
                       "holds no cells (" + Internal::Counted(mesh.topology.n_elements(), "element", "elements") +
                           " of lower dimension); a solid is needed");
    }
    return mesh;
}

void WriteMesh(const std::filesystem::path& path, const Mesh& mesh, const WriteOptions& options) {
    const Format& format = FormatOf(path);
    if (!format.write) Internal::Fail(Internal::NameOf(path), std::string(format.name) + " files are only read");
    Internal::RequireConsistent(mesh);
    format.write(path, mesh, options);
}

std::vector<std::string> AttributesLeftOut(const std::filesystem::path& path, const Mesh& mesh) {
    const Format& format = FormatOf(path);
    std::vector<std::string> names;
    if (!format.carries) return names;
    for (const auto* attributes : {&mesh.point_data, &mesh.cell_data}) {
        for (const Attribute& a : *attributes) {
            if (!format.carries(mesh, a)) names.push_back(a.name);
        }
    }
    return names;
}

}  // namespace SolidSubdiv::Io
