// SPDX-License-Identifier: Apache-2.0
// Writes Wavefront OBJ (.obj): vertices, faces, lines, points; creases, corners, holes and the scheme's options
// as OpenSubdiv's tags.
#include <algorithm>
#include <array>
#include <cmath>

#include <solidsubdiv/kit/io/creases.h>
#include <solidsubdiv/kit/io/holes.h>
#include <solidsubdiv/kit/io/internal/files.h>
#include <solidsubdiv/kit/io/internal/obj_tags.h>
#include <solidsubdiv/kit/io/internal/writers.h>
#include <solidsubdiv/kit/io/internal/writing.h>
#include <solidsubdiv/sdc/errors.h>

namespace SolidSubdiv::Io::Internal {

namespace {

/// The attribute that vertices carry, or null.
const Attribute* ColorsOf(const Mesh& mesh) {
    const Attribute* const color = mesh.FindPointData("color");
    return color && color->width == 3 ? color : nullptr;
}

/// Options that OpenSubdiv has no tag for are not written.
std::string TagOf(const std::string& option, const std::string& value) {
    if (option == "boundary") {
        const auto found = std::find(kBoundaryNames.begin(), kBoundaryNames.end(), value);
        if (found != kBoundaryNames.end()) {
            return "t interpolateboundary 1/0/0 " + std::to_string(found - kBoundaryNames.begin()) + '\n';
        }
    } else if (option == "creasing") {
        for (const CreasingName& name : kCreasingNames) {
            if (name.option == value) return "t creasemethod 0/0/1 " + std::string(name.tag) + '\n';
        }
    } else {
        return {};
    }
    throw InvalidInput("mesh to write: the scheme option '" + option + "' has no value " + Quoted(value));
}

void WriteElement(OutputFile& file, ElementKind kind, std::span<const Index> vertices, double sharpness) {
    if (sharpness > 0 && CanBeSharp(kind)) {
        file << (kind == ElementKind::Edge ? "t crease 2/1/0" : "t corner 1/1/0");
        for (const Index v : vertices) file << ' ' << v;
        file << ' ' << (std::isfinite(sharpness) ? sharpness : static_cast<double>(kInfinitelySharp)) << '\n';
        return;
    }
    file << (kind == ElementKind::Edge ? 'l' : kind == ElementKind::Vertex ? 'p' : 'f');
    for (const Index v : vertices) file << ' ' << v + 1;
    file << '\n';
}

}  // namespace

bool ObjCarries(const Mesh& mesh, const Attribute& attribute) {
    if (&attribute == ColorsOf(mesh)) return true;
    const bool is_hole = &attribute == FindHoles(mesh);
    if (!is_hole && &attribute != FindSharpness(mesh)) return false;
    std::size_t row = 0;
    bool carried = true;
    ForEachElement(mesh.topology, [&](ElementKind kind, Offset) {
        const double value = attribute.values[row++];
        const bool has_tag = is_hole ? !CanBeSharp(kind) : value > 0 && CanBeSharp(kind);
        carried = carried && (value == 0 || has_tag);
    });
    return carried;
}

void WriteObj(const std::filesystem::path& path, const Mesh& mesh, const WriteOptions&) {
    constexpr std::array kinds = {ElementKind::Triangle, ElementKind::Quad, ElementKind::Polygon, ElementKind::Edge,
                                  ElementKind::Vertex};
    RequireKinds(path, mesh, "OBJ", kinds);
    const Attribute* const color = ColorsOf(mesh);
    const Attribute* const sharpness = FindSharpness(mesh);

    OutputFile file(path);
    file << "# written by SolidSubdiv\n";
    for (std::size_t at = 0; at < mesh.positions.size(); at += 3) {
        file << "v " << mesh.positions[at] << ' ' << mesh.positions[at + 1] << ' ' << mesh.positions[at + 2];
        if (color) file << ' ' << color->values[at] << ' ' << color->values[at + 1] << ' ' << color->values[at + 2];
        file << '\n';
    }
    std::size_t row = 0;
    ForEachElement(mesh.topology, [&](ElementKind kind, Offset element) {
        WriteElement(file, kind, ElementVertices(mesh.topology, kind, element), sharpness ? sharpness->values[row] : 0);
        ++row;
    });
    // Faces come first among the elements: their rows are their numbers.
    if (FindHoles(mesh)) {
        for (const Offset face : HolesOf(mesh)) file << "t hole 1/0/0 " << face << '\n';
    }
    for (const auto& [option, value] : mesh.scheme_options) file << TagOf(option, value);
    file.Commit();
}

}  // namespace SolidSubdiv::Io::Internal
