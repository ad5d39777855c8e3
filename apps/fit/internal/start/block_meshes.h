// SPDX-License-Identifier: Apache-2.0
// What can be made of cubes: a lattice of hexahedra with a layer on its boundary, tets and octahedra, a cage.
#pragma once

#include <vector>

#include <solidsubdiv/apps/fit/control_mesh.h>
#include <solidsubdiv/apps/fit/internal/start/blocks.h>

namespace SolidSubdiv::Fit::Starting {

enum class BlockMeshKind { Hexes, Tets, Quads };

struct BlockMesh {
    ControlMesh mesh;
    std::vector<Index> boundary;  ///< its boundary faces, counterclockwise from outside
    std::size_t n_corners = 4;    ///< of a boundary face
};

/// All its cells are positive. @pre Blocks::Repair()
BlockMesh MakeBlockMesh(const Blocks& blocks, BlockMeshKind kind);

/// How many control points that has.
Index CountControlPoints(const Blocks& blocks, BlockMeshKind kind);

}  // namespace SolidSubdiv::Fit::Starting
