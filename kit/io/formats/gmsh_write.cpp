// SPDX-License-Identifier: Apache-2.0
// Writes Gmsh meshes (.msh) as version 2.2 in text form, which carries labels element by element and which most
// programs read.
#include <array>
#include <string>

#include <solidsubdiv/kit/io/internal/files.h>
#include <solidsubdiv/kit/io/internal/octahedra.h>
#include <solidsubdiv/kit/io/internal/writers.h>
#include <solidsubdiv/kit/io/internal/writing.h>

namespace SolidSubdiv::Io::Internal {

namespace {

int GmshTypeOf(ElementKind kind) {
    switch (kind) {
        case ElementKind::Tet:
            return 4;
        case ElementKind::Hex:
            return 5;
        case ElementKind::Wedge:
            return 6;
        case ElementKind::Pyramid:
            return 7;
        case ElementKind::Triangle:
            return 2;
        case ElementKind::Quad:
            return 3;
        case ElementKind::Edge:
            return 1;
        default:
            return 15;
    }
}

void WriteData(OutputFile& file, const char* section, const Attribute& attribute) {
    const auto width = static_cast<std::size_t>(attribute.width);
    const std::size_t n = attribute.values.size() / width;
    std::string name = attribute.name;
    for (char& c : name) {
        if (c == '"' || c == '\n' || c == '\r') c = '_';
    }
    // One name, one time (0), three integers: step, components, rows.
    file << '$' << section << "\n1\n\"" << name << "\"\n1\n0\n3\n0\n" << attribute.width << '\n' << n << '\n';
    for (std::size_t i = 0; i < n; ++i) {
        file << i + 1;
        for (std::size_t k = 0; k < width; ++k) file << ' ' << attribute.values[i * width + k];
        file << '\n';
    }
    file << "$End" << section << '\n';
}

void Write(const std::filesystem::path& path, const Mesh& mesh) {
    constexpr std::array kinds = {ElementKind::Tet,      ElementKind::Hex,  ElementKind::Wedge, ElementKind::Pyramid,
                                  ElementKind::Triangle, ElementKind::Quad, ElementKind::Edge,  ElementKind::Vertex};
    RequireKinds(path, mesh, "Gmsh", kinds);
    const Attribute* physical = FindLabels(mesh.cell_data, "physical");
    const Attribute* elementary = FindLabels(mesh.cell_data, "elementary");

    OutputFile file(path);
    file << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n" << mesh.topology.n_vertices << '\n';
    for (std::size_t at = 0; at < mesh.positions.size(); at += 3) {
        file << at / 3 + 1 << ' ' << mesh.positions[at] << ' ' << mesh.positions[at + 1] << ' '
             << mesh.positions[at + 2] << '\n';
    }
    file << "$EndNodes\n$Elements\n" << mesh.topology.n_elements() << '\n';
    std::size_t row = 0;
    ForEachElement(mesh.topology, [&](ElementKind kind, Offset element) {
        file << row + 1 << ' ' << GmshTypeOf(kind) << " 2 " << LabelOf(physical, row) << ' '
             << LabelOf(elementary, row);
        const std::span<const Index> v = ElementVertices(mesh.topology, kind, element);
        for (std::size_t i = 0; i < v.size(); ++i) {
            file << ' ' << v[kind == ElementKind::Wedge ? kTurnedWedge[i] : i] + 1;
        }
        file << '\n';
        ++row;
    });
    file << "$EndElements\n";
    for (const Attribute& a : mesh.point_data) WriteData(file, "NodeData", a);
    for (const Attribute& a : mesh.cell_data) {
        if (&a != physical && &a != elementary) WriteData(file, "ElementData", a);
    }
    file.Commit();
}

}  // namespace

void WriteGmsh(const std::filesystem::path& path, const Mesh& mesh, const WriteOptions&) {
    mesh.topology.octs.empty() ? Write(path, mesh) : Write(path, CutOctahedra(mesh));
}

}  // namespace SolidSubdiv::Io::Internal
