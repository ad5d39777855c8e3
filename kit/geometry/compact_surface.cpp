// SPDX-License-Identifier: Apache-2.0
// A surface taken out of a larger mesh.
#include <solidsubdiv/kit/geometry/compact_surface.h>

#include <utility>

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

namespace {

BoundarySurface Extract(const Array<Index>& corners, const Vtr::RowOffsets& rows, Index n_vertices,
                        const std::vector<bool>& is_left_out) {
    if (is_left_out.empty()) return {MakeCompactSurface(corners, n_vertices), rows};
    std::vector<Index> kept;
    Vtr::RowOffsets kept_rows{{}, rows.fixed};
    if (!rows.is_fixed()) kept_rows.offsets.push_back(0);
    for (std::size_t b = 0; b < is_left_out.size(); ++b) {
        if (is_left_out[b]) continue;
        const auto face = rows.Row(corners, static_cast<Index>(b));
        kept.insert(kept.end(), face.begin(), face.end());
        if (!rows.is_fixed()) kept_rows.offsets.push_back(static_cast<Offset>(kept.size()));
    }
    return {MakeCompactSurface(kept, n_vertices), std::move(kept_rows)};
}

}  // namespace

BoundarySurface ExtractBoundary(const Vtr::Level& level, const std::vector<bool>& is_left_out) {
    return Extract(level.boundary_vertices, {{}, 3}, level.n_vertices, is_left_out);
}

BoundarySurface ExtractBoundary(const Vtr::PolyhedralLevel& level, const std::vector<bool>& is_left_out) {
    return Extract(level.boundary_vertices, level.boundary_rows, level.n_vertices, is_left_out);
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
