// SPDX-License-Identifier: Apache-2.0
// Tiles of 8^3 voxels, what comes near each of them, and what is in it: the part of voxelization that knows no grids.
//
// Coordinates are those of voxels: voxel (i, j, k) has its centre there, and edges of length 1. Within a tile voxel
// (x, y, z) is number 64 x + 8 y + z, as in a leaf of OpenVDB.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <solidsubdiv/apps/voxel/internal/tet_rows.h>
#include <solidsubdiv/sdc/types.h>

namespace SolidSubdiv::Voxel::Internal {

inline constexpr int kTileSide = 8;
inline constexpr int kTileVoxels = kTileSide * kTileSide * kTileSide;

using Place = std::array<int, 3>;  ///< of a voxel; of a tile its first voxel

/// A solid in the coordinates of voxels: its cells cut into tets, and the triangles of its boundary. Pieces are what
/// one map goes for: a hexahedron, which is six tets, or a tet of another cell.
struct VoxelSolid {
    std::vector<double> points;    ///< (n, 3)
    std::vector<Index> tets;       ///< (n, 4)
    std::vector<Index> triangles;  ///< (n, 3)
    Index n_hexes = 0;             ///< their tets come first

    Index n_pieces() const { return static_cast<Index>(tets.size() / 4) - 5 * n_hexes; }
    Index FirstTet(Index piece) const { return piece + 5 * std::min(piece, n_hexes); }
    std::span<const Index> TetsOf(Index piece) const {
        const auto first = static_cast<std::size_t>(FirstTet(piece)),
                   end = static_cast<std::size_t>(FirstTet(piece + 1));
        return {tets.data() + 4 * first, 4 * (end - first)};
    }
};

/// Which voxels of a tile.
using VoxelSet = std::array<std::uint64_t, kTileSide>;

inline bool Holds(const VoxelSet& set, int voxel) {
    return set[static_cast<std::size_t>(voxel) / 64] >> (voxel % 64) & 1;
}

/// Voxels whose centres a piece holds, and none before it.
struct OwnedVoxels {
    Index piece;
    VoxelSet voxels;
};

/// Whether the middle voxel of each side of a tile is inside: bit 2 axis + 1 of the upper side.
std::uint8_t SidesInside(const VoxelSet& inside);

/// Tiles that the solid, or voxels within `reach` of its boundary, lie in; and for each what comes near it.
class Tiles {
  public:
    /// Keeps a view of the solid. Cost: count, scan, fill; some 20 bytes for each tile of the solid's box, 4 for each
    /// tile that a piece or a triangle may touch. @pre counts fit (CountTiles), reach >= 1
    /// @param wants_others whether pieces away from the boundary are asked for too: others(), FindOwners there
    Tiles(const VoxelSolid& solid, double reach, bool wants_others);

    /// Tiles of the box around the solid, widened by reach.
    static double CountTiles(const VoxelSolid& solid, double reach);

    /// With a triangle within reach, perhaps; and where tets of both orientations meet.
    std::span<const Index> near_boundary() const { return near_boundary_; }
    std::span<const Index> others() const { return others_; }  ///< with pieces only, perhaps
    const VoxelSolid& solid() const { return solid_; }
    Place Origin(Index tile) const;

    /// Squares of the distances to the boundary, where they are less than reach^2; others are larger than that.
    void SquaredDistances(Index tile, std::span<float, kTileVoxels> squares) const;
    /// Voxels whose centres some cell holds.
    VoxelSet Inside(Index tile) const;
    /// Each voxel that is inside goes to the lowest piece that holds its centre.
    std::vector<OwnedVoxels> FindOwners(Index tile) const;
    /// The tiles away from the boundary that are inside: what their neighbours say of the voxels beside them goes for
    /// all of them. @param beside SidesInside of near_boundary(), in its order
    std::vector<Index> OthersInside(std::span<const std::uint8_t> beside) const;
    /// How many of the centres of `fineness`^3 parts of each voxel some cell holds. @pre fineness <= 8
    void CountInside(Index tile, int fineness, std::span<std::uint16_t, kTileVoxels> counts) const;

  private:
    struct Near {
        Array<Offset> offsets{0};
        Array<Index> items;
        std::span<const Index> operator[](Index tile) const {
            return {items.data() + offsets[tile], static_cast<std::size_t>(offsets[tile + 1] - offsets[tile])};
        }
    };
    /// Calls use(piece, rows) for the rows of points that each tet near a tile holds, in their order.
    template <class Use>
    void ForRows(Index tile, const PointGrid& grid, Use&& use) const;
    /// @param boxes tiles that elements may touch. Of all tiles, or of those alone that are near the boundary.
    Near FindNear(std::span<const std::array<Place, 2>> boxes, bool wants_all) const;
    Index CountAll() const { return n_[0] * n_[1] * n_[2]; }

    const VoxelSolid& solid_;
    double reach_;
    Place low_{}, n_{};  // in tiles
    Near triangles_, pieces_;
    std::vector<Index> near_boundary_, others_;
};

}  // namespace SolidSubdiv::Voxel::Internal
