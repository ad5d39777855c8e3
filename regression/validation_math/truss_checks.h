// SPDX-License-Identifier: Apache-2.0
// What the tests of the octet truss measure on a block.
#pragma once

#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "validation/octet_truss.h"

namespace SolidSubdiv::Validation {

using Tet = std::array<int, 4>;
using Oct = std::array<int, 6>;
using Edge = std::pair<int, int>;

inline Edge MakeEdge(int a, int b) { return {std::min(a, b), std::max(a, b)}; }

inline LatticePoint Difference(const LatticePoint& a, const LatticePoint& b) {
    return {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
}

inline EdgeKind Kind(const TrussBlock& block, int a, int b) {
    return ClassifyEdge(block.vertices[a], block.vertices[b]);
}

inline int SixVolumesOf(const TrussBlock& block, const Tet& t) {
    const auto& v = block.vertices;
    return SixVolumes(v[t[0]], v[t[1]], v[t[2]], v[t[3]]);
}

// 8 det(v0 - c, v2 - c, v4 - c), c the octahedron's centre; the rules call it positive when this is negative.
inline int OctDeterminant(const TrussBlock& block, const Oct& o) {
    const auto& v = block.vertices;
    LatticePoint centre2{};
    std::array<LatticePoint, 3> arms{};
    for (int i = 0; i < 3; ++i) centre2[i] = v[o[0]][i] + v[o[1]][i];
    for (int arm = 0; arm < 3; ++arm)
        for (int i = 0; i < 3; ++i) arms[arm][i] = 2 * v[o[2 * arm]][i] - centre2[i];
    return SixVolumes({0, 0, 0}, arms[0], arms[1], arms[2]);
}

// On the surface of the block: both ends on one side.
inline bool OnBoundary(const TrussBlock& block, int a, int b) {
    for (int i = 0; i < 3; ++i) {
        const int pa = block.vertices[a][i], pb = block.vertices[b][i];
        if (pa == pb && (pa == 0 || pa == block.size[i])) return true;
    }
    return false;
}

// Everything wrong with the cells one by one: orientation and ordering.
inline std::vector<std::string> CellDefects(const TrussBlock& block) {
    std::vector<std::string> defects;
    for (const Tet& t : block.tets) {
        if (SixVolumesOf(block, t) != 1) defects.push_back("tet: volume");
        for (int i = 0; i < 4; ++i)
            for (int j = i + 1; j < 4; ++j) {
                const EdgeKind expected = i + j == 1 || i + j == 5 ? EdgeKind::B : EdgeKind::A;
                if (Kind(block, t[i], t[j]) != expected) defects.push_back("tet: edge kind");
            }
    }
    for (const Oct& o : block.octs) {
        if (OctDeterminant(block, o) >= 0) defects.push_back("oct: orientation");
        if (Kind(block, o[0], o[1]) != EdgeKind::B) defects.push_back("oct: diagonal kind");
        for (int k = 1; k < 3; ++k) {
            // Opposite vertices share the centre.
            for (int i = 0; i < 3; ++i)
                if (block.vertices[o[2 * k]][i] + block.vertices[o[2 * k + 1]][i] !=
                    block.vertices[o[0]][i] + block.vertices[o[1]][i])
                    defects.push_back("oct: opposite vertices");
        }
    }
    return defects;
}

// The tetrahedral view as unordered cells: equal sets mean the same complex.
inline std::set<std::set<int>> Cells(const std::vector<Tet>& tets) {
    std::set<std::set<int>> cells;
    for (const Tet& t : tets) cells.insert({t.begin(), t.end()});
    return cells;
}

}  // namespace SolidSubdiv::Validation
