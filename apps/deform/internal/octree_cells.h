// SPDX-License-Identifier: Apache-2.0
// Which cells of a grid in a box hold parts of a model or are enclosed by it, by their places on a Z curve.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <solidsubdiv/apps/deform/internal/ranked_bits.h>
#include <solidsubdiv/kit/geometry/oriented_box.h>

namespace SolidSubdiv::Deform::Internal {

using GridPlace = std::array<Index, 3>;
using GridPoint = std::array<double, 3>;  ///< in units of the grid's cells

/// Place on the curve of a cell: its coordinates' bits in turn, that of x lowest. The cell of the next coarser
/// grid that it is part of has this place / 8. @pre coordinates are below 1024
std::uint32_t CurvePlace(const GridPlace& cell);
GridPlace CellAt(std::uint32_t place);

/// The grid of 2^level cells a side of a box.
class Grid {
  public:
    Grid(const Geometry::OrientedBox& box, int level) : box_(box), n_(Index{1} << level) {}
    /// @pre the box has sides
    GridPoint At(std::span<const double, 3> point) const;
    /// The cell that has a point; beyond the grid the nearest.
    GridPlace CellOf(const GridPoint& point) const;
    Index n() const { return n_; }  ///< cells a side
    std::uint64_t n_cells() const { return static_cast<std::uint64_t>(n_) * static_cast<std::uint64_t>(n_) * n_; }

  private:
    Geometry::OrientedBox box_;
    Index n_;
};

/// Inserts the cells of all points, given in the grid.
void InsertPoints(const Grid& grid, std::span<const GridPoint> points, RankedBits& cells);

/// Inserts the cells that come within the tolerance (in cells) of a triangle. What lies outside the grid is left out.
/// Triangles (n, 3) name points. Parallel; the same for any number of threads.
void InsertTriangles(const Grid& grid, std::span<const GridPoint> points, std::span<const Index> triangles,
                     const GridPoint& tolerance, RankedBits& cells);

/// Inserts the cells that cannot be reached from outside the grid through faces of cells that are not in yet.
void InsertEnclosed(const Grid& grid, RankedBits& cells);

/// Whether a triangle and the box of a centre and half its sides have a point in common: true unless an axis parts
/// them.
bool TriangleMeetsBox(const std::array<GridPoint, 3>& triangle, const GridPoint& centre, const GridPoint& half);

}  // namespace SolidSubdiv::Deform::Internal
