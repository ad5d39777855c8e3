// SPDX-License-Identifier: Apache-2.0
// Files of every format the framework knows, chosen by the file name's extension, and the one visible list of formats.
//
//     Io::Mesh mesh = Io::ReadMesh("part.vtu");
//     Io::WriteMesh("part.vtk", mesh);
//
// What each format holds; the rest of a mesh is refused (elements, by name) or left out (attributes, see
// AttributesLeftOut):
//
//     .vtu .vtk     everything but scheme options; octahedra as polyhedra or cut
//     .msh          all but polyhedra and polygons; every attribute, `physical` and `elementary` as the elements' tags
//     .mesh         the same, single vertices only as corners; one integer attribute: `reference`, else `physical`;
//                   infinite `sharpness` as Ridges and Corners
//     .node .ele    tets; every attribute, their names in a comment that TetGen skips; `marker` as boundary marker
//     .ply          faces and edges; every attribute
//     .obj          faces, edges, single vertices; the point attribute `color`; the `sharpness` of edges and single
//                   vertices, the `hole` of faces and the scheme options as OpenSubdiv's tags
//     .stl          triangles
//
// Creases and corners are edges and single vertices with cell data `sharpness` (creases.h), holes faces with cell data
// `hole` (holes.h).
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <solidsubdiv/kit/io/mesh.h>

namespace SolidSubdiv::Io {

struct WriteOptions {
    /// Octahedra as VTK_POLYHEDRON; otherwise as four tets around the major diagonal (formats without polyhedra
    /// always).
    bool keep_octahedra = false;
    /// Binary form where we write one (VTU: appended zlib-compressed; legacy VTK, STL, PLY: binary); otherwise text,
    /// with as many digits as it takes to read the same numbers back.
    bool binary = true;
};

using MeshReader = Mesh (*)(const std::filesystem::path&);
using MeshWriter = void (*)(const std::filesystem::path&, const Mesh&, const WriteOptions&);

/// One format. `write` is null for formats that are only read.
struct Format {
    std::string_view extension;  ///< lower case, with the dot
    std::string_view name;
    MeshReader read;
    MeshWriter write;
    bool solids;    ///< can hold cells
    bool surfaces;  ///< can hold faces
    bool creases;   ///< can hold edges and single vertices, and their sharpness
    /// Whether it carries an attribute of the mesh; null: every one.
    bool (*carries)(const Mesh&, const Attribute&) = nullptr;
};

/// The list; a new format is a file in formats/ and a line in formats.cpp.
std::span<const Format> Formats();

/// The format of a file name. @throws IoError naming the file and the known extensions.
const Format& FormatOf(const std::filesystem::path& path);

/// Reads a mesh of any kind. What comes back is consistent: every index in range, every number finite, every array of
/// its proper length. @throws IoError with one line: the file, what is wrong, where.
Mesh ReadMesh(const std::filesystem::path& path);

/// ReadMesh, and at least one cell must be there. @throws IoError
Mesh ReadSolid(const std::filesystem::path& path);

/// Writes beside the file and renames, so that no partial file is left. @throws IoError if the format can't hold the
/// mesh.
void WriteMesh(const std::filesystem::path& path, const Mesh& mesh, const WriteOptions& options = {});

/// Names of the mesh's attributes that WriteMesh leaves out of a file of this name, since its format can't carry them.
/// @throws IoError as FormatOf
std::vector<std::string> AttributesLeftOut(const std::filesystem::path& path, const Mesh& mesh);

}  // namespace SolidSubdiv::Io
