// SPDX-License-Identifier: Apache-2.0
// Small solids, and the volume inside triangles.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <utility>
#include <vector>

#include <solidsubdiv/kit/io/mesh.h>
#include <solidsubdiv/sdc/cells.h>

namespace SolidSubdiv::Picture {

/// One cell of each kind in a chain of shared faces: hex - pyramid on its top; wedge at its right; an octahedron and
/// tets apart.
inline Io::Mesh OneOfEach() {
    Io::Mesh mesh;
    mesh.positions = {0,   0,   0, 1, 0, 0, 1, 1, 0, 0, 1,  0, 0, 0, 1,  1, 0, 1, 1, 1, 1, 0, 1, 1,  // hex
                      0.5, 0.5, 2,                                                 // 8: the pyramid's top
                      2,   0,   0, 2, 1, 0,                                        // 9, 10: the wedge's edge
                      5,   0,   0, 7, 0, 0, 6, 1, 0, 6, -1, 0, 6, 0, -1, 6, 0, 1,  // 11..16: octahedron
                      7,   1,   1};                                                // 17: tets on its faces
    mesh.topology.n_vertices = 18;
    mesh.topology.hexes = {0, 1, 2, 3, 4, 5, 6, 7};
    mesh.topology.pyramids = {4, 5, 6, 7, 8};
    mesh.topology.wedges = {1, 9, 5, 2, 10, 6};
    mesh.topology.octs = {11, 12, 13, 14, 16, 15};
    mesh.topology.tets = {12, 13, 16, 17};
    return mesh;
}

/// The same cells, each given as a polyhedron.
inline Io::Mesh AsPolyhedra(const Io::Mesh& mesh) {
    Io::Mesh result;
    result.positions = mesh.positions;
    Io::Topology& to = result.topology;
    to.n_vertices = mesh.topology.n_vertices;
    to.polyhedron_offsets = to.polyhedron_face_offsets = {0};
    const auto add = [&]<class Cell>(Cell, const std::vector<Index>& cells) {
        for (std::size_t c = 0; c < cells.size(); c += Cell::kVertices) {
            for (const auto& face : Cell::faces) {
                for (Sdc::Local k : face) {
                    if (k != Sdc::kNoLocal) to.polyhedron_vertices.push_back(cells[c + k]);
                }
                to.polyhedron_face_offsets.push_back(static_cast<Offset>(to.polyhedron_vertices.size()));
            }
            to.polyhedron_offsets.push_back(static_cast<Offset>(to.polyhedron_face_offsets.size()) - 1);
        }
    };
    add(Sdc::Tet{}, mesh.topology.tets);
    add(Sdc::Oct{}, mesh.topology.octs);
    add(Sdc::Hex{}, mesh.topology.hexes);
    add(Sdc::Wedge{}, mesh.topology.wedges);
    add(Sdc::Pyramid{}, mesh.topology.pyramids);
    return result;
}

/// Six times the volume inside triangles; nothing if they do not close.
inline double SixVolumes(const std::vector<double>& positions, const std::vector<Index>& triangles) {
    std::map<std::pair<Index, Index>, int> sides;
    double sum = 0;
    for (std::size_t t = 0; t < triangles.size(); t += 3) {
        const double* p[3];
        for (std::size_t i = 0; i < 3; ++i) {
            p[i] = &positions[3 * static_cast<std::size_t>(triangles[t + i])];
            ++sides[{triangles[t + i], triangles[t + (i + 1) % 3]}];
        }
        sum += p[0][0] * (p[1][1] * p[2][2] - p[1][2] * p[2][1]) + p[0][1] * (p[1][2] * p[2][0] - p[1][0] * p[2][2]) +
               p[0][2] * (p[1][0] * p[2][1] - p[1][1] * p[2][0]);
    }
    for (const auto& [side, n] : sides) {
        const auto other = sides.find({side.second, side.first});
        EXPECT_TRUE(other != sides.end() && other->second == n) << side.first << " - " << side.second << " is open";
    }
    return sum;
}

/// n^3 cubes of side 1, each cut into six tets.
inline Io::Mesh TetBlock(int n) {
    Io::Mesh mesh;
    const auto id = [n](int i, int j, int k) { return static_cast<Index>((k * (n + 1) + j) * (n + 1) + i); };
    for (int k = 0; k <= n; ++k) {
        for (int j = 0; j <= n; ++j) {
            for (int i = 0; i <= n; ++i) mesh.positions.insert(mesh.positions.end(), {1.0 * i, 1.0 * j, 1.0 * k});
        }
    }
    mesh.topology.n_vertices = static_cast<Index>(mesh.positions.size() / 3);
    for (int c = 0; c < n * n * n; ++c) {
        int axes[3] = {0, 1, 2};
        do {
            int p[3] = {c % n, c / n % n, c / n / n};
            std::array<Index, 4> tet{id(p[0], p[1], p[2])};
            for (std::size_t s = 0; s < 3; ++s) {
                ++p[axes[s]];
                tet[s + 1] = id(p[0], p[1], p[2]);
            }
            const bool odd = (axes[0] > axes[1]) ^ (axes[0] > axes[2]) ^ (axes[1] > axes[2]);
            if (odd) std::swap(tet[2], tet[3]);
            mesh.topology.tets.insert(mesh.topology.tets.end(), tet.begin(), tet.end());
        } while (std::next_permutation(axes, axes + 3));
    }
    return mesh;
}

}  // namespace SolidSubdiv::Picture
