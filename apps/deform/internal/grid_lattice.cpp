// SPDX-License-Identifier: Apache-2.0
// Corners are numbered by a set of bits; everything else is arithmetic.
#include <solidsubdiv/apps/deform/internal/grid_lattice.h>

namespace SolidSubdiv::Deform::Internal {

GridCorners::GridCorners(std::span<const std::array<Index, 3>> cells, int level)
    : side_((std::uint64_t{1} << level) + 1), bits_(side_ * side_ * side_) {
    for (const auto& cell : cells) {
        for (const auto& at : kHexCorners) bits_.Insert(KeyOf(cell[0] + at[0], cell[1] + at[1], cell[2] + at[2]));
    }
    n_corners_ = bits_.Number();
}

ControlLattice MakeGridLattice(const Geometry::OrientedBox& box, int level, std::span<const std::array<Index, 3>> cells,
                               const GridCorners& corners) {
    ControlLattice lattice;
    lattice.hexes.reserve(8 * cells.size());
    for (const auto& cell : cells) {
        for (const auto& at : kHexCorners) {
            lattice.hexes.push_back(corners.NumberOf(cell[0] + at[0], cell[1] + at[1], cell[2] + at[2]));
        }
    }
    const double n = static_cast<double>(Index{1} << level);
    lattice.positions.reserve(3 * static_cast<std::size_t>(corners.size()));
    corners.ForEach([&](Index x, Index y, Index z) {
        // The same bits as on the levels before: n is a power of 2.
        const auto p = box.At({box.lengths[0] * x / n, box.lengths[1] * y / n, box.lengths[2] * z / n});
        lattice.positions.insert(lattice.positions.end(), p.begin(), p.end());
    });
    return lattice;
}

Far::StencilRows<double> OctreeRule(const GridCorners& fine, const GridCorners& coarse) {
    Far::StencilRows<double> rows;
    rows.n_sources = coarse.size();
    rows.offsets.reserve(static_cast<std::size_t>(fine.size()) + 1);
    fine.ForEach([&](Index x, Index y, Index z) {
        // Even coordinates are those of coarse corners, odd ones lie between two.
        const double weight = 1. / ((1 + x % 2) * (1 + y % 2) * (1 + z % 2));
        for (Index k = z / 2; k <= (z + 1) / 2; ++k) {
            for (Index j = y / 2; j <= (y + 1) / 2; ++j) {
                for (Index i = x / 2; i <= (x + 1) / 2; ++i) {
                    rows.indices.push_back(coarse.NumberOf(i, j, k));
                    rows.weights.push_back(weight);
                }
            }
        }
        rows.offsets.push_back(static_cast<Offset>(rows.indices.size()));
    });
    return rows;
}

Offset EstimateBytes(Offset n_cells, Offset n_corners) {
    constexpr Offset kCell = 8 * sizeof(Index) + sizeof(Index) + 3 * sizeof(Index);
    // A row has 1, 2, 4 or 8 weights, (3/2)^3 in the mean of a full grid.
    constexpr Offset kCorner = 3 * sizeof(double) + sizeof(Offset) + 27 * (sizeof(double) + sizeof(Index)) / 8;
    return kCell * n_cells + kCorner * n_corners;
}

}  // namespace SolidSubdiv::Deform::Internal
