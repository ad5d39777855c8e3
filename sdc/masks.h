// SPDX-License-Identifier: Apache-2.0
// The weights that a scheme answers with, and the surface and curve rules that solids share on their boundaries.
//
// A scheme is asked about a neighbourhood by its counts alone and answers with one weight a role; Far finds the
// neighbours. Every answer's weights sum to 1 over the neighbourhood.
#pragma once

#include <cmath>
#include <numbers>

namespace SolidSubdiv::Sdc {

/// How a mesh is cut.
enum class Split {
    TetOct,     ///< tets and octs into tets and octs, triangles 1 to 4, edges 1 to 2
    Polyhedral  ///< any cells into a cell a corner, polygons into a quadrilateral a corner, edges 1 to 2
};

/// Which octahedra a solid rule looks into from a vertex or an edge.
enum class OctNeighbors {
    None,
    MajorDiagonal,  ///< those whose major diagonal ends here: its far end counts
    All             ///< all: the vertices opposite to this one, or to either end of this edge, count
};

/// Which neighbours a scheme's solid rules use at all.
struct Footprint {
    bool vertex_ring = true;      ///< vertex points use the ends of the vertex's edges
    bool edge_ring = true;        ///< edge points use the third vertices of the edge's faces
    bool tet_faces_only = false;  ///< ... of those faces alone that bound a tet
    OctNeighbors octs = OctNeighbors::MajorDiagonal;
};

struct VertexCounts {
    int n_edges = 0;  ///< edges at the vertex
    int n_octs = 0;   ///< octs seen, as Footprint::octs says
};
/// self + edge * sum(ends of edges) + oct * sum(opposite vertices in octs) = 1
struct VertexWeights {
    double self, edge, oct;
};

/// The cells at a vertex, for schemes whose rule there goes by cells.
struct VertexCells {
    int n_tets = 0, n_octs = 0;
};
/// self + tet * sum(other vertices of each tet) + oct * sum(neighbours in each oct) + opposite * sum(those opposite)
struct CellVertexWeights {
    double self, tet, oct, opposite;
};

struct EdgeCounts {
    int n_faces = 0;         ///< faces seen at the edge
    int n_octs = 0;          ///< octs seen
    int n_oct_vertices = 0;  ///< vertices that they contribute
};
/// end * (a + b) + face * sum(third vertices) + oct * sum(vertices that octs contribute)
struct EdgeWeights {
    double end, face, oct;
};

/// Centre of an oct: diagonal * (v0 + v1) + equator * (v2 + v3 + v4 + v5)
struct OctWeights {
    double diagonal, equator;
};

struct RingWeights {
    double self, neighbor;
};
struct EdgePairWeights {
    double end, opposite;
};

/// Weights of surface vertices in Loop's scheme.
enum class LoopWeights {
    Loop,   ///< Loop 1987; what OpenSubdiv uses
    Warren  ///< the simpler ones that Chang et al. 2002 name
};

/// Loop surfaces: rules for triangles and for the boundary of tet/oct solids.
struct LoopSurface {
    static constexpr bool kVerticesStay = false;
    static constexpr bool kIsWide = false;  ///< edges look no further than their own faces
    LoopWeights weights = LoopWeights::Loop;

    /// Vertex of n neighbours. Source: Loop 1987; Warren's variant: Zorin and Schroeder 2000 (rules.md section 5).
    RingWeights Vertex(int n) const {
        double b;
        if (weights == LoopWeights::Warren) {
            b = n == 3 ? 3.0 / 16.0 : 3.0 / (8.0 * n);
        } else {
            const double c = 3.0 / 8.0 + std::cos(2.0 * std::numbers::pi / n) / 4.0;
            b = (5.0 / 8.0 - c * c) / n;
        }
        return {1.0 - n * b, b};
    }
    EdgePairWeights Edge() const { return {3.0 / 8.0, 1.0 / 8.0}; }

    /// Weight of each neighbour in the limit position of a vertex of n neighbours.
    RingWeights Limit(int n) const {
        const double b = Vertex(n).neighbor;
        const double neighbor = 1.0 / (n + 3.0 / (8.0 * b));
        return {1.0 - n * neighbor, neighbor};
    }
};

/// Cubic B-spline curves: creases and curves.
struct CubicCurve {
    static constexpr bool kVerticesStay = false;
    static constexpr bool kIsWide = false;
    RingWeights Vertex() const { return {6.0 / 8.0, 1.0 / 8.0}; }
    double EdgeEnd() const { return 0.5; }
    RingWeights Limit() const { return {4.0 / 6.0, 1.0 / 6.0}; }
};

/// Piecewise linear: every new point is a mean, vertices stay.
struct LinearRule {
    static constexpr bool kVerticesStay = true;  ///< and edge points are means of the ends
    static constexpr bool kIsWide = false;
    RingWeights Vertex(int = 0) const { return {1.0, 0.0}; }
    EdgePairWeights Edge() const { return {0.5, 0.0}; }
    double EdgeEnd() const { return 0.5; }
    RingWeights Limit(int = 0) const { return {1.0, 0.0}; }
};

}  // namespace SolidSubdiv::Sdc
