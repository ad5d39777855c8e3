// SPDX-License-Identifier: Apache-2.0
// Polyhedra as their faces, and what cuts share; see internal/cell_shapes.h.
#include <solidsubdiv/kit/picture/internal/cell_shapes.h>
#include <solidsubdiv/sdc/errors.h>

#include <algorithm>
#include <cmath>

namespace SolidSubdiv::Picture::Internal {

void CellFaces::SetPolyhedron(const Io::Topology& topology, Offset cell) {
    kind_ = CellKind::Polyhedron;
    const auto c = static_cast<std::size_t>(cell);
    const auto first_face = static_cast<std::size_t>(topology.polyhedron_offsets[c]);
    const auto end_face = static_cast<std::size_t>(topology.polyhedron_offsets[c + 1]);
    const Offset first = topology.polyhedron_face_offsets[first_face], end = topology.polyhedron_face_offsets[end_face];
    corners_.assign(topology.polyhedron_vertices.begin() + first, topology.polyhedron_vertices.begin() + end);
    ends_.clear();
    for (std::size_t f = first_face; f < end_face; ++f) {
        ends_.push_back(static_cast<std::size_t>(topology.polyhedron_face_offsets[f + 1] - first));
    }
    vertices_ = corners_;
    std::sort(vertices_.begin(), vertices_.end());
    vertices_.erase(std::unique(vertices_.begin(), vertices_.end()), vertices_.end());
}

void CheckPlane(const Plane& plane) {
    const double length = std::hypot(plane.normal[0], plane.normal[1], plane.normal[2]);
    if (!(length > 0 && std::isfinite(length))) {
        throw InvalidInput("picture: a cut plane's normal must be finite and not zero");
    }
}

std::vector<Index> UniqueEdges(std::vector<std::array<Index, 2>> edges) {
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    std::vector<Index> flat;
    flat.reserve(2 * edges.size());
    for (const auto& e : edges) flat.insert(flat.end(), e.begin(), e.end());
    return flat;
}

}  // namespace SolidSubdiv::Picture::Internal
