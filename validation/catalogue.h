// SPDX-License-Identifier: Apache-2.0
// Shapes of OpenSubdiv's catalogue as the validators take them.
#pragma once

#include <algorithm>
#include <vector>

#include <solidsubdiv/kit/io/creases.h>
#include <solidsubdiv/kit/io/mesh.h>

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

}  // namespace SolidSubdiv::Validation
