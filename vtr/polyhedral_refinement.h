// SPDX-License-Identifier: Apache-2.0
// One split of a level of polyhedra into the next: a new cell at every corner of every cell.
//
// A corner where n of a cell's edges meet gives a cell of 2n quadrilaterals: a hexahedron where n is 3, otherwise one
// with two corners of n edges again. With V, E, F the parent's counts, components of the child are numbered by the
// parent component they come from; S(f), X(c), Y(c) stand for the numbers of corners of the faces before f, of faces
// and of edges of the cells before c:
//
//   vertices  [0, V)           the parent's
//             V + e, V + E + f, V + E + F + c    on edge e, in face f, in cell c
//   edges     2e, 2e + 1       on edge e, at its lower, higher end
//             2E + S(f) + k    in face f, from its point to the one on its edge k
//             2E + S(F) + X(c) + i    in cell c, from its point to the one in its face i
//   faces     S(f) + k         on face f at corner k: its vertex, the points of its edges k, in the face, of k - 1
//             S(F) + Y(c) + i  in cell c, across its edge i
//   cells     8c + i           hexahedra in hexahedron c, at corner i; then those of other cells, corner by corner;
//             then what else there is, likewise
//
// Source: rules.md sections 1 and 4 (MacCracken and Joy 1996, maccracken1996).
#pragma once

#include <solidsubdiv/vtr/polyhedral_level.h>

namespace SolidSubdiv::Vtr {

/// Counts of a level that need not fit an index.
struct PolyhedralCounts {
    Offset n_vertices = 0, n_edges = 0, n_faces = 0, n_hexes = 0, n_polyhedra = 0, n_boundary_faces = 0;
    Offset n_face_corners = 0;                                       ///< of all faces
    Offset n_poly_vertices = 0, n_poly_edges = 0, n_poly_faces = 0;  ///< of all cells but hexahedra
    Offset n_boundary_corners = 0;
    /// What the next level's cells but hexahedra will be: corners where other than three edges of a cell meet, and the
    /// sum of their numbers of edges.
    Offset n_odd_corners = 0, n_odd_edges = 0;

    Offset n_cells() const { return n_hexes + n_polyhedra; }
    Offset Largest() const;
    friend bool operator==(const PolyhedralCounts&, const PolyhedralCounts&) = default;
};

/// @pre level.is_full
PolyhedralCounts CountsOf(const PolyhedralLevel& level);

/// Counts after one split: V' = V + E + F + C, E' = 2E + S + X, F' = S + Y, C' = corners of the cells.
PolyhedralCounts Refine(const PolyhedralCounts& parent);

/// Bytes of the arrays of a level with these counts, which comes from a split, full or not.
Offset EstimateBytes(const PolyhedralCounts& counts, bool full);

/// Splits every component of a full level. @pre parent.is_full and the child's counts fit Index
/// Cost: one pass over the parent; parallel, the same bits for any number of threads.
PolyhedralLevel Refine(const PolyhedralLevel& parent, bool full);

}  // namespace SolidSubdiv::Vtr
