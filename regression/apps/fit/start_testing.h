// SPDX-License-Identifier: Apache-2.0
// What tests of starts share: targets, and what a lattice must be.
#pragma once

#include <solidsubdiv/apps/fit/start.h>
#include <solidsubdiv/far/topology_refiner.h>
#include <solidsubdiv/kit/geometry/surface_components.h>

#include <cmath>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "apps/deform/sphere_testing.h"
#include "apps/fit/surface_testing.h"
#include "cube_surface.h"

namespace SolidSubdiv::Fit {

/// The unit cube, each face of n x n squares cut in two.
inline Surface Cube(int n, double size = 1) {
    const CubeSurface of_quads(n);
    Surface cube;
    for (const auto& v : of_quads.vertices) {
        for (int c : v) cube.positions.push_back(size * c / n);
    }
    for (const auto& q : of_quads.quads) {
        cube.triangles.insert(cube.triangles.end(), {q[0], q[1], q[2], q[0], q[2], q[3]});
    }
    return cube;
}

inline Surface SphereAt(const std::array<double, 3>& center, double radius) {
    const TestShapes::Sphere sphere(12, radius, center);
    return {sphere.points, sphere.triangles};
}

/// Around the axis (0, .3, 1): n by n quads of two triangles each.
inline Surface Torus(int n, double tube = .6) {
    Surface s;
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
            const double a = 2 * 3.14159265358979323846 * i / n, b = 2 * 3.14159265358979323846 * j / n;
            const double r = 2 + tube * std::cos(b), x = r * std::cos(a), y = r * std::sin(a), z = tube * std::sin(b);
            s.positions.insert(s.positions.end(), {x, y - .3 * z, z + .3 * y});
            const auto id = [&](int u, int v) { return static_cast<Index>(u % n * n + v % n); };
            s.triangles.insert(s.triangles.end(), {id(i, j), id(i + 1, j), id(i + 1, j + 1)});
            s.triangles.insert(s.triangles.end(), {id(i, j), id(i + 1, j + 1), id(i, j + 1)});
        }
    }
    return s;
}

/// The scan that the repository carries: closed, of genus 0. OBJ with triangles only.
inline Surface Bunny() {
    Surface s;
    std::ifstream file(SOLIDSUBDIV_SHAPES "/demo/bunny.obj");
    for (std::string word; file >> word;) {
        if (word == "v") {
            double x, y, z;
            file >> x >> y >> z;
            s.positions.insert(s.positions.end(), {x, y, z});
        } else if (word == "f") {
            for (int k = 0; k < 3; ++k) {
                file >> word;
                s.triangles.push_back(static_cast<Index>(std::stoi(word)) - 1);
            }
        } else {
            std::getline(file, word);
        }
    }
    return s;
}

/// The triangles and quads of a surface, or those that only one cell of a solid has.
inline std::vector<Geometry::SurfaceComponent> BoundaryOf(const ControlMesh& mesh) {
    const auto refiner = Far::TopologyRefiner::Create(mesh.View(), Sdc::Split::Polyhedral);
    const auto& level = refiner.polyhedral_level(0);
    std::vector<Offset> offsets{0};
    std::vector<Index> corners;
    for (Index f = 0; f < level.n_boundary_faces; ++f) {
        const auto row = level.boundary_rows.Row(level.boundary_vertices, f);
        corners.insert(corners.end(), row.begin(), row.end());
        offsets.push_back(static_cast<Offset>(corners.size()));
    }
    return Geometry::SurfaceComponents(offsets, corners, mesh.n_vertices());
}

inline Offset EulerOf(const std::vector<Geometry::SurfaceComponent>& components) {
    Offset euler = 0;
    for (const auto& c : components) euler += c.EulerCharacteristic();
    return euler;
}

/// The least determinant of three edges of a cell at one of its corners; of octahedra, of the tets around the major
/// diagonal.
inline double LeastDeterminant(const ControlMesh& mesh) {
    double least = std::numeric_limits<double>::infinity();
    const auto add = [&](Index v, Index a, Index b, Index c) {
        std::array<std::array<double, 3>, 3> e{};
        for (std::size_t k = 0; k < 3; ++k) {
            const auto at = [&](Index i) { return mesh.positions[3 * static_cast<std::size_t>(i) + k]; };
            e[0][k] = at(a) - at(v), e[1][k] = at(b) - at(v), e[2][k] = at(c) - at(v);
        }
        least = std::min(least, e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) +
                                    e[0][1] * (e[1][2] * e[2][0] - e[1][0] * e[2][2]) +
                                    e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0]));
    };
    for (std::size_t c = 0; c < mesh.hexes.size(); c += 8) {
        const Index* const v = &mesh.hexes[c];
        for (std::size_t j = 0; j < 4; ++j) {
            add(v[j], v[(j + 1) % 4], v[(j + 3) % 4], v[j + 4]);
            add(v[j + 4], v[4 + (j + 3) % 4], v[4 + (j + 1) % 4], v[j]);
        }
    }
    for (std::size_t c = 0; c < mesh.tets.size(); c += 4) {
        add(mesh.tets[c], mesh.tets[c + 1], mesh.tets[c + 2], mesh.tets[c + 3]);
    }
    for (std::size_t c = 0; c < mesh.octs.size(); c += 6) {
        const Index* const v = &mesh.octs[c];
        for (const auto& [i, j] : std::map<int, int>{{2, 4}, {4, 3}, {3, 5}, {5, 2}}) add(v[0], v[1], v[i], v[j]);
    }
    return least;
}

}  // namespace SolidSubdiv::Fit
