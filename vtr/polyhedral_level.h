// SPDX-License-Identifier: Apache-2.0
// The topology of one level of a complex of polyhedra, polygons and edges, as arrays of indices. No positions, no
// rules.
//
// Hexahedra, which are all that a split leaves of most meshes, have fixed arity and come first among the cells; what
// else there is (n_polyhedra, numbered after them) is kept in compressed rows. Faces are polygons, quadrilaterals only
// in all levels but the first. A face of cells is listed counterclockwise as seen from outside its first cell; one that
// bounds a single cell as seen from outside that, one in no cell as it was given.
//
// Relations and tables of edges and faces are there when is_full; a last level usually keeps its cells' vertices and
// its boundary only.
#pragma once

#include <span>

#include <solidsubdiv/sdc/cells.h>
#include <solidsubdiv/sdc/types.h>
#include <solidsubdiv/vtr/relation.h>
#include <solidsubdiv/vtr/tags.h>

namespace SolidSubdiv::Vtr {

/// Rows of an array: row i is [offsets[i], offsets[i + 1]), or, where offsets are empty, of a fixed length.
struct RowOffsets {
    Array<Offset> offsets;
    int fixed = 0;

    bool is_fixed() const { return offsets.empty(); }
    Offset Start(Index i) const { return is_fixed() ? static_cast<Offset>(fixed) * i : offsets[i]; }
    int Count(Index i) const { return is_fixed() ? fixed : static_cast<int>(offsets[i + 1] - offsets[i]); }
    template <class T>
    std::span<const T> Row(const Array<T>& array, Index i) const {
        return {array.data() + Start(i), static_cast<std::size_t>(Count(i))};
    }
};

/// Cells other than hexahedra. How a cell hangs together stands in rings: around each corner its edges,
/// counterclockwise from outside, and after each edge the face between it and the next; both as places in the cell's
/// own lists.
struct Polyhedra {
    // Always there: faces as lists of vertices, counterclockwise from outside.
    Array<Offset> offsets{0};              ///< (n + 1): of each cell, its faces among all faces of all cells
    Array<Offset> face_vertex_offsets{0};  ///< of each of those, its vertices
    Array<Index> face_vertices;

    // Full levels only.
    Array<Offset> vertex_offsets{0};      ///< (n + 1)
    Array<Index> vertices;                ///< corners
    Array<Offset> edge_offsets{0};        ///< (n + 1)
    Array<Index> edges;                   ///< numbers in the level
    Array<Index> faces;                   ///< numbers in the level, in the rows of `offsets`
    Array<Offset> ring_offsets{0};        ///< of each corner of each cell
    Array<Index> ring_edges, ring_faces;  ///< places in the cell

    Index size() const { return static_cast<Index>(offsets.size()) - 1; }
    Offset Bytes() const;
};

struct PolyhedralLevel {
    Index n_vertices = 0;
    Index n_edges = 0;
    Index n_faces = 0;
    Index n_hexes = 0;
    Index n_boundary_faces = 0;
    bool is_full = false;

    // Always there.
    Array<Index> hex_vertices;  ///< (n_hexes, 8)
    Polyhedra polyhedra;
    RowOffsets boundary_rows{{}, 4};
    Array<Index> boundary_vertices;  ///< faces that bound one cell (seen from outside) or none, ascending by face

    // Full levels only: downward.
    Array<Index> boundary_faces;  ///< (n_boundary_faces): their face numbers
    Array<Index> hex_edges;       ///< (n_hexes, 12)
    Array<Index> hex_faces;       ///< (n_hexes, 6)
    RowOffsets face_rows{{}, 4};
    Array<Index> face_vertices;  ///< around the face
    Array<Index> face_edges;     ///< edge k goes from corner k to the next
    Array<Index> face_cells;     ///< (n_faces, 2): seen as listed from outside the first; kNoIndex: none
    Array<Index> edge_vertices;  ///< (n_edges, 2), ascending
    Array<Tag> vertex_tags;
    Array<Tag> edge_tags;

    // Full levels only: upward, what the rules ask for.
    Relation vertex_edges;
    Relation vertex_cells;
    Relation edge_faces;

    Index n_polyhedra() const { return polyhedra.size(); }
    Offset n_cells() const { return static_cast<Offset>(n_hexes) + n_polyhedra(); }
    bool IsHex(Index cell) const { return cell < n_hexes; }

    std::span<const Index, 2> EdgeVertices(Index e) const {
        return std::span<const Index, 2>(edge_vertices.data() + 2 * static_cast<std::size_t>(e), 2);
    }
    std::span<const Index> FaceVertices(Index f) const { return face_rows.Row(face_vertices, f); }
    std::span<const Index> FaceEdges(Index f) const { return face_rows.Row(face_edges, f); }
    std::span<const Index> BoundaryVertices(Index b) const { return boundary_rows.Row(boundary_vertices, b); }
    std::span<const Index, 2> FaceCells(Index f) const {
        return std::span<const Index, 2>(face_cells.data() + 2 * static_cast<std::size_t>(f), 2);
    }
    int NCells(Index f) const { return (FaceCells(f)[0] != kNoIndex) + (FaceCells(f)[1] != kNoIndex); }
    bool IsBoundary(Index f) const { return NCells(f) < 2; }

    /// Corners of a cell, its edges and faces. @pre is_full
    std::span<const Index> CellVertices(Index c) const {
        return IsHex(c) ? Fixed(hex_vertices, c, Sdc::Hex::kVertices)
                        : Row(polyhedra.vertices, polyhedra.vertex_offsets, c - n_hexes);
    }
    std::span<const Index> CellEdges(Index c) const {
        return IsHex(c) ? Fixed(hex_edges, c, Sdc::Hex::kEdges)
                        : Row(polyhedra.edges, polyhedra.edge_offsets, c - n_hexes);
    }
    std::span<const Index> CellFaces(Index c) const {
        return IsHex(c) ? Fixed(hex_faces, c, Sdc::Hex::kFaces) : Row(polyhedra.faces, polyhedra.offsets, c - n_hexes);
    }

    /// The end of an edge that is not v.
    Index OtherEnd(Index e, Index v) const {
        const auto ends = EdgeVertices(e);
        return ends[0] == v ? ends[1] : ends[0];
    }
    /// The edge from a to b, or kNoIndex. Cost: a walk over the edges of a.
    Index FindEdge(Index a, Index b) const;

    /// What the arrays take, in bytes.
    Offset Bytes() const;

  private:
    static std::span<const Index> Fixed(const Array<Index>& array, Index i, int n) {
        return {array.data() + static_cast<std::size_t>(i) * static_cast<std::size_t>(n), static_cast<std::size_t>(n)};
    }
    static std::span<const Index> Row(const Array<Index>& array, const Array<Offset>& offsets, Index i) {
        return {array.data() + offsets[i], static_cast<std::size_t>(offsets[i + 1] - offsets[i])};
    }
};

}  // namespace SolidSubdiv::Vtr
