// SPDX-License-Identifier: Apache-2.0
// Lattices of cells of a grid, and the octree rule between the grids of two levels.
#pragma once

#include <span>

#include <solidsubdiv/apps/deform/internal/ranked_bits.h>
#include <solidsubdiv/apps/deform/octree_lattices.h>

namespace SolidSubdiv::Deform::Internal {

/// Corner j of a hexahedron, one step along each axis whose entry is 1.
inline constexpr Index kHexCorners[8][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                            {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};

/// Corners of the cells of a level, numbered by z, y, x.
class GridCorners {
  public:
    GridCorners(std::span<const std::array<Index, 3>> cells, int level);
    Index size() const { return n_corners_; }
    Index NumberOf(Index x, Index y, Index z) const { return bits_.RankOf(KeyOf(x, y, z)); }
    /// Calls with (x, y, z) of every corner in order.
    template <class Function>
    void ForEach(Function&& function) const {
        bits_.ForEach([&](std::uint64_t key) {
            function(static_cast<Index>(key % side_), static_cast<Index>(key / side_ % side_),
                     static_cast<Index>(key / (side_ * side_)));
        });
    }

  private:
    std::uint64_t KeyOf(Index x, Index y, Index z) const {
        return static_cast<std::uint64_t>(x) +
               side_ * (static_cast<std::uint64_t>(y) + side_ * static_cast<std::uint64_t>(z));
    }
    std::uint64_t side_;
    RankedBits bits_;
    Index n_corners_;
};

/// Cells of the grid of 2^level cells a side of a box.
ControlLattice MakeGridLattice(const Geometry::OrientedBox& box, int level, std::span<const std::array<Index, 3>> cells,
                               const GridCorners& corners);

/// Corners of a level over those of the level before. @pre the cells of `fine` are parts of the cells of `coarse`
Far::StencilRows<double> OctreeRule(const GridCorners& fine, const GridCorners& coarse);

/// Bytes of a level with as many cells and corners.
Offset EstimateBytes(Offset n_cells, Offset n_corners);

}  // namespace SolidSubdiv::Deform::Internal
