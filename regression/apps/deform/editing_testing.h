// SPDX-License-Identifier: Apache-2.0
// Small octree hierarchies, for tests of editing: not what makes lattices, so that tests of one do not hang on the
// other.
#pragma once

#include <array>
#include <cmath>
#include <map>
#include <span>
#include <vector>

#include <solidsubdiv/apps/deform/editing_session.h>

#include "apps/deform/sphere_testing.h"

namespace SolidSubdiv::TestShapes {

using GridPoint = std::array<int, 3>;

/// The eight corners of a cell of a grid, in VTK's order.
inline std::array<GridPoint, 8> CornersOf(const GridPoint& cell) {
    std::array<GridPoint, 8> corners;
    for (int k = 0; k < 8; ++k) {
        const int x = k % 4 == 1 || k % 4 == 2 ? 1 : 0, y = k % 4 >= 2 ? 1 : 0, z = k / 4;
        corners[static_cast<std::size_t>(k)] = {cell[0] + x, cell[1] + y, cell[2] + z};
    }
    return corners;
}

/// Lattices on [-1, 1]^3: n^3 hexes, and from level to level 8 in each, of which keep(level, cell) are there.
struct Hierarchy {
    std::vector<Deform::ControlLattice> lattices;
    std::vector<Far::StencilRows<double>> rules;  ///< of level 0: empty

    template <class Keep>
    Hierarchy(int n, int n_levels, Keep&& keep) {
        std::vector<GridPoint> cells;
        for (int i = 0; i < n * n * n; ++i) cells.push_back({i % n, i / n % n, i / (n * n)});
        std::map<GridPoint, Index> before;
        for (int level = 0; level < n_levels; ++level) {
            if (level > 0) {
                std::vector<GridPoint> finer;
                for (const GridPoint& cell : cells) {
                    for (const GridPoint& child : CornersOf({2 * cell[0], 2 * cell[1], 2 * cell[2]})) {
                        if (keep(level, child)) finer.push_back(child);
                    }
                }
                cells = finer;
            }
            std::map<GridPoint, Index> ids;
            Deform::ControlLattice& lattice = lattices.emplace_back();
            Far::StencilRows<double>& rule = rules.emplace_back();
            rule.n_sources = static_cast<Index>(before.size());
            for (const GridPoint& cell : cells) {
                for (const GridPoint& p : CornersOf(cell)) {
                    const auto [place, is_new] = ids.emplace(p, static_cast<Index>(ids.size()));
                    lattice.hexes.push_back(place->second);
                    if (!is_new) continue;
                    for (int x : p) lattice.positions.push_back(2.0 * x / (n << level) - 1);
                    if (level > 0) AddRow(p, before, rule);
                }
            }
            before = ids;
        }
    }
    Hierarchy(int n, int n_levels) : Hierarchy(n, n_levels, [](int, const GridPoint&) { return true; }) {}

    std::vector<Deform::SessionLevel> Levels() const {
        std::vector<Deform::SessionLevel> levels;
        for (std::size_t i = 0; i < lattices.size(); ++i) {
            levels.push_back({.lattice = &lattices[i], .octree_rule = rules[i]});
        }
        return levels;
    }

  private:
    /// The mean of the coarser points around: one, an edge's two, a face's four, a cell's eight.
    static void AddRow(const GridPoint& p, const std::map<GridPoint, Index>& coarser, Far::StencilRows<double>& rule) {
        std::vector<Index> around;
        for (int k = 0; k < 8; ++k) {
            GridPoint q;
            bool is_there = true;
            for (int axis = 0; axis < 3; ++axis) {
                const int x = p[static_cast<std::size_t>(axis)], up = k >> axis & 1;
                is_there = is_there && (up == 0 || x % 2 == 1);
                q[static_cast<std::size_t>(axis)] = x / 2 + up;
            }
            if (is_there) around.push_back(coarser.at(q));
        }
        for (Index i : around) {
            rule.indices.push_back(i);
            rule.weights.push_back(1.0 / static_cast<double>(around.size()));
        }
        rule.offsets.push_back(static_cast<Offset>(rule.indices.size()));
    }
};

inline Deform::ModelFaces FacesOf(const Sphere& sphere) {
    return {.offsets = sphere.offsets, .corners = sphere.triangles};
}

/// Keeps the cells that the sphere of this radius may pass through.
struct NearSphere {
    int n;
    double radius;
    bool operator()(int level, const GridPoint& cell) const {
        const double side = 2.0 / (n << level);
        const auto middle = [&](int x) { return (x + .5) * side - 1; };
        return std::abs(std::hypot(middle(cell[0]), middle(cell[1]), middle(cell[2])) - radius) < .9 * side;
    }
};

}  // namespace SolidSubdiv::TestShapes
