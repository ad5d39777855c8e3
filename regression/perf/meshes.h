// SPDX-License-Identifier: Apache-2.0
// The meshes that the races run on.
#pragma once

#include <cmath>
#include <numbers>

#include <solidsubdiv/far/topology_descriptor.h>

#include "test_shapes.h"

namespace SolidSubdiv::Perf {

/// 32^3 cubes of six tets, jittered: 196,608 tets, 35,937 vertices.
inline TestShapes::Shape TetBlock(bool is_quick) {
    TestShapes::Shape s = TestShapes::KuhnBlock(is_quick ? 12 : 32);
    TestShapes::Jitter(s, 0.1, 1);
    return s;
}

/// A torus of 125 x 200 quads: 50,000 triangles, 25,000 vertices. Every fourth quad, chosen by chance, is cut along its
/// other diagonal, so that vertices have 4 to 8 neighbours and three in four are irregular.
inline TestShapes::Shape Torus(bool is_quick) {
    const int m = is_quick ? 40 : 125, n = is_quick ? 63 : 200;
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

inline Far::TopologyDescriptor Describe(const TestShapes::Shape& s) {
    return {.n_vertices = s.n_vertices, .tets = s.tets, .octs = s.octs, .triangles = s.triangles, .edges = s.edges};
}

}  // namespace SolidSubdiv::Perf
