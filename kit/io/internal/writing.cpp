// SPDX-License-Identifier: Apache-2.0
// What writers share.
#include <solidsubdiv/kit/io/internal/writing.h>

#include <algorithm>
#include <cmath>

#include <solidsubdiv/kit/io/internal/files.h>
#include <solidsubdiv/kit/io/internal/text.h>
#include <solidsubdiv/sdc/errors.h>

namespace SolidSubdiv::Io::Internal {

void RequireKinds(const std::filesystem::path& path, const Mesh& mesh, std::string_view format,
                  std::span<const ElementKind> kinds) {
    for (const ElementKind kind : kAllElementKinds) {
        const Offset n = CountOf(mesh.topology, kind);
        if (n == 0 || std::find(kinds.begin(), kinds.end(), kind) != kinds.end()) continue;
        Fail(NameOf(path), std::string(format) + " files can't hold " + std::string(InfoOf(kind).plural) +
                               ", the mesh has " + std::to_string(n) +
                               "; choose another format, .vtu holds everything");
    }
}

const Attribute* FindLabels(std::span<const Attribute> attributes, std::string_view name) {
    const auto is_label = [](double v) { return v >= -2147483648.0 && v <= 2147483647.0 && v == std::floor(v); };
    for (const Attribute& a : attributes) {
        if (a.name == name && a.width == 1 && std::all_of(a.values.begin(), a.values.end(), is_label)) return &a;
    }
    return nullptr;
}

void RequireConsistent(const Mesh& mesh) {
    const auto require = [](bool good, const std::string& what) {
        if (!good) throw InvalidInput("mesh to write: " + what);
    };
    const auto require_rows = [&](const Attribute& a, Offset rows) {
        require(a.width >= 1 && static_cast<Offset>(a.values.size()) == rows * a.width,
                "attribute " + Quoted(a.name) + " has " + std::to_string(a.values.size()) + " numbers; it needs " +
                    std::to_string(rows) + " rows of " + std::to_string(a.width));
    };
    const Topology& topology = mesh.topology;
    require(mesh.positions.size() == 3 * static_cast<std::size_t>(topology.n_vertices),
            "it has " + std::to_string(topology.n_vertices) + " vertices and " + std::to_string(mesh.positions.size()) +
                " coordinates");
    for (const ElementKind kind : kAllElementKinds) {
        for (const Index v : VerticesOf(topology, kind)) {
            require(v >= 0 && v < topology.n_vertices,
                    "one of the " + std::string(InfoOf(kind).plural) + " names vertex " + std::to_string(v));
        }
    }
    for (const Attribute& a : mesh.point_data) require_rows(a, topology.n_vertices);
    for (const Attribute& a : mesh.cell_data) require_rows(a, topology.n_elements());
}

}  // namespace SolidSubdiv::Io::Internal
