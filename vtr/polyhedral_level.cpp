// SPDX-License-Identifier: Apache-2.0
// Sums and relations of one level of polyhedra.
#include <solidsubdiv/vtr/polyhedral_level.h>

namespace SolidSubdiv::Vtr {

namespace {

template <class... Arrays>
Offset BytesOf(const Arrays&... arrays) {
    return (static_cast<Offset>(arrays.size() * sizeof(arrays[0])) + ...);
}

}  // namespace

Offset Polyhedra::Bytes() const {
    return BytesOf(offsets, face_vertex_offsets, face_vertices, vertex_offsets, vertices, edge_offsets, edges, faces,
                   ring_offsets, ring_edges, ring_faces);
}

Index PolyhedralLevel::FindEdge(Index a, Index b) const {
    for (Index e : vertex_edges[a]) {
        if (OtherEnd(e, a) == b) return e;
    }
    return kNoIndex;
}

Offset PolyhedralLevel::Bytes() const {
    return BytesOf(hex_vertices, boundary_rows.offsets, boundary_vertices, boundary_faces, hex_edges, hex_faces,
                   face_rows.offsets, face_vertices, face_edges, face_cells, edge_vertices, vertex_tags, edge_tags) +
           polyhedra.Bytes() + vertex_edges.Bytes() + vertex_cells.Bytes() + edge_faces.Bytes();
}

}  // namespace SolidSubdiv::Vtr
