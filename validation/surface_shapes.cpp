// SPDX-License-Identifier: Apache-2.0
// Fans, strips and sheets.
#include "surface_shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <random>
#include <set>

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

SurfaceTags RandomTags(const std::vector<Triangle>& triangles, std::uint32_t seed, bool infinite) {
    std::vector<Polygon> faces;
    for (const Triangle& t : triangles) faces.emplace_back(t.begin(), t.end());
    return RandomTags(faces, seed, infinite);
}

SurfaceTags RandomTags(const std::vector<Polygon>& faces, std::uint32_t seed, bool infinite) {
    std::map<std::array<int, 2>, int> faces_of_edge;
    std::set<int> vertices;
    for (const Polygon& face : faces) {
        for (std::size_t i = 0; i < face.size(); ++i) {
            const int a = face[i], b = face[(i + 1) % face.size()];
            ++faces_of_edge[{std::min(a, b), std::max(a, b)}];
            vertices.insert(a);
        }
    }
    std::mt19937 random(seed);
    const std::array<float, 8> kinds{0.3f, 0.5f, 1, 1.7f, 2, 2.6f, 3.9f, 10};
    const auto sharpness = [&] { return infinite ? 10.0f : kinds[random() % kinds.size()]; };
    SurfaceTags tags;
    std::map<int, int> n_semi_sharp;  // at each vertex
    for (const auto& [edge, n_faces] : faces_of_edge) {
        if (random() % 3 != 0) continue;
        float s = sharpness();
        const bool is_full = n_semi_sharp[edge[0]] == 2 || n_semi_sharp[edge[1]] == 2;
        if (n_faces == 2 && s < 10) {
            if (is_full)
                s = 10;
            else
                for (int v : edge) ++n_semi_sharp[v];
        }
        tags.creases.push_back(edge);
        tags.crease_sharpness.push_back(s);
    }
    for (int v : vertices) {
        if (random() % 6 != 0) continue;
        tags.corners.push_back(v);
        tags.corner_sharpness.push_back(sharpness());
    }
    return tags;
}

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

std::vector<SurfaceShape> AllSurfaces() {
    std::vector<SurfaceShape> shapes = OpenSurfaces();
    for (const SolidShape& solid : ManifoldShapes())
        shapes.push_back({"boundary of " + solid.name, BoundaryTriangles(solid.complex), solid.positions});
    return shapes;
}

}  // namespace SolidSubdiv::Validation
