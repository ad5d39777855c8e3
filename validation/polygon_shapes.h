// SPDX-License-Identifier: Apache-2.0
// Surfaces of polygons and blocks of hexahedra, one for each feature.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "surface_levels.h"

namespace SolidSubdiv::Validation {

struct PolygonShape {
    std::string name;
    std::vector<Polygon> faces;
    std::vector<double> positions;  ///< (n_vertices, 3), shaken
};

/// Fans, sheets, mixed faces, boundaries of blocks, and the triangle surfaces of surface_shapes.h as polygons.
std::vector<PolygonShape> PolygonShapes();

/// Hexahedra in VTK's order.
struct HexShape {
    std::string name;
    std::vector<std::array<int, 8>> cells;
    std::vector<double> positions;
};

/// Blocks, an L, holes through and inside, cubes that meet in edges and vertices.
std::vector<HexShape> HexShapes();

/// Faces that one cell has, seen from outside.
std::vector<Polygon> BoundaryOf(const HexShape& shape);

/// Edges and vertices that one cell has: what is sharp under sharp features.
SurfaceTags SharpFeaturesOf(const HexShape& shape);

}  // namespace SolidSubdiv::Validation
