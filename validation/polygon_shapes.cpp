// SPDX-License-Identifier: Apache-2.0
// Polygons and hexahedra.
#include "polygon_shapes.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <set>

#include "sharp_features.h"
#include "solid_shapes.h"
#include "surface_shapes.h"

namespace SolidSubdiv::Validation {

namespace {

using CellFaces = std::array<std::array<int, 4>, 6>;
/// A hexahedron's faces, seen from outside.
constexpr CellFaces kFaces{{{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};

/// n quadrilaterals around vertex 0; closed: all the way round.
PolygonShape QuadFan(int n, bool closed) {
    PolygonShape shape{(closed ? "quad-disc-" : "quad-fan-") + std::to_string(n), {}, {0, 0, 0.4}};
    Shaker shaker(static_cast<std::uint32_t>(n));
    const int n_rim = closed ? 2 * n : 2 * n + 1;
    for (int i = 0; i < n_rim; ++i) {
        const double angle = (closed ? 1.0 : 0.5) * std::numbers::pi * i / n;
        const double r = i % 2 == 0 ? 1 : 1.3;
        for (double c : {r * std::cos(angle), r * std::sin(angle), 0.0})
            shape.positions.push_back(c + 0.05 * shaker.Next());
    }
    for (int i = 0; i < n; ++i) {
        shape.faces.push_back({0, 1 + 2 * i, 1 + (2 * i + 1) % n_rim, 1 + (2 * i + 2) % n_rim});
    }
    return shape;
}

/// Squares of a sheet of which every third is cut in two and some are joined to hexagons; wrapped both ways: a torus.
PolygonShape Sheet(std::string name, int columns, int rows, bool wrapped, bool mixed) {
    PolygonShape shape{std::move(name), {}, {}};
    Shaker shaker(7);
    const int nx = wrapped ? columns : columns + 1, ny = wrapped ? rows : rows + 1;
    for (int j = 0; j < ny; ++j) {
        for (int i = 0; i < nx; ++i) {
            const double a = 2 * std::numbers::pi * i / columns, b = 2 * std::numbers::pi * j / rows;
            const double r = 3 + std::cos(b);
            const std::array<double, 3> flat{1.0 * i, 1.0 * j, 0}, torus{r * std::cos(a), r * std::sin(a), std::sin(b)};
            for (double c : wrapped ? torus : flat) shape.positions.push_back(c + 0.15 * shaker.Next());
        }
    }
    const auto id = [&](int i, int j) { return j % ny * nx + i % nx; };
    for (int j = 0; j < rows; ++j) {
        for (int i = 0; i < columns; ++i) {
            const int a = id(i, j), b = id(i + 1, j), c = id(i + 1, j + 1), d = id(i, j + 1);
            if (mixed && (i + j) % 3 == 1) {
                shape.faces.push_back({a, b, c});
                shape.faces.push_back({a, c, d});
            } else if (mixed && i + 1 < columns && (i + 2 * j) % 5 == 0 && (i + j) % 3 == 0) {
                ++i;
                if ((i + j) % 3 == 1) {
                    shape.faces.push_back({a, b, id(i + 1, j), id(i + 1, j + 1), c, d});
                } else {
                    --i;
                    shape.faces.push_back({a, b, c, d});
                }
            } else {
                shape.faces.push_back({a, b, c, d});
            }
        }
    }
    return shape;
}

HexShape Voxels(std::string name, int nx, int ny, int nz, const std::function<bool(int, int, int)>& keep) {
    HexShape shape{std::move(name), {}, {}};
    Shaker shaker(11);
    const auto id = [&](int x, int y, int z) { return x + (nx + 1) * (y + (ny + 1) * z); };
    for (int z = 0; z <= nz; ++z) {
        for (int y = 0; y <= ny; ++y) {
            for (int x = 0; x <= nx; ++x) {
                for (int c : {x, y, z}) shape.positions.push_back(c + 0.2 * shaker.Next());
            }
        }
    }
    for (int z = 0; z < nz; ++z) {
        for (int y = 0; y < ny; ++y) {
            for (int x = 0; x < nx; ++x) {
                if (!keep(x, y, z)) continue;
                shape.cells.push_back({id(x, y, z), id(x + 1, y, z), id(x + 1, y + 1, z), id(x, y + 1, z),
                                       id(x, y, z + 1), id(x + 1, y, z + 1), id(x + 1, y + 1, z + 1),
                                       id(x, y + 1, z + 1)});
            }
        }
    }
    return shape;
}

}  // namespace

std::vector<HexShape> HexShapes() {
    const auto all = [](int, int, int) { return true; };
    return {Voxels("cube", 1, 1, 1, all),
            Voxels("bar", 3, 1, 1, all),
            Voxels("block", 3, 3, 3, all),
            Voxels("l", 2, 2, 1, [](int x, int y, int) { return x + y < 2; }),
            Voxels("step", 2, 2, 2, [](int x, int y, int z) { return x + y + z < 2; }),
            Voxels("hole through", 3, 3, 2, [](int x, int y, int) { return x != 1 || y != 1; }),
            Voxels("hole inside", 3, 3, 3, [](int x, int y, int z) { return x != 1 || y != 1 || z != 1; }),
            Voxels("two pieces", 3, 1, 1, [](int x, int, int) { return x != 1; }),
            Voxels("meeting in an edge", 2, 2, 1, [](int x, int y, int) { return x == y; }),
            Voxels("meeting in a vertex", 2, 2, 2, [](int x, int y, int z) { return x == y && y == z; })};
}

std::vector<Polygon> BoundaryOf(const HexShape& shape) {
    std::map<std::array<int, 4>, std::vector<Polygon>> faces;
    for (const auto& cell : shape.cells) {
        for (const auto& corners : kFaces) {
            std::array<int, 4> face{};
            for (std::size_t k = 0; k < 4; ++k) face[k] = cell[static_cast<std::size_t>(corners[k])];
            std::array<int, 4> key = face;
            std::sort(key.begin(), key.end());
            faces[key].emplace_back(face.begin(), face.end());
        }
    }
    std::vector<Polygon> boundary;
    for (const auto& [key, seen] : faces) {
        if (seen.size() == 1) boundary.push_back(seen[0]);
    }
    return boundary;
}

SurfaceTags SharpFeaturesOf(const HexShape& shape) {
    std::vector<std::vector<std::array<int, 2>>> edges_of_cells;
    for (const auto& cell : shape.cells) {
        std::set<std::array<int, 2>> edges;
        for (const auto& face : kFaces) {
            for (std::size_t k = 0; k < 4; ++k) {
                const int a = cell[static_cast<std::size_t>(face[k])],
                          b = cell[static_cast<std::size_t>(face[(k + 1) % 4])];
                edges.insert({std::min(a, b), std::max(a, b)});
            }
        }
        edges_of_cells.emplace_back(edges.begin(), edges.end());
    }
    return SharpFeaturesOf(edges_of_cells);
}

std::vector<PolygonShape> PolygonShapes() {
    std::vector<PolygonShape> shapes;
    for (int n = 1; n <= 5; ++n) shapes.push_back(QuadFan(n, false));
    for (int n = 3; n <= 8; ++n) shapes.push_back(QuadFan(n, true));
    shapes.push_back(Sheet("quad sheet", 4, 3, false, false));
    shapes.push_back(Sheet("quad torus", 6, 4, true, false));
    shapes.push_back(Sheet("mixed sheet", 7, 5, false, true));
    shapes.push_back(Sheet("mixed torus", 9, 6, true, true));
    for (const HexShape& solid : HexShapes()) {
        shapes.push_back({"boundary of " + solid.name, BoundaryOf(solid), solid.positions});
    }
    for (const SurfaceShape& surface : AllSurfaces()) {
        PolygonShape shape{surface.name, {}, surface.positions};
        for (const Triangle& t : surface.triangles) shape.faces.emplace_back(t.begin(), t.end());
        shapes.push_back(std::move(shape));
    }
    return shapes;
}

}  // namespace SolidSubdiv::Validation
