// SPDX-License-Identifier: Apache-2.0
// Triangle surfaces with their tags, and their refinements by other programs, as plain arrays.
#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "cells_oracle.h"

namespace SolidSubdiv::Validation {

/// A face by its vertices, in order.
using Polygon = std::vector<int>;

/// One level of another program's refinement, and how it goes on: which vertices of the next level its parts become.
struct SurfaceLevel {
    int n_vertices = 0;
    std::vector<double> positions;  ///< (n_vertices, 3)
    std::vector<Triangle> triangles;
    std::vector<std::array<int, 2>> edges;

    std::vector<int> children_of_vertices;  ///< (n_vertices), empty in the last level
    std::vector<int> children_of_edges;     ///< (n_edges)

    std::vector<Polygon> faces;          ///< of surfaces of polygons, in place of triangles
    std::vector<int> children_of_faces;  ///< (n_faces), empty in the last level

    /// Composite rows over the control vertices, in levels 1 to max_row_level: row v in [offsets[v], offsets[v + 1]).
    std::vector<std::int64_t> row_offsets;
    std::vector<int> row_indices;
    std::vector<double> row_weights;
};

/// What is sharp, and how sharpness goes on.
struct SurfaceTags {
    std::vector<std::array<int, 2>> creases{};
    std::vector<float> crease_sharpness{};
    std::vector<int> corners{};
    std::vector<float> corner_sharpness{};
    bool has_sharp_corners = false;  ///< VTX_BOUNDARY_EDGE_AND_CORNER; otherwise VTX_BOUNDARY_EDGE_ONLY
    bool is_chaikin = false;         ///< CREASE_CHAIKIN; otherwise CREASE_UNIFORM
};

struct ControlSurface {
    int n_vertices = 0;  ///< all of them in some triangle
    std::vector<Triangle> triangles;
    std::vector<double> positions;  ///< (n_vertices, 3)
    SurfaceTags tags{};
};

/// A surface of faces of any number of corners, under Catmull-Clark's rules or linearly.
struct PolygonSurface {
    int n_vertices = 0;  ///< all of them in some face
    std::vector<Polygon> faces;
    std::vector<double> positions;  ///< (n_vertices, 3)
    SurfaceTags tags{};
    bool has_smooth_triangles = false;  ///< TRI_SUB_SMOOTH; otherwise TRI_SUB_CATMARK
    bool is_bilinear = false;           ///< SCHEME_BILINEAR; otherwise SCHEME_CATMARK
};

/// The surface with infinitely sharp edges and vertices.
inline ControlSurface WithCreases(ControlSurface surface, std::vector<std::array<int, 2>> creases,
                                  std::vector<int> corners = {}) {
    surface.tags.crease_sharpness.assign(creases.size(), 10.0f);
    surface.tags.corner_sharpness.assign(corners.size(), 10.0f);
    surface.tags.creases = std::move(creases);
    surface.tags.corners = std::move(corners);
    return surface;
}

}  // namespace SolidSubdiv::Validation
