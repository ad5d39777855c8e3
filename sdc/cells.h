// SPDX-License-Identifier: Apache-2.0
// Reference cells: vertices, edges, faces and the split of a tetrahedron and an octahedron, drawn once, as tables.
//
// clang-format off
//   Tet (v0 v1 v2 v3), positive when             Oct (v0 v1 | v2 v3 | v4 v5): opposite pairs, the first the
//   det(v1-v0, v2-v0, v3-v0) > 0                 major diagonal; positive when det(v0-c, v2-c, v4-c) < 0
//
//            v3                                           v0
//           /|\          edges 0: v0v1                   /|\ \           c: the centre
//          / | \               1: v0v2                  / | \  \         edges 0-7 touch the major diagonal
//         /  |  \              2: v0v3                v2--|--v5-\        equator: v2 v4 v3 v5
//       v0---|---v2            3: v1v2                 |\ |      |
//         \  |  /              4: v1v3                 | v4-----v3
//          \ | /               5: v2v3                  \ |    /
//           \|/          B edges (the pair in use):       v1
//            v1          0 and 5; A edges: the others
//
//   face i lies opposite vertex i, counterclockwise from outside
// clang-format on
//
// Splits put a point on every edge and, in an octahedron, one at its centre. "Points" of a split cell are numbered
// vertices first, then edge points, then the centre. New edges and faces are listed in the order in which
// Vtr::Refinement numbers them: on edges, on faces, inside. Source: rules.md section 1; chang2002boxspline, 3.4.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace SolidSubdiv::Sdc {

using Local = std::uint8_t;  ///< index within one cell

struct Tet {
    static constexpr int kVertices = 4, kEdges = 6, kFaces = 4;
    static constexpr std::array<std::array<Local, 2>, 6> edges{{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};
    static constexpr std::array<std::array<Local, 3>, 4> faces{{{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};
};

struct Oct {
    static constexpr int kVertices = 6, kEdges = 12, kFaces = 8;
    static constexpr int kDiagonalEdges = 8;  ///< edges [0, 8) touch an end of the major diagonal
    static constexpr std::array<std::array<Local, 2>, 12> edges{
        {{0, 2}, {0, 3}, {0, 4}, {0, 5}, {1, 2}, {1, 3}, {1, 4}, {1, 5}, {2, 4}, {2, 5}, {3, 4}, {3, 5}}};
    /// Face 4a + 2b + d has the vertices a, 2 + b, 4 + d, counterclockwise from outside.
    static constexpr std::array<std::array<Local, 3>, 8> faces{
        {{0, 4, 2}, {0, 2, 5}, {0, 3, 4}, {0, 5, 3}, {1, 2, 4}, {1, 5, 2}, {1, 4, 3}, {1, 3, 5}}};
    static constexpr Local Opposite(int vertex) { return static_cast<Local>(vertex ^ 1); }
    /// The octahedron as four positive tets around its major diagonal.
    static constexpr std::array<std::array<Local, 4>, 4> tets{{{0, 1, 2, 4}, {0, 1, 4, 3}, {0, 1, 3, 5}, {0, 1, 5, 2}}};
};

inline constexpr Local kNoLocal = 255;  ///< fills rows of tables: no such vertex

/// Hexahedron, in VTK's order: 0 1 2 3 around the bottom, 4 5 6 7 above them.
///
///        7--------6        edges 0-3: around the bottom, from vertex i         faces: x = 0, x = 1,
///       /|       /|              4-7: around the top, from vertex i                   y = 0, y = 1,
///      4--------5 |              8-11: upwards from vertex i - 8                      z = 0, z = 1,
///      | 3------|-2                                                            each counterclockwise from outside
///      |/       |/         z y
///      0--------1          |/_x
struct Hex {
    static constexpr int kVertices = 8, kEdges = 12, kFaces = 6;
    static constexpr std::array<std::array<Local, 2>, 12> edges{
        {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6}, {6, 7}, {7, 4}, {0, 4}, {1, 5}, {2, 6}, {3, 7}}};
    static constexpr std::array<std::array<Local, 4>, 6> faces{
        {{0, 4, 7, 3}, {1, 2, 6, 5}, {0, 1, 5, 4}, {3, 7, 6, 2}, {0, 3, 2, 1}, {4, 5, 6, 7}}};
    /// How many edges lie between two vertices.
    static constexpr int Distance(int a, int b) { return std::popcount(Place(a) ^ Place(b)); }
    /// The vertex three edges away.
    static constexpr std::size_t Opposite(int vertex) { return static_cast<std::size_t>(vertex ^ 6); }

  private:
    /// One bit an axis.
    static constexpr unsigned Place(int vertex) {
        const unsigned i = static_cast<unsigned>(vertex);
        return i ^ ((i >> 1) & 1);
    }
};

/// Triangular prism, in VTK's order: 0 1 2 counterclockwise from outside, 3 4 5 beside them.
struct Wedge {
    static constexpr int kVertices = 6, kFaces = 5;
    static constexpr std::array<std::array<Local, 4>, 5> faces{
        {{0, 1, 2, kNoLocal}, {3, 5, 4, kNoLocal}, {0, 3, 4, 1}, {1, 4, 5, 2}, {2, 5, 3, 0}}};
};

/// Pyramid, in VTK's order: the base 0 1 2 3 counterclockwise from the apex, 4.
struct Pyramid {
    static constexpr int kVertices = 5, kFaces = 5;
    static constexpr std::array<std::array<Local, 4>, 5> faces{
        {{0, 3, 2, 1}, {0, 1, 4, kNoLocal}, {1, 2, 4, kNoLocal}, {2, 3, 4, kNoLocal}, {3, 0, 4, kNoLocal}}};
};

struct Triangle {
    static constexpr int kVertices = 3, kEdges = 3;
    static constexpr std::array<std::array<Local, 2>, 3> edges{{{0, 1}, {1, 2}, {2, 0}}};
};

struct Edge {
    static constexpr int kVertices = 2;
};

/// The edge between two vertices of a cell. @pre they are the ends of one
template <class Cell>
constexpr int FindEdge(int a, int b) {
    for (int e = 0; e < Cell::kEdges; ++e) {
        const auto& v = Cell::edges[e];
        if ((v[0] == a && v[1] == b) || (v[0] == b && v[1] == a)) return e;
    }
    return -1;
}

}  // namespace SolidSubdiv::Sdc
