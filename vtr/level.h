// SPDX-License-Identifier: Apache-2.0
// The topology of one level: a complex of tets, octs, triangles and edges as arrays of indices. No positions, no rules.
//
// Components of the same dimension are numbered from 0. Cells know their vertices, edges and faces in the order of
// sdc/cells.h; faces and edges list their vertices ascending, so that which end of an edge and which corner of a face a
// vertex is follows from indices alone. Orientation lives in the cells and in the boundary.
//
// Upward relations and edge and face tables are there when is_full; the last level of a refinement usually keeps its
// vertices of cells and its boundary only.
#pragma once

#include <span>

#include <solidsubdiv/sdc/types.h>
#include <solidsubdiv/vtr/relation.h>
#include <solidsubdiv/vtr/tags.h>

namespace SolidSubdiv::Vtr {

struct Level {
    Index n_vertices = 0;
    Index n_edges = 0;
    Index n_faces = 0;
    Index n_tets = 0;
    Index n_octs = 0;
    Index n_boundary_faces = 0;
    bool is_full = false;

    // Always there.
    Array<Index> tet_vertices;  ///< (n_tets, 4)
    Array<Index> oct_vertices;  ///< (n_octs, 6)
    /// Faces that bound one cell (vertices counterclockwise from outside) or none (as given), ascending by face.
    Array<Index> boundary_vertices;  ///< (n_boundary_faces, 3)

    // Full levels only: downward.
    Array<Index> boundary_faces;  ///< (n_boundary_faces): their face numbers
    Array<Index> tet_edges;       ///< (n_tets, 6)
    Array<Index> tet_faces;       ///< (n_tets, 4)
    Array<Index> oct_edges;       ///< (n_octs, 12)
    Array<Index> oct_faces;       ///< (n_octs, 8)
    Array<Index> face_vertices;   ///< (n_faces, 3), ascending
    Array<Index> face_edges;      ///< (n_faces, 3): edge k lies opposite vertex k
    Array<Index> edge_vertices;   ///< (n_edges, 2), ascending
    Array<Tag> vertex_tags;
    Array<Tag> edge_tags;
    Array<FaceTag> face_tags;

    // Full levels only: upward, what the rules ask for.
    Relation vertex_edges;
    Relation vertex_octs;  ///< with locals: which vertex of the oct
    Relation edge_faces;
    Relation edge_octs;  ///< with locals: which edge of the oct

    Offset n_cells() const { return static_cast<Offset>(n_tets) + n_octs; }

    std::span<const Index, 4> TetVertices(Index t) const { return Row<4>(tet_vertices, t); }
    std::span<const Index, 6> OctVertices(Index o) const { return Row<6>(oct_vertices, o); }
    std::span<const Index, 6> TetEdges(Index t) const { return Row<6>(tet_edges, t); }
    std::span<const Index, 4> TetFaces(Index t) const { return Row<4>(tet_faces, t); }
    std::span<const Index, 12> OctEdges(Index o) const { return Row<12>(oct_edges, o); }
    std::span<const Index, 8> OctFaces(Index o) const { return Row<8>(oct_faces, o); }
    std::span<const Index, 3> FaceVertices(Index f) const { return Row<3>(face_vertices, f); }
    std::span<const Index, 3> FaceEdges(Index f) const { return Row<3>(face_edges, f); }
    std::span<const Index, 2> EdgeVertices(Index e) const { return Row<2>(edge_vertices, e); }
    std::span<const Index, 3> BoundaryVertices(Index b) const { return Row<3>(boundary_vertices, b); }

    /// The vertex of face f that edge e of it does not have.
    Index ThirdVertex(Index f, Index e) const {
        const auto v = FaceVertices(f);
        const auto ends = EdgeVertices(e);
        return v[0] + v[1] + v[2] - ends[0] - ends[1];
    }

    /// The edge from a to b, or kNoIndex. Cost: a walk over the edges of a.
    Index FindEdge(Index a, Index b) const;

    /// What the arrays take, in bytes.
    Offset Bytes() const;

  private:
    template <std::size_t N>
    static std::span<const Index, N> Row(const Array<Index>& array, Index i) {
        return std::span<const Index, N>(array.data() + static_cast<std::size_t>(i) * N, N);
    }
};

}  // namespace SolidSubdiv::Vtr
