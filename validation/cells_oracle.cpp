// SPDX-License-Identifier: Apache-2.0
// Parts of cells by sets of vertices.
#include "cells_oracle.h"

#include <algorithm>
#include <map>
#include <set>

namespace SolidSubdiv::Validation {

namespace {

template <std::size_t N>
std::array<int, N> Ascending(std::array<int, N> set) {
    std::sort(set.begin(), set.end());
    return set;
}

/// Calls function(a, b, c) for the faces of every cell, counterclockwise from outside where the cell is positive.
template <class Function>
void ForEachFace(const Complex& complex, Function&& function) {
    for (const auto& t : complex.tets) {
        function(t[1], t[2], t[3]);
        function(t[0], t[3], t[2]);
        function(t[0], t[1], t[3]);
        function(t[0], t[2], t[1]);
    }
    for (const auto& o : complex.octs) {
        for (int corner = 0; corner < 8; ++corner) {
            const int i = corner & 1, j = (corner >> 1) & 1, k = (corner >> 2) & 1;
            // det(v0-c, v2-c, v4-c) < 0 means that v0 v2 v4 run clockwise seen from outside; each opposite vertex taken
            // instead turns that round.
            if ((i + j + k) % 2 == 0) {
                function(o[i], o[4 + k], o[2 + j]);
            } else {
                function(o[i], o[2 + j], o[4 + k]);
            }
        }
    }
}

}  // namespace

PartCounts CountParts(const Complex& complex) {
    std::set<int> vertices;
    std::set<std::array<int, 2>> edges;
    std::set<Triangle> faces;
    ForEachFace(complex, [&](int a, int b, int c) {
        vertices.insert({a, b, c});
        edges.insert(Ascending<2>({a, b}));
        edges.insert(Ascending<2>({b, c}));
        edges.insert(Ascending<2>({c, a}));
        faces.insert(Ascending<3>({a, b, c}));
    });
    const auto count = [](const auto& set) { return static_cast<std::int64_t>(set.size()); };
    return {count(vertices), count(edges), count(faces), count(complex.tets), count(complex.octs)};
}

PartCounts CountsAfterSplit(const PartCounts& n) {
    return {.n_vertices = n.n_vertices + n.n_edges + n.n_octs,
            .n_edges = 2 * n.n_edges + 3 * n.n_faces + 12 * n.n_octs,
            .n_faces = 4 * n.n_faces + 4 * n.n_tets + 24 * n.n_octs,
            .n_tets = 4 * n.n_tets + 8 * n.n_octs,
            .n_octs = n.n_tets + 6 * n.n_octs};
}

std::vector<Triangle> BoundaryTriangles(const Complex& complex) {
    struct Side {
        Triangle oriented{};
        int n_cells = 0;
    };
    std::map<Triangle, Side> sides;
    ForEachFace(complex, [&](int a, int b, int c) {
        Side& side = sides[Ascending<3>({a, b, c})];
        side.oriented = {a, b, c};
        ++side.n_cells;
    });
    std::vector<Triangle> triangles;
    for (const auto& [set, side] : sides) {
        if (side.n_cells == 1) triangles.push_back(side.oriented);
    }
    return triangles;
}

}  // namespace SolidSubdiv::Validation
