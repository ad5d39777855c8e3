// SPDX-License-Identifier: Apache-2.0
// What the polyhedral split makes of a hexahedron, as tables: eight hexahedra, all in the cell's own numbers.
//
// Points: vertices, edge points (8 + e), face points (20 + f), the centre (26). The child at corner i has at its own
// corner j the point of the part that i and j span, so that it lies as its parent does. Edges: 2e + s at end s of edge
// e; then 24 + 4f + k from the point of face f to the edge from corner k of the face; then 48 + f from the centre to
// face f. Faces: 4f + k at corner k of face f; then 24 + e inside, across edge e.
#pragma once

#include <array>

#include <solidsubdiv/sdc/cells.h>

namespace SolidSubdiv::Sdc {

struct HexSplit {
    static constexpr int kFirstEdgePoint = Hex::kVertices, kFirstFacePoint = kFirstEdgePoint + Hex::kEdges,
                         kCentre = kFirstFacePoint + Hex::kFaces, kPoints = kCentre + 1;
    static constexpr int kFirstFaceEdge = 2 * Hex::kEdges, kFirstInnerEdge = kFirstFaceEdge + 4 * Hex::kFaces,
                         kChildEdges = kFirstInnerEdge + Hex::kFaces;
    static constexpr int kFirstInnerFace = 4 * Hex::kFaces, kChildFaces = kFirstInnerFace + Hex::kEdges;

    std::array<std::array<Local, 8>, 8> vertices{};  ///< points of each child
    std::array<std::array<Local, 12>, 8> edges{};
    std::array<std::array<Local, 6>, 8> faces{};
    std::array<std::array<Local, 4>, Hex::kFaces> face_edges{};  ///< edge k of a face: from its corner k to the next
    /// Of each edge of the cell: the face on its left and on its right, seen from outside along it.
    std::array<std::array<Local, 2>, Hex::kEdges> sides{};
};

namespace Internal {

/// The place of a corner in a face, or -1.
constexpr int CornerOfFace(int face, int vertex) {
    for (int k = 0; k < 4; ++k) {
        if (Hex::faces[face][k] == vertex) return k;
    }
    return -1;
}

/// The point of the smallest part of the cell that has both corners.
constexpr int PointBetween(int i, int j) {
    if (i == j) return i;
    if (const int e = FindEdge<Hex>(i, j); e >= 0) return HexSplit::kFirstEdgePoint + e;
    for (int f = 0; f < Hex::kFaces; ++f) {
        if (CornerOfFace(f, i) >= 0 && CornerOfFace(f, j) >= 0) return HexSplit::kFirstFacePoint + f;
    }
    return HexSplit::kCentre;
}

constexpr HexSplit MakeHexSplit() {
    HexSplit split;
    for (int f = 0; f < Hex::kFaces; ++f) {
        for (int k = 0; k < 4; ++k) {
            const int a = Hex::faces[f][k], b = Hex::faces[f][(k + 1) % 4], e = FindEdge<Hex>(a, b);
            split.face_edges[f][k] = static_cast<Local>(e);
            // Counterclockwise from outside, a face is on the left of its edges.
            split.sides[e][Hex::edges[e][0] == a ? 0 : 1] = static_cast<Local>(f);
        }
    }
    for (int i = 0; i < 8; ++i) {
        for (int j = 0; j < 8; ++j) split.vertices[i][j] = static_cast<Local>(PointBetween(i, j));
        for (int n = 0; n < Hex::kEdges; ++n) {
            const int p = PointBetween(i, Hex::edges[n][0]), q = PointBetween(i, Hex::edges[n][1]);
            const int low = p < q ? p : q, high = p < q ? q : p;
            int number;
            if (high == HexSplit::kCentre) {
                number = HexSplit::kFirstInnerEdge + low - HexSplit::kFirstFacePoint;
            } else if (high >= HexSplit::kFirstFacePoint) {
                const int f = high - HexSplit::kFirstFacePoint, e = low - HexSplit::kFirstEdgePoint;
                int k = 0;
                while (split.face_edges[f][k] != e) ++k;
                number = HexSplit::kFirstFaceEdge + 4 * f + k;
            } else {
                const int e = high - HexSplit::kFirstEdgePoint;
                number = 2 * e + (Hex::edges[e][1] == low ? 1 : 0);
            }
            split.edges[i][n] = static_cast<Local>(number);
        }
        for (int g = 0; g < Hex::kFaces; ++g) {
            bool is_outer = false;
            int face_point = 0, edge_point = 0;
            for (Local corner : Hex::faces[g]) {
                const int p = PointBetween(i, corner);
                is_outer = is_outer || p == i;
                if (p >= HexSplit::kFirstFacePoint && p < HexSplit::kCentre) face_point = p;
                if (p >= HexSplit::kFirstEdgePoint && p < HexSplit::kFirstFacePoint) edge_point = p;
            }
            if (is_outer) {  // one face point, two edge points
                const int f = face_point - HexSplit::kFirstFacePoint;
                split.faces[i][g] = static_cast<Local>(4 * f + CornerOfFace(f, i));
            } else {  // one edge point, two face points
                split.faces[i][g] =
                    static_cast<Local>(HexSplit::kFirstInnerFace + edge_point - HexSplit::kFirstEdgePoint);
            }
        }
    }
    return split;
}

}  // namespace Internal

inline constexpr HexSplit kHexSplit = Internal::MakeHexSplit();

}  // namespace SolidSubdiv::Sdc
