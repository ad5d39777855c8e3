// SPDX-License-Identifier: Apache-2.0
// What tests of lattices made from models share: models, and what a lattice must be.
#pragma once

#include <solidsubdiv/apps/deform/octree_lattices.h>
#include <solidsubdiv/far/topology_refiner.h>
#include <solidsubdiv/kit/geometry/cell_quality.h>
#include <solidsubdiv/kit/geometry/locator.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "test_shapes.h"

namespace SolidSubdiv::Deform {

struct Model {
    std::string name;
    std::vector<double> points;
    std::vector<Index> triangles;
};

/// A torus, tilted, n by n quads of two triangles each.
inline Model Torus(int n) {
    Model m{"torus", {}, {}};
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
            const double a = 2 * 3.14159265358979323846 * i / n, b = 2 * 3.14159265358979323846 * j / n;
            const double r = 2 + .6 * std::cos(b), x = r * std::cos(a), y = r * std::sin(a), z = .6 * std::sin(b);
            m.points.insert(m.points.end(), {x + .3 * z, .8 * y - .2 * x, z + .4 * y});
            const auto id = [&](int u, int v) { return static_cast<Index>(u % n * n + v % n); };
            m.triangles.insert(m.triangles.end(), {id(i, j), id(i + 1, j), id(i + 1, j + 1)});
            m.triangles.insert(m.triangles.end(), {id(i, j), id(i + 1, j + 1), id(i, j + 1)});
        }
    }
    return m;
}

/// All that a model may be and should not break anything.
inline std::vector<Model> Models() {
    std::vector<Model> models{Torus(24)};
    models.push_back({"point", {3, 4, 5}, {}});
    models.push_back({"far point", {3e7, 4, 5}, {}});
    models.push_back({"point, often", {3, 4, 5, 3, 4, 5, 3, 4, 5}, {0, 1, 2}});
    models.push_back({"segment", {0, 0, 0, 1, 2, 3, .1, .2, .3}, {0, 1, 2}});
    models.push_back({"flat", {0, 0, 1, 4, 0, 1, 4, 3, 1, 0, 3, 1, 2, 1.5, 1}, {0, 1, 4, 1, 2, 4, 2, 3, 4}});
    models.push_back({"tilted flat", {0, 0, 0, 2, 1, 1, 1, 3, 2, 3, 4, 3}, {0, 1, 2, 1, 3, 2}});
    Model corners{"cube, its points on the faces of the box and of cells", {}, {}};
    for (int i = 0; i < 27; ++i)
        corners.points.insert(corners.points.end(), {1. * (i % 3), 1. * (i / 3 % 3), 1. * (i / 9)});
    corners.triangles = {0, 2, 8, 0, 8, 6, 18, 20, 26, 4, 13, 22};
    models.push_back(corners);
    Model parts{"two parts, three triangles on an edge, a loose point",
                {0, 0, 0, 1, 0, 0, 0, 1, 0, .5, .5, 1},
                {0, 1, 2, 0, 1, 3}};
    parts.points.insert(parts.points.end(), {.4, -.5, -1, 9, 9, 9, 9, 8, 9, 8, 9, 9.5, 3, 7, 2});
    parts.triangles.insert(parts.triangles.end(), {0, 1, 4, 5, 6, 7});
    models.push_back(parts);
    return models;
}

inline Far::TopologyRefiner RefinerOf(const ControlLattice& lattice) {
    return Far::TopologyRefiner::Create(lattice.View(), Sdc::Split::Polyhedral);
}

/// How many points no cell holds, up to rounding.
inline std::size_t CountOutside(const ControlLattice& lattice, const std::vector<double>& points) {
    const auto refiner = RefinerOf(lattice);
    const Geometry::Locator locator(refiner, 0, lattice.positions);
    return locator.Locate(points).outside.size();
}

/// How many cells are not proved to be positive.
inline std::size_t CountBadCells(const ControlLattice& lattice) {
    const auto refiner = RefinerOf(lattice);
    const auto quality = Geometry::MeasureQuality(refiner, 0, lattice.positions);
    return static_cast<std::size_t>(std::count_if(
        quality.begin(), quality.end(), [](const auto& q) { return q.sign != Geometry::MinimumSign::Positive; }));
}

inline bool SameRows(const Far::StencilRows<double>& a, const Far::StencilRows<double>& b) {
    return a.n_sources == b.n_sources && a.offsets == b.offsets && a.indices == b.indices && a.weights == b.weights;
}

/// The bits of everything.
inline bool SameHierarchy(const LatticeHierarchy& a, const LatticeHierarchy& b) {
    if (a.levels.size() != b.levels.size() || a.box.corner != b.box.corner || a.box.axes != b.box.axes) return false;
    for (std::size_t i = 0; i < a.levels.size(); ++i) {
        const LatticeLevel &x = a.levels[i], &y = b.levels[i];
        if (x.lattice.positions != y.lattice.positions || x.lattice.hexes != y.lattice.hexes || x.cells != y.cells ||
            x.parents != y.parents || !SameRows(x.octree_rule, y.octree_rule)) {
            return false;
        }
    }
    return true;
}

}  // namespace SolidSubdiv::Deform
