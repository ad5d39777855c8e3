// SPDX-License-Identifier: Apache-2.0
// A lattice that is finer where it is wanted: chosen cells split by the octree rule, their neighbours joined to them.
//
//     const auto split = Deform::SplitCells(lattice, {3, 7});
//     const auto finer = Deform::SplitCells(split.lattice, chosen_again);
//
// A chosen cell is split at all its corners, as the polyhedral split does it: points in the middle of its edges, its
// faces and itself. A neighbour that is not chosen takes over what is split of it: a split face becomes the faces that
// it was split into, and a face with split edges a polygon with their middles as corners of its own. So neighbours
// become polyhedra, faces still meet face to face, and the lattice is one that any scheme for polyhedra refines.
//
//      +-------+-------+      +---+---+-------+
//      |       |       |      |   |   |       |
//      | split |       |  ->  +---+---+       |    the right cell has five corners now
//      |       |       |      |   |   |       |
//      +-------+-------+      +---+---+-------+
//
// The shape of the lattice does not change where its faces are planar. In a neighbour the middle of an edge may be a
// corner of two edges only: the split knows how to go on from there.
//
// Source: ono2002ffd, section 2.2 and figure 3.
#pragma once

#include <initializer_list>
#include <span>
#include <vector>

#include <solidsubdiv/apps/deform/control_lattice.h>
#include <solidsubdiv/far/stencil_table.h>

namespace SolidSubdiv::Deform {

struct SplitLattice {
    ControlLattice lattice;
    std::vector<Index> parents;  ///< (cells): the cell before that each is, or is a part of
    /// (control points) over those before. These stay, the first of all, in their order; then come middles of edges, of
    /// faces, of cells, in the order in which a level of the refiner numbers those.
    Far::StencilRows<double> rows;
};

/// Splits cells of a lattice of any cells. Topology alone decides, so control points may be where they like. A cell may
/// be named more than once. With all cells this is the refiner's uniform split; with none the lattice stays as it is.
/// Cost: a uniform split of the whole lattice.
/// @throws InvalidInput naming a cell that is not there, or as TopologyRefiner::Create
SplitLattice SplitCells(const ControlLattice& lattice, std::span<const Index> cells);

inline SplitLattice SplitCells(const ControlLattice& lattice, std::initializer_list<Index> cells) {
    return SplitCells(lattice, std::span(cells.begin(), cells.size()));
}

}  // namespace SolidSubdiv::Deform
