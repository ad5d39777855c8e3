// SPDX-License-Identifier: Apache-2.0
// Rows of vertices; of those without one, rows of places in their corners.
#include <solidsubdiv/kit/geometry/limits_of_vertices.h>

#include <algorithm>

#include <solidsubdiv/far/limit_stencil_table.h>

namespace SolidSubdiv::Geometry {

namespace {

/// Where corner k of a face of n corners lies in it.
Far::Place CornerOf(Index face, std::size_t k, std::size_t n, bool is_polyhedral) {
    if (!is_polyhedral) return {face, 0, {k == 1 ? 1. : 0., k == 2 ? 1. : 0., 0}};
    if (n == 4) return {face, 0, {k == 1 || k == 2 ? 1. : 0., k >= 2 ? 1. : 0., 0}};
    return {face, static_cast<Index>(k), {1, 0, 0}};
}

/// For each of the vertices (ascending) that are corners of boundary faces a place there.
void FindCorners(const Far::TopologyRefiner& refiner, int level, const std::vector<Index>& wanted,
                 std::vector<Index>& vertices, std::vector<Far::Place>& places) {
    std::vector<bool> is_found(wanted.size());
    const auto look_at = [&](Index face, std::span<const Index> corners) {
        for (std::size_t k = 0; k < corners.size(); ++k) {
            const auto at = std::lower_bound(wanted.begin(), wanted.end(), corners[k]);
            const auto i = static_cast<std::size_t>(at - wanted.begin());
            if (at == wanted.end() || *at != corners[k] || is_found[i]) continue;
            is_found[i] = true;
            vertices.push_back(corners[k]);
            places.push_back(CornerOf(face, k, corners.size(), refiner.is_polyhedral()));
        }
    };
    if (refiner.is_polyhedral()) {
        const Vtr::PolyhedralLevel& l = refiner.polyhedral_level(level);
        for (Index b = 0; b < l.n_boundary_faces; ++b) look_at(b, l.BoundaryVertices(b));
    } else {
        const Far::Level& l = refiner.level(level);
        for (Index b = 0; b < l.n_boundary_faces; ++b) look_at(b, l.BoundaryVertices(b));
    }
}

}  // namespace

VertexLimits LimitsOfVertices(const Far::TopologyRefiner& refiner, const Sdc::Scheme& scheme, int level) {
    const auto at_vertices = Far::LimitStencilTable::Create(refiner, scheme, {.level = level});
    if (at_vertices.without_limit().empty()) return {at_vertices.rows(), {}};

    std::vector<Index> vertices;
    std::vector<Far::Place> places;
    FindCorners(refiner, level, at_vertices.without_limit(), vertices, places);
    const auto at_corners = Far::LimitStencilTable::Create(refiner, scheme, places,
                                                           {.level = level, .elements = Far::Elements::BoundaryFaces});
    const auto& missing = at_corners.without_limit();
    std::vector<Index> corner_of(static_cast<std::size_t>(refiner.n_vertices(level)), kNoIndex);
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const auto corner = static_cast<Index>(i);
        if (std::binary_search(missing.begin(), missing.end(), corner)) continue;
        corner_of[static_cast<std::size_t>(vertices[i])] = corner;
    }

    VertexLimits limits;
    limits.rows.n_sources = at_vertices.rows().n_sources;
    const auto add = [&](std::span<const Index> indices, std::span<const double> weights) {
        limits.rows.indices.insert(limits.rows.indices.end(), indices.begin(), indices.end());
        limits.rows.weights.insert(limits.rows.weights.end(), weights.begin(), weights.end());
        limits.rows.offsets.push_back(static_cast<Offset>(limits.rows.indices.size()));
    };
    for (Index v = 0; v < at_vertices.rows().n_rows(); ++v) {
        const Index corner = corner_of[static_cast<std::size_t>(v)];
        if (corner != kNoIndex) {
            add(at_corners.rows().Indices(corner), at_corners.rows().Weights(corner));
        } else if (std::binary_search(at_vertices.without_limit().begin(), at_vertices.without_limit().end(), v)) {
            const double itself = 1;
            add({&v, 1}, {&itself, 1});
            limits.without_limit.push_back(v);
        } else {
            add(at_vertices.rows().Indices(v), at_vertices.rows().Weights(v));
        }
    }
    return limits;
}

}  // namespace SolidSubdiv::Geometry
