// SPDX-License-Identifier: Apache-2.0
// A level of a solid in the coordinates of voxels.
#pragma once

#include <span>

#include <solidsubdiv/apps/voxel/internal/tiles.h>
#include <solidsubdiv/far/topology_refiner.h>

namespace SolidSubdiv::Voxel::Internal {

/// Where a point of a cell is, as weights of the level's vertices, and the cell.
struct CellWeights {
    Index cell = 0;  ///< of the level
    int n = 0;       ///< 4 or 8
    std::array<Index, 8> vertices{};
    std::array<double, 8> weights{};
    double jacobian = 0;  ///< of a hexahedron its map's determinant, else six times the volume of the tet, in voxels
};

/// The trilinear map of a hexahedron as a polynomial, and the coordinates that were last found in it: voxels come in
/// rows, so that the next are near.
struct HexMap {
    Index cell = kNoIndex;
    std::array<double, 3> origin{};                ///< corner 0
    std::array<std::array<double, 3>, 7> terms{};  ///< of u, v, w, uv, uw, vw, uvw
    std::array<double, 3> at{};
};

/// Cells that tets were cut from.
class TetCells {
  public:
    TetCells(const Far::TopologyRefiner& refiner, int level, const VoxelSolid& solid);

    /// Weights at a point that a tet holds: in hexahedra trilinear, in others linear in the tet.
    /// @param hex of the call before, one a thread: what it holds changes no result but for rounding
    CellWeights At(Index tet, const std::array<double, 3>& point, HexMap& hex) const;

  private:
    Index CellOf(Index tet) const;
    CellWeights InTet(Index tet, const std::array<double, 3>& point) const;
    void Load(const CellWeights& in_tet, HexMap& hex) const;
    std::span<const Index, 8> HexCorners(Index hex) const;

    const Far::TopologyRefiner& refiner_;
    const int level_;
    const VoxelSolid& solid_;
    Index n_hexes_ = 0, n_tets_ = 0;      // of the level, of cells
    std::vector<Index> polyhedron_tets_;  // of each polyhedron its first tet, and the end
};

/// @throws InvalidInput where there is no such level or no cell, or a position is not finite
VoxelSolid MakeVoxelSolid(const Far::TopologyRefiner& refiner, int level, std::span<const double> positions,
                          double voxel_size);

}  // namespace SolidSubdiv::Voxel::Internal
