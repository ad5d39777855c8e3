// SPDX-License-Identifier: Apache-2.0
// Between control lattices and meshes in files.
#pragma once

#include <vector>

#include <solidsubdiv/apps/deform/control_lattice.h>
#include <solidsubdiv/kit/geometry/box.h>
#include <solidsubdiv/kit/io/mesh.h>

namespace SolidSubdiv::Cli {

/// The lattice as a mesh, with cell data `parent` where parents are given (in the lattice's order of cells).
Io::Mesh MeshOf(const Deform::ControlLattice& lattice, const std::vector<Index>& parents);

/// Triangles of a model's faces, larger faces cut into fans; of solids those of the boundary.
std::vector<Index> SurfaceTriangles(const Io::Mesh& model);

/// Hexahedra, the mean of whose corners is in the box.
std::vector<Index> CellsWithMiddleIn(const Deform::ControlLattice& lattice, const Geometry::Box& box);

}  // namespace SolidSubdiv::Cli
