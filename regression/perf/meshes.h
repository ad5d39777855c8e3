// SPDX-License-Identifier: Apache-2.0
// The meshes that the races run on.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <numbers>

#include <solidsubdiv/far/topology_descriptor.h>
#include <solidsubdiv/kit/io/mesh.h>

#include "test_shapes.h"

namespace SolidSubdiv::Perf {

/// 32^3 cubes of six tets, jittered: 196,608 tets, 35,937 vertices.
inline TestShapes::Shape TetBlock(bool is_quick) {
    TestShapes::Shape s = TestShapes::KuhnBlock(is_quick ? 12 : 32);
    TestShapes::Jitter(s, 0.1, 1);
    return s;
}

/// A torus of m x n quads, each cut into two triangles. Every fourth quad, chosen by chance, is cut along its other
/// diagonal, so that vertices have 4 to 8 neighbours and three in four are irregular.
inline TestShapes::Shape Torus(int m, int n) {
    TestShapes::Shape s;
    TestShapes::Random random(2);
    s.n_vertices = m * n;
    for (int i = 0; i < m; ++i) {
        for (int j = 0; j < n; ++j) {
            const double a = 2 * std::numbers::pi * i / m, b = 2 * std::numbers::pi * j / n;
            const double r = 2 + std::cos(a);
            s.positions.insert(s.positions.end(), {r * std::cos(b), r * std::sin(b), std::sin(a)});
            const auto id = [&](int p, int q) { return static_cast<Index>((p % m) * n + q % n); };
            const Index v[] = {id(i, j), id(i + 1, j), id(i + 1, j + 1), id(i, j + 1)};
            const int k = random.Below(4) == 0;
            for (int corner : {0, 1, 2, 0, 2, 3}) s.triangles.push_back(v[(corner + k) % 4]);
        }
    }
    TestShapes::Jitter(s, 0.002, 3);
    return s;
}
/// 50,000 triangles, 25,000 vertices.
inline TestShapes::Shape Torus(bool is_quick) { return is_quick ? Torus(40, 63) : Torus(125, 200); }

/// 50,112 quadrilaterals, 50,112 vertices: three in each triangle of a torus, around its centre.
inline Io::Mesh QuadTorus(bool is_quick) {
    const TestShapes::Shape s = is_quick ? Torus(24, 36) : Torus(72, 116);
    Io::Mesh mesh;
    mesh.positions = s.positions;
    mesh.topology.n_vertices = s.n_vertices;
    const auto mean = [&](std::initializer_list<Index> vertices) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            double sum = 0;
            for (Index v : vertices) sum += s.positions[3 * static_cast<std::size_t>(v) + axis];
            mesh.positions.push_back(sum / static_cast<double>(vertices.size()));
        }
        return mesh.topology.n_vertices++;
    };
    std::map<std::pair<Index, Index>, Index> middles;
    const auto middle = [&](Index a, Index b) {
        const auto [at, is_new] = middles.try_emplace(std::minmax(a, b), kNoIndex);
        if (is_new) at->second = mean({a, b});
        return at->second;
    };
    for (std::size_t t = 0; t < s.triangles.size(); t += 3) {
        const Index* const v = &s.triangles[t];
        const Index centre = mean({v[0], v[1], v[2]});
        for (int k = 0; k < 3; ++k) {
            const Index before = v[(k + 2) % 3], next = v[(k + 1) % 3];
            const Index corners[] = {v[k], middle(v[k], next), centre, middle(before, v[k])};
            mesh.topology.quads.insert(mesh.topology.quads.end(), std::begin(corners), std::end(corners));
        }
    }
    return mesh;
}

/// A mesh of the local collection, which the repository may not carry.
inline std::filesystem::path LocalMesh(const char* name) {
    const char* const given = std::getenv("SOLIDSUBDIV_DATA");
    return std::filesystem::path(given ? given : SOLIDSUBDIV_DATA) / name;
}

inline Far::TopologyDescriptor Describe(const TestShapes::Shape& s) {
    return {.n_vertices = s.n_vertices, .tets = s.tets, .octs = s.octs, .triangles = s.triangles, .edges = s.edges};
}

}  // namespace SolidSubdiv::Perf
