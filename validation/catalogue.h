// SPDX-License-Identifier: Apache-2.0
// OpenSubdiv's catalogue of shapes as the validators take it.
#pragma once

#include <algorithm>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <solidsubdiv/kit/io/creases.h>
#include <solidsubdiv/kit/io/formats.h>
#include <solidsubdiv/sdc/errors.h>

#include "findings.h"
#include "surface_levels.h"

namespace SolidSubdiv::Validation {

/// What an OBJ file says of sharpness. OpenSubdiv's own tools start from VTX_BOUNDARY_EDGE_ONLY.
inline SurfaceTags TagsOf(const Io::Mesh& mesh) {
    const Io::Creases creases = Io::CreasesOf(mesh);
    SurfaceTags tags;
    for (std::size_t i = 0; i < creases.edge_vertices.size(); i += 2)
        tags.creases.push_back({creases.edge_vertices[i], creases.edge_vertices[i + 1]});
    tags.crease_sharpness = creases.edge_sharpness;
    tags.corners = creases.vertices;
    tags.corner_sharpness = creases.vertex_sharpness;
    for (const auto& [name, value] : mesh.scheme_options) {
        // "none" makes holes of the faces at the border; points are those of "edge-only".
        if (name == "boundary") tags.has_sharp_corners = value == "edge-and-corner";
        if (name == "creasing") tags.is_chaikin = value == "chaikin";
    }
    return tags;
}

/// Triangles, quads and polygons.
inline std::vector<Polygon> FacesOf(const Io::Mesh& mesh) {
    const Io::Topology& t = mesh.topology;
    std::vector<Polygon> faces;
    const auto add = [&](const std::vector<Index>& all, std::size_t arity) {
        for (std::size_t i = 0; i < all.size(); i += arity) {
            faces.emplace_back(all.begin() + static_cast<std::ptrdiff_t>(i),
                               all.begin() + static_cast<std::ptrdiff_t>(i + arity));
        }
    };
    add(t.triangles, 3);
    add(t.quads, 4);
    for (Offset i = 0; i < t.n_polygons(); ++i) {
        faces.emplace_back(t.polygon_vertices.begin() + t.polygon_offsets[static_cast<std::size_t>(i)],
                           t.polygon_vertices.begin() + t.polygon_offsets[static_cast<std::size_t>(i) + 1]);
    }
    return faces;
}

/// Compares every shape whose name starts with one of the prefixes: reason(mesh) says why it can't be, or nothing;
/// compare(name, mesh) gives the findings.
template <class Reason, class Compare>
void CompareCatalogue(const std::filesystem::path& folder, std::initializer_list<std::string_view> prefixes,
                      Reason&& reason, Compare&& compare, Findings& findings) {
    if (!std::filesystem::is_directory(folder)) {
        findings.skipped.push_back("OpenSubdiv's catalogue: there is no " + folder.string());
        return;
    }
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        const std::string name = entry.path().filename().string();
        const auto starts = [&](std::string_view prefix) { return name.starts_with(prefix); };
        if (name.ends_with(".obj") && std::any_of(prefixes.begin(), prefixes.end(), starts)) {
            files.push_back(entry.path());
        }
    }
    std::sort(files.begin(), files.end());
    int n_compared = 0;
    for (const std::filesystem::path& path : files) {
        const std::string name = path.filename().string();
        const Io::Mesh mesh = Io::ReadMesh(path);
        try {
            if (const std::string why = reason(mesh); !why.empty()) {
                findings.skipped.push_back(name + ": " + why);
                continue;
            }
            findings.Merge(compare(name, mesh), name);
        } catch (const Error& error) {
            findings.Fault(name + ": " + error.what());
        }
        ++n_compared;
    }
    findings.notes.push_back(std::to_string(n_compared) + " of " + std::to_string(files.size()) +
                             " shapes of OpenSubdiv's catalogue compared");
}

}  // namespace SolidSubdiv::Validation
