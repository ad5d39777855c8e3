// SPDX-License-Identifier: Apache-2.0
// A hierarchy of lattices around a model: its box, and the box split again and again, without the cells that hold
// nothing of the model or are outside of it.
//
//     const auto hierarchy = Deform::MakeOctreeLattices(model.positions, model.triangles, {.levels = 4});
//     const Deform::ControlLattice& lattice = hierarchy.levels[4].lattice;
//
// Level 0 is one hexahedron, the box. Level i + 1 has the cells of level i split in eight, and its control points are
// those of the octree rule: corners stay, the others are the means of the edge, face or cell that they are born in. All
// cells lie in a grid of 2^i cells a side. They are numbered along a Z curve through it (so the children of a cell
// follow each other), control points by z, y, x: the order of the model's points does not matter, nor does the number
// of threads, by a bit.
//
// What is flat, a line or a point gets a box of some thickness: sides shorter than a hundredth of the longest are
// widened to that, around their middle. (The longest counts as at least a millionth of the largest coordinate; a single
// point gets a cube with sides of 1 or that.)
//
// Cells may meet in an edge or a vertex only, and a lattice may fall apart where the model does.
//
// Source: ono2002ffd, sections 2.1 and 2.2.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include <solidsubdiv/apps/deform/control_lattice.h>
#include <solidsubdiv/far/stencil_table.h>
#include <solidsubdiv/kit/geometry/oriented_box.h>
#include <solidsubdiv/sdc/progress.h>

namespace SolidSubdiv::Deform {

/// Which cells stay.
enum class Cut {
    None,       ///< all: 8^i
    Vertices,   ///< those with a vertex of the model. On a face between two cells it is in the upper one, on the box's
                ///< own faces in the last
    Triangles,  ///< those with a vertex or any part of a triangle. Cells that are touched within rounding count
    /// Those of Triangles, and all that cannot be reached from outside the box through faces of other cells. So closed
    /// models are filled; those with a hole that a cell fits through, or cut open by the box of a region, lose their
    /// inside like with Triangles. The finest grid decides: cells of other levels stay where a part of them does
    Outside
};

/// "none", "vertices", "triangles" or "outside". @throws InvalidInput
Cut CutOf(std::string_view name);

struct OctreeOptions {
    Geometry::BoxKind box = Geometry::BoxKind::AxisAligned;
    int levels = 3;  ///< [0, 10]: splits of the box
    Cut cut = Cut::Vertices;
    /// [0, 1e3], a part of the longest side: how far the box goes beyond the model on every side.
    double padding = 0;
    /// Only the points in it are meant. The box is theirs or, axis-aligned, the region itself; of triangles the parts
    /// in the box count where they come near the region.
    std::optional<Geometry::Box> region{};
    /// Move control points where cells end towards the vertices of the model, see below.
    bool shrink = false;
    double offset = 0;  ///< >= 0, in units of the positions: what shrinking leaves before the model
    /// Lattices that take more bytes than this are refused. (Level 8 without cuts takes 2 GB, level 9 16 GB.)
    Offset max_bytes = Offset{8} << 30;
    Progress progress{};

    /// @throws InvalidInput
    void Validate() const;
};

struct LatticeLevel {
    ControlLattice lattice;  ///< hexahedra only, in VTK's order along the box's axes
    /// (cells): the cell of the level before that it is part of; empty in level 0
    std::vector<Index> parents;
    /// Control points over those of the level before, by the octree rule: 1, 2, 4 or 8 equal weights; no rows in level
    /// 0
    Far::StencilRows<double> octree_rule;
    std::vector<std::array<Index, 3>> cells;  ///< places in the grid of 2^i cells a side of the box
};

struct LatticeHierarchy {
    Geometry::OrientedBox box;
    std::vector<LatticeLevel> levels;  ///< options.levels + 1
};

/// Lattices around points (n, 3) and triangles (n, 3: numbers of points; may be none).
///
/// Shrinking moves a control point along each axis of the box on whose one side no cell is there: inwards until
/// `offset` before the vertices of the model in the cells around it, but so that cells keep a tenth of their thickness,
/// and less where a cell would fold. So all cells stay positive, and hold the vertices that they held. Vertices alone
/// count: parts of triangles between them may come to lie outside. Points without vertices in the cells around
/// them stay. Each level is shrunk by itself: its control points are no longer the octree rule of those before.
///
/// Cost: linear in points, cells and, for cuts by triangles, the cells that they touch; and 0.4 bytes of scratch for
/// every cell that the finest grid has without cuts: 0.4 GB at level 10. Cutting what is outside visits all of these.
/// @throws InvalidInput where there is no point (in the region), one is not finite or beyond 1e75, a triangle names a
/// point that is not there, or lattices would not fit; Cancelled
LatticeHierarchy MakeOctreeLattices(std::span<const double> points, std::span<const Index> triangles,
                                    const OctreeOptions& options);

}  // namespace SolidSubdiv::Deform
