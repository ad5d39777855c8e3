// SPDX-License-Identifier: Apache-2.0
// Arrays have the same names and orders, but that a mesh's tets come before its hexahedra.
#include <solidsubdiv/apps/cli/lattice_mesh.h>

#include <algorithm>

#include <solidsubdiv/apps/cli/mesh_kinds.h>
#include <solidsubdiv/far/topology_refiner.h>
#include <solidsubdiv/kit/geometry/compact_surface.h>

namespace SolidSubdiv::Cli {

namespace {

template <class Row>
void AddFan(const Row& face, std::vector<Index>& triangles) {
    for (std::size_t i = 2; i < face.size(); ++i) triangles.insert(triangles.end(), {face[0], face[i - 1], face[i]});
}

}  // namespace

Io::Mesh MeshOf(const Deform::ControlLattice& lattice, const std::vector<Index>& parents) {
    Io::Mesh mesh;
    mesh.topology.n_vertices = lattice.n_control_points();
    mesh.topology.tets = lattice.tets;
    mesh.topology.octs = lattice.octs;
    mesh.topology.hexes = lattice.hexes;
    mesh.topology.polyhedron_offsets = lattice.polyhedron_offsets;
    mesh.topology.polyhedron_face_offsets = lattice.polyhedron_face_offsets;
    mesh.topology.polyhedron_vertices = lattice.polyhedron_vertices;
    mesh.positions = lattice.positions;
    if (!parents.empty()) {  // hexahedra, then polyhedra, in both
        mesh.cell_data.push_back({"parent", 1, std::vector<double>(parents.begin(), parents.end())});
    }
    return mesh;
}

std::vector<Index> SurfaceTriangles(const Io::Mesh& model) {
    const Io::Topology& t = model.topology;
    if (t.n_cells() > 0) {
        const bool is_tet_oct = IsTetOct(t);
        const auto refiner =
            Far::TopologyRefiner::Create(t.View(), is_tet_oct ? Sdc::Split::TetOct : Sdc::Split::Polyhedral);
        std::vector<Index> triangles;
        if (is_tet_oct) {
            const auto& corners = refiner.level(0).boundary_vertices;
            triangles.assign(corners.begin(), corners.end());
        } else {
            const Vtr::PolyhedralLevel& level = refiner.polyhedral_level(0);
            for (Index f = 0; f < level.n_boundary_faces; ++f) AddFan(level.BoundaryVertices(f), triangles);
        }
        return triangles;
    }
    std::vector<Index> triangles = t.triangles;
    for (std::size_t q = 0; q + 4 <= t.quads.size(); q += 4) AddFan(std::span(t.quads).subspan(q, 4), triangles);
    for (Offset p = 0; p < t.n_polygons(); ++p) {
        const auto first = static_cast<std::size_t>(t.polygon_offsets[p]);
        AddFan(std::span(t.polygon_vertices).subspan(first, static_cast<std::size_t>(t.polygon_offsets[p + 1]) - first),
               triangles);
    }
    return triangles;
}

std::vector<Index> CellsWithMiddleIn(const Deform::ControlLattice& lattice, const Geometry::Box& box) {
    std::vector<Index> cells;
    for (std::size_t h = 0; 8 * h < lattice.hexes.size(); ++h) {
        bool is_in = true;
        for (std::size_t c = 0; c < 3; ++c) {
            double sum = 0;
            for (std::size_t i = 0; i < 8; ++i) {
                sum += lattice.positions[3 * static_cast<std::size_t>(lattice.hexes[8 * h + i]) + c];
            }
            is_in = is_in && sum / 8 >= box.low[c] && sum / 8 <= box.high[c];
        }
        if (is_in) cells.push_back(static_cast<Index>(h));
    }
    return cells;
}

}  // namespace SolidSubdiv::Cli
