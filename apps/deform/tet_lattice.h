// SPDX-License-Identifier: Apache-2.0
// A lattice of tets and octahedra in the place of one of bricks, for the schemes that refine those.
//
//     const auto hierarchy = Deform::MakeOctreeLattices(points, triangles, {.levels = 3});
//     const Deform::LatticeLevel& level = hierarchy.levels[3];
//     const auto tets = Deform::MakeTetLattice(level.lattice, level.cells);
//
// Corners of a grid are even or odd by the sum of their coordinates; edges join even to odd ones. A cell is cut into a
// tet of its four even corners, in the middle, and one at each of its four odd corners. Where all eight cells around an
// odd corner are there, the eight tets at it are joined to one octahedron, and the corner goes:
//
//      o-------e      e: even corners, o: odd ones
//     /|      /|
//    e-------o |      That is the octet truss: its edges are the diagonals of the cells' faces, with two tets and two
//    | e-----|-o      octahedra in turn around each. Octahedra have their major diagonal along z, tets the order that
//    |/      |/       goes with it: neighbours agree, so inside the truss the refined lattice is regular, and the
//    o-------e        box-spline scheme the box spline itself.
//
// What is cut fills what the cells fill, and its boundary is theirs, every face cut along the diagonal between its even
// corners.
//
// Source: rules.md, sections 1 and 9; chang2002boxspline, sections 3.1 and 5.1.
#pragma once

#include <array>
#include <span>
#include <vector>

#include <solidsubdiv/apps/deform/control_lattice.h>

namespace SolidSubdiv::Deform {

struct TetLattice {
    ControlLattice lattice;             ///< tets and octahedra
    std::vector<Index> control_points;  ///< (control points): their numbers in the lattice of bricks, ascending
    std::vector<Index> parents;         ///< (tets): the cell that each is cut from
    std::vector<Index> centres;         ///< (octs): the control point that was there, of the lattice of bricks
};

/// Cuts hexahedra that lie at `cells` in a grid (LatticeLevel::cells). Cells of a box that is not folded or shrunken
/// are positive; of others the tet in the middle may be inverted although the hexahedron is not.
/// @throws InvalidInput where there are other cells than hexahedra or not as many places, a cell has a corner that is
/// not there, a corner is at two places, or two cells are in one
TetLattice MakeTetLattice(const ControlLattice& hexes, std::span<const std::array<Index, 3>> cells);

}  // namespace SolidSubdiv::Deform
