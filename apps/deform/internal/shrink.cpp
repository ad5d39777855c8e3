// SPDX-License-Identifier: Apache-2.0
// Every control point moves as far as its cells allow; where a cell would fold its points go half the way, or less.
#include <solidsubdiv/apps/deform/internal/shrink.h>

#include <algorithm>
#include <cmath>

#include <solidsubdiv/apps/deform/internal/grid_lattice.h>
#include <solidsubdiv/far/topology_refiner.h>
#include <solidsubdiv/kit/geometry/cell_quality.h>

namespace SolidSubdiv::Deform::Internal {

namespace {

constexpr double kThinnest = .1;  // of a cell's thickness
constexpr int kMostHalvings = 6;  // then a point stays

using Move = std::array<double, 3>;  // in cells

/// What is around a control point.
struct Around {
    Index low_cells[3]{}, high_cells[3]{};  ///< how many on either side along each axis
    Reach reach;
};

std::vector<Around> SurroundingsOf(const LatticeLevel& level, std::span<const Reach> reaches) {
    std::vector<Around> all(static_cast<std::size_t>(level.lattice.n_control_points()));
    for (std::size_t c = 0; c < level.cells.size(); ++c) {
        for (std::size_t j = 0; j < 8; ++j) {
            Around& its = all[static_cast<std::size_t>(level.lattice.hexes[8 * c + j])];
            // The cell lies on the higher side of its lower corners.
            for (std::size_t k = 0; k < 3; ++k) ++(kHexCorners[j][k] == 0 ? its.high_cells : its.low_cells)[k];
            its.reach.Include(reaches[c]);
        }
    }
    return all;
}

/// How far each point moves, by what is around it alone.
std::vector<Move> MovesOf(const LatticeLevel& level, std::span<const Reach> reaches, const Move& offset) {
    const std::vector<Around> all = SurroundingsOf(level, reaches);
    std::vector<Move> moves(all.size());
    const auto number = [&](std::size_t c, std::size_t j) {
        return static_cast<std::size_t>(level.lattice.hexes[8 * c + j]);
    };
    for (std::size_t c = 0; c < level.cells.size(); ++c) {
        for (std::size_t j = 0; j < 8; ++j) {  // points of several cells: again, with the same result
            const Around& its = all[number(c, j)];
            if (its.reach.IsEmpty()) continue;
            for (std::size_t k = 0; k < 3; ++k) {
                const double at = level.cells[c][k] + kHexCorners[j][k];
                double& move = moves[number(c, j)][k];
                if (its.high_cells[k] == 0) {
                    move = std::clamp(its.reach.high[k] + offset[k] - at, -(1 - kThinnest), 0.);
                } else if (its.low_cells[k] == 0) {
                    move = std::clamp(its.reach.low[k] - offset[k] - at, 0., 1 - kThinnest);
                }
            }
        }
    }
    return moves;
}

/// Corner j's edge along axis k leads to corner j ^ kAcross[k].
constexpr std::size_t kAcross[3] = {1, 3, 4};

/// Where cells end on both sides, points may have come too near to each other: apart again, around their middle.
void KeepApart(const LatticeLevel& level, std::vector<Move>& moves) {
    for (std::size_t c = 0; c < level.cells.size(); ++c) {
        for (std::size_t j = 0; j < 8; ++j) {
            for (std::size_t k = 0; k < 3; ++k) {
                if (kHexCorners[j][k] != 0) continue;
                const std::size_t across = j ^ kAcross[k];
                double& low = moves[static_cast<std::size_t>(level.lattice.hexes[8 * c + j])][k];
                double& high = moves[static_cast<std::size_t>(level.lattice.hexes[8 * c + across])][k];
                if (1 + high - low >= kThinnest) continue;
                const double middle = std::clamp(.5 * (low + 1 + high), .5 * kThinnest, 1 - .5 * kThinnest);
                low = middle - .5 * kThinnest;
                high = middle + .5 * kThinnest - 1;
            }
        }
    }
}

double PartAfter(int halvings) { return halvings > kMostHalvings ? 0 : std::ldexp(1., -halvings); }

/// Of what is left of a move, in cells.
double LengthOf(const Move& move, int halvings) { return PartAfter(halvings) * std::hypot(move[0], move[1], move[2]); }

}  // namespace

void Shrink(const Geometry::OrientedBox& box, int level_number, std::span<const Reach> reaches, double offset,
            LatticeLevel& level) {
    const double n = static_cast<double>(Index{1} << level_number);
    Move offset_in_cells;
    for (std::size_t k = 0; k < 3; ++k) offset_in_cells[k] = offset / box.lengths[k] * n;
    std::vector<Move> moves = MovesOf(level, reaches, offset_in_cells);
    KeepApart(level, moves);

    const std::vector<double> whole = level.lattice.positions;
    std::vector<int> halvings(moves.size(), 0);
    const auto refiner = Far::TopologyRefiner::Create(level.lattice.View(), Sdc::Split::Polyhedral);
    for (;;) {
        for (std::size_t v = 0; v < moves.size(); ++v) {
            const double part = PartAfter(halvings[v]);
            for (std::size_t c = 0; c < 3; ++c) {
                double by = 0;
                for (std::size_t k = 0; k < 3; ++k) by += part * moves[v][k] * (box.lengths[k] / n) * box.axes[k][c];
                level.lattice.positions[3 * v + c] = whole[3 * v + c] + by;
            }
        }
        // In a cell that folds the points that have moved most go back half the way. That never uncovers a vertex, and
        // with all of its points back a cell is a brick.
        const auto quality = Geometry::MeasureQuality(refiner, 0, level.lattice.positions);
        std::vector<bool> goes_back(moves.size(), false);
        bool any = false;
        for (std::size_t c = 0; c < quality.size(); ++c) {
            if (quality[c].sign == Geometry::MinimumSign::Positive) continue;
            const auto corner = [&](std::size_t j) { return static_cast<std::size_t>(level.lattice.hexes[8 * c + j]); };
            double most = 0;
            for (std::size_t j = 0; j < 8; ++j) most = std::max(most, LengthOf(moves[corner(j)], halvings[corner(j)]));
            if (most == 0) continue;
            any = true;
            for (std::size_t j = 0; j < 8; ++j) {
                if (LengthOf(moves[corner(j)], halvings[corner(j)]) >= .99 * most) goes_back[corner(j)] = true;
            }
        }
        if (!any) return;
        for (std::size_t v = 0; v < moves.size(); ++v) halvings[v] += goes_back[v];
    }
}

}  // namespace SolidSubdiv::Deform::Internal
