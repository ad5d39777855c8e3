// SPDX-License-Identifier: Apache-2.0
// The elements of a level of the polyhedral split.
#include <solidsubdiv/apps/cli/refined_polyhedra.h>

#include <algorithm>
#include <map>

namespace SolidSubdiv::Cli {

namespace {

/// Calls body(row, vertices) for the control mesh's triangles, quads and polygons, with their rows of cell data.
template <class Body>
void ForFaces(const Io::Topology& t, Body&& body) {
    Offset row = t.n_cells();
    const auto fixed = [&](const std::vector<Index>& faces, std::size_t arity) {
        for (std::size_t i = 0; i < faces.size(); i += arity) body(row++, std::span(faces).subspan(i, arity));
    };
    fixed(t.triangles, 3);
    fixed(t.quads, 4);
    for (Offset i = 0; i < t.n_polygons(); ++i) {
        const Offset begin = t.polygon_offsets[i];
        body(row++, std::span(t.polygon_vertices).subspan(begin, t.polygon_offsets[i + 1] - begin));
    }
}

std::vector<Index> Ascending(std::span<const Index> vertices) {
    std::vector<Index> sorted(vertices.begin(), vertices.end());
    std::sort(sorted.begin(), sorted.end());
    return sorted;
}

}  // namespace

RefinedPolyhedra::RefinedPolyhedra(const Io::Topology& control, const Far::TopologyRefiner& refiner,
                                   const FacesLeftOut& left_out)
    : control_(control), refiner_(refiner), edges_(control, refiner) {
    FindFaces();
    n_tags_ = control.n_triangles() + control.n_quads() + control.n_polygons() - static_cast<Offset>(faces_.size()) +
              control.n_edges() - edges_.n_parts();
    left_out_ = TakeLeftOut(faces_, left_out, refiner);
}

void RefinedPolyhedra::FindFaces() {
    const Vtr::PolyhedralLevel& base = refiner_.polyhedral_level(0);
    std::map<std::vector<Index>, Index> places;
    for (Index b = 0; b < base.n_boundary_faces; ++b) {
        if (base.NCells(base.boundary_faces[b]) == 0) places.emplace(Ascending(base.BoundaryVertices(b)), b);
    }
    if (places.empty()) return;
    ForFaces(control_, [&](Offset row, std::span<const Index> vertices) {
        const auto found = places.find(Ascending(vertices));
        if (found != places.end()) faces_.push_back({row, found->second});
    });
}

Offset RefinedPolyhedra::First(Index boundary_face, int level) const {
    if (level == 0) return boundary_face;
    return refiner_.polyhedral_level(0).boundary_rows.Start(boundary_face) << (2 * (level - 1));
}

Io::Topology RefinedPolyhedra::At(int level) const {
    if (level == 0) return control_;
    const Vtr::PolyhedralLevel& from = refiner_.polyhedral_level(level);
    Io::Topology topology;
    topology.n_vertices = from.n_vertices;
    topology.hexes.assign(from.hex_vertices.begin(), from.hex_vertices.end());
    if (from.n_polyhedra() > 0) {
        const Vtr::Polyhedra& p = from.polyhedra;
        topology.polyhedron_offsets.assign(p.offsets.begin(), p.offsets.end());
        topology.polyhedron_face_offsets.assign(p.face_vertex_offsets.begin(), p.face_vertex_offsets.end());
        topology.polyhedron_vertices.assign(p.face_vertices.begin(), p.face_vertices.end());
    }
    for (const FacePart& part : faces_) {
        const auto first = from.boundary_vertices.begin() + 4 * First(part.place, level);
        const auto last = from.boundary_vertices.begin() + 4 * First(part.place + 1, level);
        topology.quads.insert(topology.quads.end(), first, last);
    }
    topology.edges = edges_.At(level);
    return topology;
}

std::vector<Offset> RefinedPolyhedra::ControlRows(int level) const {
    const Offset n_before = control_.n_tets() + control_.n_octs();
    const Vtr::PolyhedralLevel& base = refiner_.polyhedral_level(0);
    // Cells of level 0 are the hexahedra, then tets and octs, then the others in the mesh's order.
    std::vector<Offset> hexes, others;
    for (Offset h = 0; h < base.n_hexes; ++h) hexes.push_back(n_before + h);
    for (Offset i = 0; i < base.n_polyhedra(); ++i) others.push_back(i < n_before ? i : base.n_hexes + i);
    for (int i = 0; i < level; ++i) {
        const Vtr::Polyhedra& parent = refiner_.polyhedral_level(i).polyhedra;
        std::vector<Offset> child_hexes, child_others;
        child_hexes.reserve(8 * hexes.size());
        for (Offset row : hexes) child_hexes.insert(child_hexes.end(), 8, row);
        for (Index p = 0; p < parent.size(); ++p) {
            for (Offset corner = parent.vertex_offsets[p]; corner < parent.vertex_offsets[p + 1]; ++corner) {
                const bool is_hex = parent.ring_offsets[corner + 1] - parent.ring_offsets[corner] == 3;
                (is_hex ? child_hexes : child_others).push_back(others[static_cast<std::size_t>(p)]);
            }
        }
        hexes = std::move(child_hexes);
        others = std::move(child_others);
    }
    std::vector<Offset> rows = std::move(hexes);
    rows.insert(rows.end(), others.begin(), others.end());
    for (const FacePart& part : faces_) {
        rows.insert(rows.end(), static_cast<std::size_t>(First(part.place + 1, level) - First(part.place, level)),
                    part.row);
    }
    const Offset first_edge = control_.n_elements() - control_.n_edges() - control_.n_point_elements();
    for (Index edge : edges_.Origins(level)) rows.push_back(first_edge + edge);
    return rows;
}

std::vector<bool> RefinedPolyhedra::LeftOut(int level) const {
    std::vector<bool> is_left_out;
    if (left_out_.empty()) return is_left_out;
    is_left_out.assign(static_cast<std::size_t>(refiner_.polyhedral_level(level).n_boundary_faces), false);
    for (Index place : left_out_) {
        std::fill(is_left_out.begin() + First(place, level), is_left_out.begin() + First(place + 1, level), true);
    }
    return is_left_out;
}

void AddPolygons(const Vtr::RowOffsets& rows, std::span<const Index> corners, Io::Topology& topology) {
    const Index n =
        rows.is_fixed() ? static_cast<Index>(corners.size()) / rows.fixed : static_cast<Index>(rows.offsets.size()) - 1;
    for (Index b = 0; b < n; ++b) {
        const auto face = corners.subspan(rows.Start(b), rows.Count(b));
        if (face.size() > 4) {
            if (topology.polygon_offsets.empty()) topology.polygon_offsets.push_back(0);
            topology.polygon_vertices.insert(topology.polygon_vertices.end(), face.begin(), face.end());
            topology.polygon_offsets.push_back(static_cast<Offset>(topology.polygon_vertices.size()));
        } else {
            std::vector<Index>& same = face.size() == 3 ? topology.triangles : topology.quads;
            same.insert(same.end(), face.begin(), face.end());
        }
    }
}

}  // namespace SolidSubdiv::Cli
