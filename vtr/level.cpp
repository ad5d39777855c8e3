// SPDX-License-Identifier: Apache-2.0
// Sums and relations of one level.
#include <solidsubdiv/vtr/level.h>

namespace SolidSubdiv::Vtr {

Index Level::FindEdge(Index a, Index b) const {
    for (Index e : vertex_edges[a]) {
        const auto v = EdgeVertices(e);
        if (v[0] + v[1] - a == b) return e;
    }
    return kNoIndex;
}

Offset Level::Bytes() const {
    Offset n = 0;
    for (const Array<Index>* a : {&tet_vertices, &oct_vertices, &boundary_vertices, &boundary_faces, &tet_edges,
                                  &tet_faces, &oct_edges, &oct_faces, &face_vertices, &face_edges, &edge_vertices}) {
        n += static_cast<Offset>(a->size() * sizeof(Index));
    }
    n += static_cast<Offset>(vertex_tags.size() + edge_tags.size() + face_tags.size());
    for (const Relation* r : {&vertex_edges, &vertex_octs, &edge_faces, &edge_octs}) n += r->Bytes();
    return n;
}

}  // namespace SolidSubdiv::Vtr
