// SPDX-License-Identifier: Apache-2.0
// How many components levels of polyhedra have, and what they take.
#include <solidsubdiv/vtr/polyhedral_refinement.h>

#include <algorithm>

#include <solidsubdiv/vtr/internal/odd_cells.h>

namespace SolidSubdiv::Vtr {

Offset PolyhedralCounts::Largest() const {
    return std::max({n_vertices, n_edges, n_faces, n_cells(), n_boundary_faces, n_face_corners});
}

PolyhedralCounts CountsOf(const PolyhedralLevel& level) {
    PolyhedralCounts n;
    n.n_vertices = level.n_vertices;
    n.n_edges = level.n_edges;
    n.n_faces = level.n_faces;
    n.n_hexes = level.n_hexes;
    n.n_polyhedra = level.n_polyhedra();
    n.n_boundary_faces = level.n_boundary_faces;
    n.n_face_corners = static_cast<Offset>(level.face_vertices.size());
    const Polyhedra& p = level.polyhedra;
    n.n_poly_vertices = static_cast<Offset>(p.vertices.size());
    n.n_poly_edges = static_cast<Offset>(p.edges.size());
    n.n_poly_faces = static_cast<Offset>(p.faces.size());
    n.n_boundary_corners = static_cast<Offset>(level.boundary_vertices.size());
    const Internal::OddCorners odd = Internal::CountOddCorners(p).back();
    n.n_odd_corners = odd.n;
    n.n_odd_edges = odd.n_edges;
    return n;
}

PolyhedralCounts Refine(const PolyhedralCounts& p) {
    PolyhedralCounts n;
    n.n_vertices = p.n_vertices + p.n_edges + p.n_faces + p.n_cells();
    n.n_edges = 2 * p.n_edges + p.n_face_corners + Sdc::Hex::kFaces * p.n_hexes + p.n_poly_faces;
    n.n_faces = p.n_face_corners + Sdc::Hex::kEdges * p.n_hexes + p.n_poly_edges;
    n.n_hexes = 8 * p.n_hexes + p.n_poly_vertices - p.n_odd_corners;
    n.n_polyhedra = p.n_odd_corners;
    n.n_boundary_faces = p.n_boundary_corners;
    n.n_face_corners = 4 * n.n_faces;
    n.n_poly_vertices = 2 * p.n_odd_edges + 2 * p.n_odd_corners;
    n.n_poly_edges = 4 * p.n_odd_edges;
    n.n_poly_faces = 2 * p.n_odd_edges;
    n.n_boundary_corners = 4 * n.n_boundary_faces;
    n.n_odd_corners = 2 * p.n_odd_corners;  // of each such cell two corners have as many edges as the one it stands on
    n.n_odd_edges = 2 * p.n_odd_edges;
    return n;
}

Offset EstimateBytes(const PolyhedralCounts& c, bool full) {
    constexpr Offset index = sizeof(Index), offset = sizeof(Offset);
    Offset bytes = index * (8 * c.n_hexes + 4 * c.n_boundary_faces + 4 * c.n_poly_faces) +
                   offset * (c.n_polyhedra + c.n_poly_faces);
    if (full) {
        bytes += index * (18 * c.n_hexes + c.n_boundary_faces + 10 * c.n_faces + 2 * c.n_edges);
        bytes += index * (c.n_poly_vertices + c.n_poly_edges + c.n_poly_faces + 4 * c.n_poly_edges) +
                 offset * (2 * c.n_polyhedra + c.n_poly_vertices);
        bytes += c.n_vertices + c.n_edges;
        bytes += offset * (2 * c.n_vertices + c.n_edges) +
                 index * (2 * c.n_edges + 4 * c.n_faces + 8 * c.n_hexes + c.n_poly_vertices);
    }
    return bytes;
}

}  // namespace SolidSubdiv::Vtr
