// SPDX-License-Identifier: Apache-2.0
// Sharp edges of a target cut into a lattice of tets, as creases of its boundary.
//
//     Fit::ControlMesh lattice = Fit::MakeSolidStart(target, {.n_control = 300, .tets = true, .creases = 50});
//
// does this for itself. Sharp edges part the target into patches. What lies on one patch and what on another is parted
// on the lattice's boundary too: where an edge leads from one patch to another, its nearer end moves to the sharp edge
// between them, or a vertex is put there, which cuts the tets around the edge in two:
//
//     1-----1-----2        1-----1---x-2     1, 2: patches of vertices
//     | \   | \   |        | \   | / \ |     x: on the sharp edge between them; x to x is a crease
//     |   \ |   \ |   ->   |   \ x-----x
//     1-----2-----2        1---x-2-----2
//
// Triangles are what this needs: where a path has two edges of a quadrilateral, the cell behind it gets a flat corner;
// where it would have two of a triangle, it takes the third.
//
// Cells that get flat corners on a smooth boundary or a smooth crease are cut, too (internal/flat_cells.h).
#pragma once

#include <solidsubdiv/apps/fit/control_mesh.h>

namespace SolidSubdiv::Fit {

struct CutReport {
    Index n_creases = 0;  ///< edges
    Index n_corners = 0;  ///< vertices where three and more patches meet
    Index n_added = 0;    ///< vertices
};

/// All cells stay positive; some octahedra become tets.
/// @param target closed, and looking outwards
/// @param degrees [0, 180): between the normals of two triangles whose edge is sharp; 0: none is, only cells with flat
/// corners are cut
/// @throws InvalidInput where the mesh has hexahedra or no cells, or degrees are out of range
CutReport CutCreases(ControlMesh& mesh, const TargetSurface& target, double degrees);

}  // namespace SolidSubdiv::Fit
