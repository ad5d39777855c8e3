// SPDX-License-Identifier: Apache-2.0
// Validator lattice-counts: how many cells octree lattices have, of one cell and of real models.
#include "lattice_counts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>

#include <solidsubdiv/kit/io/formats.h>

#include "validators.h"

namespace SolidSubdiv::Validation {

namespace {

using Place = std::array<int, 3>;

/// Of coordinates in the points' box, in steps of a cell.
class Grid {
  public:
    Grid(std::span<const double> points, int level) : n_(1 << level) {
        for (std::size_t c = 0; c < 3; ++c) {
            double high = low_[c] = points[c];
            for (std::size_t i = c; i < points.size(); i += 3) {
                low_[c] = std::min(low_[c], points[i]);
                high = std::max(high, points[i]);
            }
            step_[c] = (high - low_[c]) / n_;
        }
    }
    double At(const double* point, std::size_t c) const { return (point[c] - low_[c]) / step_[c]; }

    /// All cells that hold a point; one that is on a side within rounding is in those on both sides of it.
    std::vector<Place> CellsOf(const double* point) const {
        constexpr double kRounding = 1e-9;  // of a cell: much more than that of coordinates, less than any model has
        std::vector<Place> cells{{}};
        for (std::size_t c = 0; c < 3; ++c) {
            const double x = At(point, c);
            std::set<int> along;
            for (double side : {x - kRounding, x + kRounding}) {
                along.insert(std::clamp(static_cast<int>(std::floor(side)), 0, n_ - 1));
            }
            std::vector<Place> longer;
            for (Place cell : cells) {
                for (int k : along) {
                    cell[c] = k;
                    longer.push_back(cell);
                }
            }
            cells = std::move(longer);
        }
        return cells;
    }

  private:
    int n_;
    std::array<double, 3> low_{}, step_{};
};

std::string TextOf(const Place& p) {
    return "(" + std::to_string(p[0]) + " " + std::to_string(p[1]) + " " + std::to_string(p[2]) + ")";
}

void CompareNumbers(std::int64_t found, std::int64_t expected, const std::string& what, Findings& findings) {
    findings.Error(std::abs(static_cast<double>(found - expected)),
                   [&] { return std::to_string(found) + " " + what + ", expected " + std::to_string(expected); });
}

}  // namespace

void CompareWithTable(std::span<const Deform::LatticeLevel> levels, Findings& findings) {
    constexpr std::array<std::int64_t, 6> kCells = {1, 8, 64, 512, 4096, 32768};
    CompareNumbers(static_cast<std::int64_t>(levels.size()), kCells.size(), "levels", findings);
    for (std::size_t i = 0; i < std::min(levels.size(), kCells.size()); ++i) {
        const std::int64_t corners = (std::int64_t{1} << i) + 1;
        const std::string of = " of level " + std::to_string(i);
        CompareNumbers(levels[i].lattice.n_cells(), kCells[i], "cells" + of, findings);
        CompareNumbers(levels[i].lattice.n_control_points(), corners * corners * corners, "control points" + of,
                       findings);
    }
}

void CompareWithPoints(const Deform::ControlLattice& lattice, int level, std::span<const double> points,
                       Findings& findings) {
    const Grid grid(points, level);
    std::set<Place> cells, corners, held;
    for (std::size_t h = 0; h < lattice.hexes.size(); h += 8) {
        Place lowest{1 << level, 1 << level, 1 << level};
        for (std::size_t i = h; i < h + 8; ++i) {
            Place corner;
            for (std::size_t c = 0; c < 3; ++c) {
                const double* const position = &lattice.positions[3 * static_cast<std::size_t>(lattice.hexes[i])];
                corner[c] = static_cast<int>(std::lround(grid.At(position, c)));
                lowest[c] = std::min(lowest[c], corner[c]);
            }
            corners.insert(corner);
        }
        cells.insert(lowest);
    }
    CompareNumbers(lattice.n_cells(), static_cast<std::int64_t>(cells.size()), "cells", findings);
    CompareNumbers(lattice.n_control_points(), static_cast<std::int64_t>(corners.size()), "control points", findings);
    for (std::size_t i = 0; i < points.size(); i += 3) {
        bool is_held = false;
        for (const Place& cell : grid.CellsOf(&points[i])) {
            held.insert(cell);
            is_held |= cells.contains(cell);
        }
        if (!is_held) findings.Fault("point " + std::to_string(i / 3) + " is in no cell");
    }
    for (const Place& cell : cells) {
        if (!held.contains(cell)) findings.Fault("cell " + TextOf(cell) + " holds no point");
    }
}

Findings ValidateLatticeCounts(const Context& context) {
    constexpr int kLevels = 5;
    Findings findings;
    const std::vector<double> cube = {0, 0, 0, 1, 1, 1};
    CompareWithTable(Deform::MakeOctreeLattices(cube, {}, {.levels = kLevels, .cut = Deform::Cut::None}).levels,
                     findings);
    const std::filesystem::path surfaces = context.tets.parent_path() / "surfaces";
    for (const auto& path : {context.shapes / "demo" / "bunny.obj", surfaces / "ode_koala.obj",
                             surfaces / "hoppe_mechpart.recon.obj", surfaces / "ode_human_woman.obj"}) {
        const std::string name = path.filename().string();
        if (!std::filesystem::exists(path)) {
            findings.skipped.push_back(name + ": there is no " + path.string());
            continue;
        }
        const std::vector<double> points = Io::ReadMesh(path).positions;
        const auto hierarchy = Deform::MakeOctreeLattices(points, {}, {.levels = kLevels});
        std::string counts;
        for (int level = 0; level <= kLevels; ++level) {
            const Deform::ControlLattice& lattice = hierarchy.levels[static_cast<std::size_t>(level)].lattice;
            Findings found;
            CompareWithPoints(lattice, level, points, found);
            findings.Merge(found, name + ", level " + std::to_string(level));
            counts += (level > 0 ? ", " : "") + std::to_string(lattice.n_cells());
        }
        findings.notes.push_back(name + ": " + counts + " cells");
    }
    return findings;
}

}  // namespace SolidSubdiv::Validation
