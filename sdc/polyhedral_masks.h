// SPDX-License-Identifier: Apache-2.0
// Rules of the schemes of the polyhedral split: sums of centroids around a vertex, an edge or a face.
//
// A centroid is the mean of the vertices. Source: rules.md sections 4 and 4b (MacCracken and Joy 1996, maccracken1996;
// its boundary Catmull and Clark 1978, catmull1978; Bajaj, Schaefer, Warren, Xu 2002, bajaj2002).
#pragma once

namespace SolidSubdiv::Sdc {

/// How new points on edges of triangles are weighed on Catmull-Clark surfaces.
enum class TriangleWeights {
    CatmullClark,  ///< as on edges of any polygon
    Smooth         ///< OpenSubdiv's TRI_SUB_SMOOTH
};

/// Where new points go inside a solid, or on a surface.
enum class PolyhedralRule {
    CatmullClark,  ///< the masks below
    Linear,        ///< the centroid of what the point lies in
    Averaged       ///< the mean of the centroids of the cells, or faces, that the linear split makes there
};

struct PolyhedralRules {
    PolyhedralRule solid = PolyhedralRule::CatmullClark;
    PolyhedralRule surface = PolyhedralRule::CatmullClark;
    TriangleWeights triangles = TriangleWeights::CatmullClark;

    bool is_linear() const { return solid == PolyhedralRule::Linear; }

    /// Inside a solid, in the face: face * its centroid + cell * (C0 + C1)
    struct Face {
        double face, cell;
    };
    static Face SolidFace() { return {1.0 / 2.0, 1.0 / 4.0}; }

    /// Inside a solid, on an edge of n faces: middle * the edge's + face * sum of centroids of faces + cell * of cells
    struct SolidEdge {
        double middle, face, cell;
    };
    static SolidEdge SolidEdgeOf(int n) { return {(n - 3.0) / n, 2.0 / n / n, 1.0 / n / n}; }

    /// Inside a solid: self + middle * mean of the edges' middles + face * mean of faces' centroids + cell * of cells'
    struct SolidVertex {
        double self, middle, face, cell;
    };
    static SolidVertex SolidVertexRule() { return {1.0 / 8.0, 3.0 / 8.0, 3.0 / 8.0, 1.0 / 8.0}; }

    /// On a surface, on an edge between two faces: each end, each centroid.
    struct SurfaceEdge {
        double end, face;
    };
    SurfaceEdge SurfaceEdgeOf(bool first_is_triangle, bool second_is_triangle) const {
        constexpr double kSmooth = 0.470;  // OpenSubdiv's
        const bool is_smooth = triangles == TriangleWeights::Smooth;
        const double first = is_smooth && first_is_triangle ? kSmooth : 0.25,
                     second = is_smooth && second_is_triangle ? kSmooth : 0.25;
        const double face = 0.5 * (first + second);
        return {0.5 * (1.0 - 2.0 * face), face};
    }

    // The same rules, multiplied out where all cells are hexahedra, all faces quadrilaterals.

    /// Inside a solid: self; edge + edge_cell * its cells, for each edge's end; each vertex across a face; across a
    /// cell.
    struct HexVertexWeights {
        double self, edge, edge_cell, face, far;
    };
    HexVertexWeights HexVertex(int n_edges, int n_faces, int n_cells) const {
        const double cell = 1.0 / (64.0 * n_cells);
        if (solid == PolyhedralRule::Averaged) return {27.0 / 64.0, 0, 9 * cell, 6 * cell, cell};
        const double face = 3.0 / (32.0 * n_faces);
        return {27.0 / 64.0, 3.0 / (16.0 * n_edges), face + cell, face + 2 * cell, cell};
    }

    /// Inside a solid, on an edge of n faces: each end, each other vertex of the faces, each of the cells.
    struct HexEdgeWeights {
        double end, face, far;
    };
    HexEdgeWeights HexEdge(int n) const {
        if (solid == PolyhedralRule::Averaged) return {9.0 / 32.0, 3.0 / (16.0 * n), 1.0 / (32.0 * n)};
        const double share = 1.0 / (8.0 * n);
        return {(n - 2.0) / (2.0 * n) + share, 6 * share / n, share / n};
    }

    /// Inside a solid, in a face: its vertices, the others of the two cells.
    struct HexFaceWeights {
        double near, far;
    };
    HexFaceWeights HexFace() const { return {3.0 / 16.0, 1.0 / 32.0}; }

    /// On a surface, at a vertex of n edges: self, each neighbour, each vertex across a face.
    struct QuadVertexWeights {
        double self, neighbor, across;
    };
    QuadVertexWeights QuadVertex(int n) const {
        if (surface == PolyhedralRule::Averaged) return {9.0 / 16.0, 3.0 / (8.0 * n), 1.0 / (16.0 * n)};
        const double share = 1.0 / (4.0 * n * n);
        return {(n - 2.0) / n + n * share, 6 * share, share};
    }

    /// On a surface, at a vertex of n edges: self + neighbor * sum of the other ends + face * sum of centroids
    struct SurfaceVertex {
        double self, neighbor, face;
    };
    static SurfaceVertex SurfaceVertexOf(int n) {
        const double share = 1.0 / (static_cast<double>(n) * n);
        return {(n - 2.0) / n, share, share};
    }
};

}  // namespace SolidSubdiv::Sdc
