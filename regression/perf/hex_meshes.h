// SPDX-License-Identifier: Apache-2.0
// Solids of hexahedra, and the same as other cells, for the races.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include <solidsubdiv/kit/io/mesh.h>
#include <solidsubdiv/sdc/cells.h>

namespace SolidSubdiv::Perf {

/// A cube of n^3 hexahedra; where n_layers is not 0, as many layers on each of its sides, the outermost a sphere. The
/// cube's own edges and the lines that leave its corners are in three cells, not four.
inline Io::Mesh HexBall(int n, int n_layers) {
    Io::Mesh mesh;
    const int m = n + 1;
    std::vector<Index> ids(static_cast<std::size_t>(m * m * m * (n_layers + 1)), kNoIndex);
    const auto vertex = [&](const std::array<int, 3>& p, int layer) {
        Index& id = ids[static_cast<std::size_t>(p[0] + m * (p[1] + m * (p[2] + m * layer)))];
        if (id != kNoIndex) return id;
        id = mesh.topology.n_vertices++;
        std::array<double, 3> x;
        for (std::size_t c = 0; c < 3; ++c) x[c] = 2.0 * p[c] / n - 1;
        const double t = n_layers > 0 ? static_cast<double>(layer) / n_layers : 0, size = std::hypot(x[0], x[1], x[2]);
        for (double c : x) mesh.positions.push_back(c * (1 + t * (3 / std::max(size, 1.0) - 1)));
        return id;
    };
    for (int z = 0; z < m; ++z) {
        for (int y = 0; y < m; ++y) {
            for (int x = 0; x < m; ++x) vertex({x, y, z}, 0);
        }
    }
    std::vector<Index>& hexes = mesh.topology.hexes;
    for (int z = 0; z < n; ++z) {
        for (int y = 0; y < n; ++y) {
            for (int x = 0; x < n; ++x) {
                const std::array<std::array<int, 3>, 8> corners = {{{x, y, z},
                                                                    {x + 1, y, z},
                                                                    {x + 1, y + 1, z},
                                                                    {x, y + 1, z},
                                                                    {x, y, z + 1},
                                                                    {x + 1, y, z + 1},
                                                                    {x + 1, y + 1, z + 1},
                                                                    {x, y + 1, z + 1}}};
                for (const auto& corner : corners) hexes.push_back(vertex(corner, 0));
                for (const auto& face : Sdc::Hex::faces) {
                    const auto lies_on_side = [&](std::size_t axis, int value) {
                        return std::all_of(face.begin(), face.end(), [&](int k) { return corners[k][axis] == value; });
                    };
                    const bool is_outside = lies_on_side(0, 0) || lies_on_side(1, 0) || lies_on_side(2, 0) ||
                                            lies_on_side(0, n) || lies_on_side(1, n) || lies_on_side(2, n);
                    for (int layer = 0; is_outside && layer < n_layers; ++layer) {
                        for (int k : face) hexes.push_back(vertex(corners[k], layer));
                        for (int k : face) hexes.push_back(vertex(corners[k], layer + 1));
                    }
                }
            }
        }
    }
    return mesh;
}

/// The same cells, given by their faces.
inline Io::Mesh AsPolyhedra(Io::Mesh mesh) {
    Io::Topology& t = mesh.topology;
    t.polyhedron_offsets.assign(1, 0);
    t.polyhedron_face_offsets.assign(1, 0);
    for (std::size_t c = 0; c < t.hexes.size(); c += Sdc::Hex::kVertices) {
        for (const auto& face : Sdc::Hex::faces) {
            for (Sdc::Local k : face) t.polyhedron_vertices.push_back(t.hexes[c + k]);
            t.polyhedron_face_offsets.push_back(static_cast<Offset>(t.polyhedron_vertices.size()));
        }
        t.polyhedron_offsets.push_back(static_cast<Offset>(t.polyhedron_face_offsets.size()) - 1);
    }
    t.hexes.clear();
    return mesh;
}

/// Six pyramids in place of each hexahedron, with its centre as their common apex.
inline Io::Mesh CutIntoPyramids(Io::Mesh mesh) {
    Io::Topology& t = mesh.topology;
    for (std::size_t c = 0; c < t.hexes.size(); c += Sdc::Hex::kVertices) {
        const Index centre = t.n_vertices++;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            double sum = 0;
            for (std::size_t k = 0; k < Sdc::Hex::kVertices; ++k) {
                sum += mesh.positions[3 * static_cast<std::size_t>(t.hexes[c + k]) + axis];
            }
            mesh.positions.push_back(sum / Sdc::Hex::kVertices);
        }
        for (const auto& face : Sdc::Hex::faces) {
            for (int k = 3; k >= 0; --k) t.pyramids.push_back(t.hexes[c + face[k]]);  // the base as the apex sees it
            t.pyramids.push_back(centre);
        }
    }
    t.hexes.clear();
    return mesh;
}

}  // namespace SolidSubdiv::Perf
