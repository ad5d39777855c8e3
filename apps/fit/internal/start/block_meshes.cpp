// SPDX-License-Identifier: Apache-2.0
// Corners of cubes become control points.
#include <solidsubdiv/apps/fit/internal/start/block_meshes.h>

#include <utility>

#include <solidsubdiv/apps/deform/tet_lattice.h>
#include <solidsubdiv/far/topology_refiner.h>
#include <solidsubdiv/kit/geometry/compact_surface.h>

namespace SolidSubdiv::Fit::Starting {

namespace {

/// Corners of the boundary go inwards, and copies take their places: a hexahedron for each face between both. They go
/// a seventh of a cube along each axis at which faces look. So edges of cubes keep 5/7 of their length and lean by at
/// most 2/7 along each other axis, which leaves all determinants positive; and where a face was there is one moved by
/// a seventh, still flat.
BlockMesh WithLayer(Blocks::Mesh&& blocks, double size) {
    BlockMesh made;
    ControlMesh& mesh = made.mesh;
    mesh.positions = std::move(blocks.positions);
    mesh.hexes = std::move(blocks.hexes);
    made.boundary = std::move(blocks.quads);
    std::vector<Index> copies(blocks.outward.size(), kNoIndex);
    for (std::size_t v = 0; v < copies.size(); ++v) {
        const auto& out = blocks.outward[v];
        if (out == std::array<int, 3>{}) continue;
        copies[v] = mesh.n_vertices();
        for (std::size_t k = 0; k < 3; ++k) {
            mesh.positions.push_back(mesh.positions[3 * v + k]);
            mesh.positions[3 * v + k] -= size / 7 * out[k];
        }
    }
    for (std::size_t q = 0; q < made.boundary.size(); q += 4) {
        mesh.hexes.insert(mesh.hexes.end(), &made.boundary[q], &made.boundary[q] + 4);
        for (std::size_t k = 0; k < 4; ++k) {
            Index& corner = made.boundary[q + k];
            corner = copies[static_cast<std::size_t>(corner)];
            mesh.hexes.push_back(corner);
        }
    }
    return made;
}

Deform::TetLattice TetsOf(Blocks::Mesh&& blocks) {
    Deform::ControlLattice lattice;
    lattice.positions = std::move(blocks.positions);
    lattice.hexes = std::move(blocks.hexes);
    return Deform::MakeTetLattice(lattice, blocks.cells);
}

BlockMesh WithTets(Blocks::Mesh&& blocks) {
    BlockMesh made;
    Deform::TetLattice tets = TetsOf(std::move(blocks));
    made.mesh.positions = std::move(tets.lattice.positions);
    made.mesh.tets = std::move(tets.lattice.tets);
    made.mesh.octs = std::move(tets.lattice.octs);
    made.n_corners = 3;
    const auto refiner = Far::TopologyRefiner::Create(made.mesh.View(), Sdc::Split::TetOct);
    const auto& boundary = refiner.level(0).boundary_vertices;
    made.boundary.assign(boundary.begin(), boundary.end());
    return made;
}

BlockMesh BoundaryOf(Blocks::Mesh&& blocks) {
    BlockMesh made;
    const auto surface = Geometry::MakeCompactSurface(blocks.quads, static_cast<Index>(blocks.outward.size()));
    made.mesh.positions = Geometry::GatherRows(blocks.positions, 3, surface.vertices);
    made.mesh.quads = made.boundary = surface.corners;
    return made;
}

}  // namespace

BlockMesh MakeBlockMesh(const Blocks& blocks, BlockMeshKind kind) {
    switch (kind) {
        case BlockMeshKind::Hexes:
            return WithLayer(blocks.MakeMesh(), blocks.size());
        case BlockMeshKind::Tets:
            return WithTets(blocks.MakeMesh());
        case BlockMeshKind::Quads:
            break;
    }
    return BoundaryOf(blocks.MakeMesh());
}

Index CountControlPoints(const Blocks& blocks, BlockMeshKind kind) {
    const Blocks::Counts counts = blocks.Count();
    switch (kind) {
        case BlockMeshKind::Hexes:
            return counts.corners + counts.boundary_corners;
        case BlockMeshKind::Tets:
            return static_cast<Index>(TetsOf(blocks.MakeMesh()).control_points.size());
        case BlockMeshKind::Quads:
            break;
    }
    return counts.boundary_corners;
}

}  // namespace SolidSubdiv::Fit::Starting
