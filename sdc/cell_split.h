// SPDX-License-Identifier: Apache-2.0
// What one split makes of a tet and of an oct, as tables: children, new edges, new faces, all in a cell's own numbers.
//
// Points: vertices, edge points, the centre (oct). Edges: 2e + s at end s of edge e; then 3f + k across corner k of
// face f; then (oct) from the centre to edge point e. Faces: 4f + k at corner k of face f, 4f + 3 in its middle; then
// inside: tet: i, cutting off corner i; oct: 3f + k, from the centre through the two points at corner k of face f.
#pragma once

#include <array>

#include <solidsubdiv/sdc/cells.h>

namespace SolidSubdiv::Sdc {

template <class Cell>
struct CellSplit {
    static constexpr bool kIsOct = Cell::kVertices == 6;
    static constexpr int kCentre = Cell::kVertices + Cell::kEdges;  ///< point number of the centre
    static constexpr int kPoints = kCentre + (kIsOct ? 1 : 0);
    static constexpr int kInnerEdges = kIsOct ? Cell::kEdges : 0;
    static constexpr int kInnerFaces = kIsOct ? 3 * Cell::kFaces : Cell::kVertices;
    static constexpr int kChildEdges = 2 * Cell::kEdges + 3 * Cell::kFaces + kInnerEdges;
    static constexpr int kChildFaces = 4 * Cell::kFaces + kInnerFaces;
    static constexpr int kFirstInnerEdge = kChildEdges - kInnerEdges;
    static constexpr int kFirstInnerFace = kChildFaces - kInnerFaces;
    static constexpr int kChildTets = kIsOct ? 8 : 4;
    static constexpr int kChildOcts = kIsOct ? 6 : 1;

    std::array<std::array<Local, 4>, kChildTets> tets{};  ///< points
    std::array<std::array<Local, 6>, kChildOcts> octs{};
    std::array<std::array<Local, 6>, kChildTets> tet_edges{};  ///< the children's edges and faces as child edges, faces
    std::array<std::array<Local, 4>, kChildTets> tet_faces{};
    std::array<std::array<Local, 12>, kChildOcts> oct_edges{};
    std::array<std::array<Local, 8>, kChildOcts> oct_faces{};
    std::array<std::array<Local, 2>, kChildEdges> edge_points{};
    std::array<std::array<Local, 3>, kChildFaces> face_points{};
    std::array<std::array<Local, 3>, kChildFaces> face_edges{};  ///< edge k lies opposite point k of face_points
};

namespace Internal {

template <class Cell>
constexpr Local EdgePoint(int a, int b) {
    return static_cast<Local>(Cell::kVertices + FindEdge<Cell>(a, b));
}

template <class Cell>
constexpr int FindChildEdge(const CellSplit<Cell>& split, int p, int q) {
    for (int e = 0; e < CellSplit<Cell>::kChildEdges; ++e) {
        const auto& ends = split.edge_points[e];
        if ((ends[0] == p && ends[1] == q) || (ends[0] == q && ends[1] == p)) return e;
    }
    throw "no such child edge";  // not a constant: a wrong table does not compile
}

template <class Cell>
constexpr int FindChildFace(const CellSplit<Cell>& split, int p, int q, int r) {
    for (int f = 0; f < CellSplit<Cell>::kChildFaces; ++f) {
        int found = 0;
        for (Local point : split.face_points[f]) found += point == p || point == q || point == r;
        if (found == 3) return f;
    }
    throw "no such child face";
}

template <class Cell>
constexpr CellSplit<Cell> MakeCellSplit() {
    using Split = CellSplit<Cell>;
    Split split;
    constexpr auto mid = EdgePoint<Cell>;
    constexpr Local centre = Split::kCentre;

    if constexpr (!Split::kIsOct) {
        for (int i = 0; i < 4; ++i) {
            for (int j = 0; j < 4; ++j) split.tets[i][j] = i == j ? static_cast<Local>(i) : mid(i, j);
        }
        split.octs[0] = {mid(0, 1), mid(2, 3), mid(0, 2), mid(1, 3), mid(0, 3), mid(1, 2)};
    } else {
        for (int i = 0; i < 6; ++i) {
            for (int j = 0; j < 6; ++j) {
                split.octs[i][j] = i == j ? static_cast<Local>(i) : j == (i ^ 1) ? centre : mid(i, j);
            }
        }
        for (int f = 0; f < 8; ++f) {
            const int seconds = (f >> 2) + ((f >> 1) & 1) + (f & 1);
            const int a = f >> 2, b = 2 + ((f >> 1) & 1), d = 4 + (f & 1);
            if (seconds % 2 == 1) {
                split.tets[f] = {centre, mid(b, d), mid(a, d), mid(a, b)};
            } else {
                split.tets[f] = {centre, mid(b, d), mid(a, b), mid(a, d)};
            }
        }
    }

    int n = 0;
    for (int e = 0; e < Cell::kEdges; ++e) {
        for (Local end : Cell::edges[e]) split.edge_points[n++] = {end, static_cast<Local>(Cell::kVertices + e)};
    }
    for (const auto& f : Cell::faces) {
        for (int k = 0; k < 3; ++k) {
            split.edge_points[n++] = {mid(f[k], f[(k + 1) % 3]), mid(f[k], f[(k + 2) % 3])};
        }
    }
    for (int e = 0; e < Split::kInnerEdges; ++e) {
        split.edge_points[n++] = {centre, static_cast<Local>(Cell::kVertices + e)};
    }

    n = 0;
    for (const auto& f : Cell::faces) {
        for (int k = 0; k < 3; ++k) {
            split.face_points[n++] = {f[k], mid(f[k], f[(k + 1) % 3]), mid(f[k], f[(k + 2) % 3])};
        }
        split.face_points[n++] = {mid(f[0], f[1]), mid(f[1], f[2]), mid(f[2], f[0])};
    }
    if constexpr (!Split::kIsOct) {
        for (int i = 0; i < 4; ++i) {
            const int j = (i + 1) % 4, k = (i + 2) % 4, l = (i + 3) % 4;
            split.face_points[n++] = {mid(i, j), mid(i, k), mid(i, l)};
        }
    } else {
        for (const auto& f : Cell::faces) {
            for (int k = 0; k < 3; ++k) {
                split.face_points[n++] = {centre, mid(f[k], f[(k + 1) % 3]), mid(f[k], f[(k + 2) % 3])};
            }
        }
    }
    for (int f = 0; f < Split::kChildFaces; ++f) {
        const auto& p = split.face_points[f];
        for (int k = 0; k < 3; ++k) {
            split.face_edges[f][k] = static_cast<Local>(FindChildEdge(split, p[(k + 1) % 3], p[(k + 2) % 3]));
        }
    }

    for (int c = 0; c < Split::kChildTets; ++c) {
        const auto& p = split.tets[c];
        for (int e = 0; e < Tet::kEdges; ++e) {
            split.tet_edges[c][e] = static_cast<Local>(FindChildEdge(split, p[Tet::edges[e][0]], p[Tet::edges[e][1]]));
        }
        for (int f = 0; f < Tet::kFaces; ++f) {
            const auto& v = Tet::faces[f];
            split.tet_faces[c][f] = static_cast<Local>(FindChildFace(split, p[v[0]], p[v[1]], p[v[2]]));
        }
    }
    for (int c = 0; c < Split::kChildOcts; ++c) {
        const auto& p = split.octs[c];
        for (int e = 0; e < Oct::kEdges; ++e) {
            split.oct_edges[c][e] = static_cast<Local>(FindChildEdge(split, p[Oct::edges[e][0]], p[Oct::edges[e][1]]));
        }
        for (int f = 0; f < Oct::kFaces; ++f) {
            const auto& v = Oct::faces[f];
            split.oct_faces[c][f] = static_cast<Local>(FindChildFace(split, p[v[0]], p[v[1]], p[v[2]]));
        }
    }
    return split;
}

}  // namespace Internal

inline constexpr CellSplit<Tet> kTetSplit = Internal::MakeCellSplit<Tet>();
inline constexpr CellSplit<Oct> kOctSplit = Internal::MakeCellSplit<Oct>();

template <class Cell>
constexpr const CellSplit<Cell>& SplitOf() {
    if constexpr (Cell::kVertices == 4) {
        return kTetSplit;
    } else {
        return kOctSplit;
    }
}

}  // namespace SolidSubdiv::Sdc
