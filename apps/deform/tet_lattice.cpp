// SPDX-License-Identifier: Apache-2.0
// Parity of corners decides everything; what is around a corner is collected once, cell by cell.
#include <solidsubdiv/apps/deform/tet_lattice.h>

#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include <solidsubdiv/apps/deform/internal/grid_lattice.h>

namespace SolidSubdiv::Deform {

namespace {

using Internal::kHexCorners;
using Place = std::array<Index, 3>;

/// Corner j's edge along x, y, z leads to corner j ^ kAcross[axis].
constexpr std::size_t kAcross[3] = {1, 3, 4};

/// A corner of the grid, as the cells that have it say.
struct Corner {
    std::optional<Place> place;
    std::uint8_t cells = 0;             ///< one bit for each of the eight around it
    std::array<Index, 6> neighbours{};  ///< beside it: x - 1, x + 1, y - 1, ..., as far as there are cells

    bool IsOdd() const { return ((*place)[0] + (*place)[1] + (*place)[2]) % 2 != 0; }
    /// The tets at it make an octahedron.
    bool IsCentre() const { return cells == 0xFF && IsOdd(); }
};

std::vector<Corner> CornersOf(const ControlLattice& lattice, std::span<const Place> cells) {
    std::vector<Corner> corners(static_cast<std::size_t>(lattice.n_control_points()));
    for (std::size_t c = 0; c < cells.size(); ++c) {
        for (std::size_t j = 0; j < 8; ++j) {
            const Index v = lattice.hexes[8 * c + j];
            if (v < 0 || v >= lattice.n_control_points()) {
                throw InvalidInput("cell " + std::to_string(c) + " has the corner " + std::to_string(v) + " of " +
                                   std::to_string(lattice.n_control_points()) + " control points");
            }
            Corner& corner = corners[static_cast<std::size_t>(v)];
            Place place = cells[c];
            for (std::size_t k = 0; k < 3; ++k) place[k] += kHexCorners[j][k];
            if (corner.place && *corner.place != place) {
                throw InvalidInput("control point " + std::to_string(v) + " is at two places of the grid; cell " +
                                   std::to_string(c) + " has the second");
            }
            corner.place = place;
            const std::uint8_t bit = static_cast<std::uint8_t>(1u << j);  // it lies opposite, for each cell elsewhere
            if ((corner.cells & bit) != 0) {
                throw InvalidInput("cell " + std::to_string(c) + " is where another cell is");
            }
            corner.cells |= bit;
            for (std::size_t k = 0; k < 3; ++k) {
                const std::size_t side = kHexCorners[j][k] == 0 ? 1 : 0;
                corner.neighbours[2 * k + side] = lattice.hexes[8 * c + (j ^ kAcross[k])];
            }
        }
    }
    return corners;
}

}  // namespace

TetLattice MakeTetLattice(const ControlLattice& hexes, std::span<const Place> cells) {
    if (hexes.hexes.size() != 8 * static_cast<std::size_t>(hexes.n_cells()) ||
        cells.size() != static_cast<std::size_t>(hexes.n_cells())) {
        throw InvalidInput(std::to_string(hexes.n_cells()) + " cells, " + std::to_string(hexes.hexes.size() / 8) +
                           " of them hexahedra, and " + std::to_string(cells.size()) +
                           " places; must be as many, and hexahedra only");
    }
    const std::vector<Corner> corners = CornersOf(hexes, cells);
    TetLattice made;
    std::vector<Index> numbers(corners.size(), kNoIndex);
    for (std::size_t v = 0; v < corners.size(); ++v) {
        if (corners[v].cells == 0 || corners[v].IsCentre()) continue;
        numbers[v] = static_cast<Index>(made.control_points.size());
        made.control_points.push_back(static_cast<Index>(v));
        for (std::size_t k = 0; k < 3; ++k) made.lattice.positions.push_back(hexes.positions[3 * v + k]);
    }
    for (std::size_t c = 0; c < cells.size(); ++c) {
        const auto vertex = [&](std::size_t j) { return static_cast<std::size_t>(hexes.hexes[8 * c + j]); };
        // Corners in the order of their edges: those of an odd one's neighbours along x, y, z.
        const auto add = [&](std::size_t v0, std::size_t v1, std::size_t v2, std::size_t v3) {
            for (std::size_t j : {v0, v1, v2, v3}) made.lattice.tets.push_back(numbers[vertex(j)]);
            made.parents.push_back(static_cast<Index>(c));
        };
        // Its pairs of edges lie in the faces below and above.
        if (corners[vertex(0)].IsOdd()) {
            add(1, 3, 4, 6);
        } else {
            add(0, 2, 7, 5);
        }
        for (std::size_t j = 0; j < 8; ++j) {
            const Corner& corner = corners[vertex(j)];
            if (!corner.IsOdd() || corner.IsCentre()) continue;
            // From a corner at the low end of all axes x, y, z are seen counterclockwise.
            std::size_t x = j ^ kAcross[0], y = j ^ kAcross[1];
            if ((kHexCorners[j][0] + kHexCorners[j][1] + kHexCorners[j][2]) % 2 != 0) std::swap(x, y);
            add(j, j ^ kAcross[2], x, y);
        }
    }
    for (std::size_t v = 0; v < corners.size(); ++v) {
        if (!corners[v].IsCentre()) continue;
        for (std::size_t n : {5, 4, 1, 0, 2, 3}) {  // z + 1, z - 1 | x + 1, x - 1 | y - 1, y + 1
            made.lattice.octs.push_back(numbers[static_cast<std::size_t>(corners[v].neighbours[n])]);
        }
        made.centres.push_back(static_cast<Index>(v));
    }
    return made;
}

}  // namespace SolidSubdiv::Deform
