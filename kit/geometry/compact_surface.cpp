// SPDX-License-Identifier: Apache-2.0
// A surface taken out of a larger mesh.
#include <solidsubdiv/kit/geometry/compact_surface.h>

namespace SolidSubdiv::Geometry {

CompactSurface MakeCompactSurface(std::span<const Index> corners, Index n_vertices) {
    std::vector<Index> place(static_cast<std::size_t>(n_vertices), kNoIndex);
    for (Index v : corners) place[v] = 0;
    CompactSurface surface;
    for (Index v = 0; v < n_vertices; ++v) {
        if (place[v] == kNoIndex) continue;
        place[v] = static_cast<Index>(surface.vertices.size());
        surface.vertices.push_back(v);
    }
    surface.corners.reserve(corners.size());
    for (Index v : corners) surface.corners.push_back(place[v]);
    return surface;
}

CompactSurface ExtractBoundary(const Vtr::Level& level) {
    return MakeCompactSurface(level.boundary_vertices, level.n_vertices);
}

CompactSurface ExtractBoundary(const Vtr::PolyhedralLevel& level) {
    return MakeCompactSurface(level.boundary_vertices, level.n_vertices);
}

std::vector<double> GatherRows(std::span<const double> rows, int width, std::span<const Index> vertices) {
    std::vector<double> gathered;
    gathered.reserve(vertices.size() * static_cast<std::size_t>(width));
    for (Index v : vertices) {
        const auto row = rows.subspan(static_cast<std::size_t>(v) * width, static_cast<std::size_t>(width));
        gathered.insert(gathered.end(), row.begin(), row.end());
    }
    return gathered;
}

}  // namespace SolidSubdiv::Geometry
