// SPDX-License-Identifier: Apache-2.0
// Fans, strips and sheets.
#include "surface_shapes.h"

#include <cmath>
#include <numbers>

#include "solid_shapes.h"

namespace SolidSubdiv::Validation {

namespace {

/// n triangles around vertex 0; closed: all the way round.
SurfaceShape Fan(int n, bool closed) {
    SurfaceShape shape{(closed ? "disc-" : "fan-") + std::to_string(n), {}, {0, 0, 0.3}};
    Shaker shaker(static_cast<std::uint32_t>(n));
    const int n_rim = closed ? n : n + 1;
    for (int i = 0; i < n_rim; ++i) {
        const double angle = (closed ? 2 : 1) * std::numbers::pi * i / n;
        for (double c : {std::cos(angle), std::sin(angle), 0.0}) shape.positions.push_back(c + 0.05 * shaker.Next());
    }
    for (int i = 0; i < n; ++i) shape.triangles.push_back({0, 1 + i, 1 + (i + 1) % n_rim});
    return shape;
}

/// A sheet of columns x rows squares cut in two, shaken; wrapped: its first column is joined to its last.
SurfaceShape Sheet(std::string name, int columns, int rows, bool wrapped) {
    SurfaceShape shape{std::move(name), {}, {}};
    Shaker shaker(5);
    const int n = wrapped ? columns : columns + 1;
    for (int j = 0; j <= rows; ++j) {
        for (int i = 0; i < n; ++i) {
            const double angle = 2 * std::numbers::pi * i / columns;
            const double x = wrapped ? std::cos(angle) * (2 + j) : i, y = wrapped ? std::sin(angle) * (2 + j) : j;
            for (double c : {x, y, 0.0}) shape.positions.push_back(c + 0.2 * shaker.Next());
        }
    }
    for (int j = 0; j < rows; ++j) {
        for (int i = 0; i < columns; ++i) {
            const int a = j * n + i, b = j * n + (i + 1) % n, c = a + n, d = b + n;
            shape.triangles.push_back({a, b, d});
            shape.triangles.push_back({a, d, c});
        }
    }
    return shape;
}

}  // namespace

std::vector<SurfaceShape> OpenSurfaces() {
    std::vector<SurfaceShape> shapes;
    for (int n = 1; n <= 8; ++n) shapes.push_back(Fan(n, false));
    for (int n = 3; n <= 12; ++n) shapes.push_back(Fan(n, true));
    shapes.push_back(Sheet("sheet", 4, 3, false));
    shapes.push_back(Sheet("annulus", 6, 2, true));
    SurfaceShape two = Sheet("two-sheets", 2, 2, false);
    const int n = static_cast<int>(two.positions.size() / 3);
    for (int v = 0; v < n; ++v) {
        for (int i = 0; i < 3; ++i) two.positions.push_back(two.positions[3 * v + i] + (i == 2 ? 3 : 0));
    }
    for (Triangle t : std::vector<Triangle>(two.triangles)) {
        for (int& v : t) v += n;
        two.triangles.push_back(t);
    }
    shapes.push_back(two);

    shapes.push_back({"bow-tie", {{0, 1, 2}, {0, 3, 4}}, {0, 0, 0, 1, 0, 0, 1, 1, 0.2, -1, 0.1, 0, -1, -1, 0}});
    shapes.push_back({"book", {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}, {0, 0, 0, 0, 0, 1, 1, 0, 0.2, -1, 0.1, 0, 0, 1, 0.4}});
    return shapes;
}

}  // namespace SolidSubdiv::Validation
