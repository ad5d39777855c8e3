// SPDX-License-Identifier: Apache-2.0
// Where voxels are in the pieces that hold them, as coordinates of the piece, and what vertices say there.
#pragma once

#include <array>
#include <span>
#include <vector>

#include <solidsubdiv/apps/voxel/internal/tiles.h>
#include <solidsubdiv/far/topology_refiner.h>

namespace SolidSubdiv::Voxel::Internal {

/// A polynomial in the coordinates (u, v, w) of a piece: factors of 1, u, v, w, uv, uw, vw, uvw. Of a tet the last four
/// are 0.
using Polynomial = std::array<double, 8>;

/// Voxels of a tile in one piece.
struct PlacesInPiece {
    Index cell = 0;  ///< of the level
    std::vector<int> voxels;
    std::vector<double> u, v, w;
    /// Of a hexahedron its map's determinant, else six times the volume of the tet, in voxels.
    std::vector<double> jacobian;
    std::array<Index, 8> vertices{};
    int n_vertices = 0;  ///< 4 or 8

    /// What a number at each vertex of the level is between them: trilinear in hexahedra, linear in tets.
    template <class ValueOf>
    Polynomial Between(ValueOf&& value_of) const {
        std::array<double, 8> x{};
        for (int i = 0; i < n_vertices; ++i) {
            x[static_cast<std::size_t>(i)] = value_of(vertices[static_cast<std::size_t>(i)]);
        }
        if (n_vertices == 4) return {x[0], x[1] - x[0], x[2] - x[0], x[3] - x[0]};
        const double u_in_v = x[2] - x[3], u_in_w = x[5] - x[4], du = x[1] - x[0], dv = x[3] - x[0];
        return {x[0],
                du,
                dv,
                x[4] - x[0],
                u_in_v - du,
                u_in_w - du,
                (x[7] - x[4]) - dv,
                ((x[6] - x[7]) - u_in_w) - (u_in_v - du)};
    }
    /// The values of a polynomial at all voxels.
    void Evaluate(const Polynomial& f, std::span<float> values) const;
};

class PieceMaps {
  public:
    PieceMaps(const Far::TopologyRefiner& refiner, int level, const VoxelSolid& solid);

    /// @param places overwritten
    void Locate(const OwnedVoxels& owned, const Place& origin, PlacesInPiece& places) const;

  private:
    Index CellOf(Index piece) const;
    std::array<double, 3> CoordinatesByTets(const PlacesInPiece& hex, Index piece,
                                            const std::array<double, 3>& point) const;

    const Far::TopologyRefiner& refiner_;
    const int level_;
    const VoxelSolid& solid_;
    Index n_tets_ = 0;                      // of the level, of cells
    std::vector<Index> polyhedron_pieces_;  // of each polyhedron its first piece, and the end
};

}  // namespace SolidSubdiv::Voxel::Internal
