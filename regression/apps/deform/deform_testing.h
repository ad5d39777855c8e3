// SPDX-License-Identifier: Apache-2.0
// Lattices of every kind with points in and around them, for tests of the room.
#pragma once

#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include <solidsubdiv/apps/deform/control_lattice.h>
#include <solidsubdiv/sdc/schemes.h>

#include "polyhedral_shapes.h"

namespace SolidSubdiv::Deform {

inline ControlLattice LatticeOf(const TestShapes::PolyhedralShape& shape) {
    ControlLattice lattice;
    lattice.positions = shape.positions;
    lattice.hexes = shape.hexes;
    if (shape.cell_offsets.size() > 1) {
        lattice.polyhedron_offsets = shape.cell_offsets;
        lattice.polyhedron_face_offsets = shape.face_offsets;
        lattice.polyhedron_vertices = shape.face_vertices;
    }
    return lattice;
}
inline ControlLattice LatticeOf(const TestShapes::Shape& shape) {
    ControlLattice lattice;
    lattice.positions = shape.positions;
    lattice.tets = shape.tets;
    lattice.octs = shape.octs;
    return lattice;
}

struct LatticeCase {
    std::string name;
    ControlLattice lattice;
    Sdc::Scheme scheme;
};

/// The name of a test of it.
inline void PrintTo(const LatticeCase& c, std::ostream* stream) { *stream << c.name; }

/// Every solid scheme on lattices that it takes.
inline std::vector<LatticeCase> LatticeCases() {
    std::vector<LatticeCase> cases;
    for (const char* scheme : {"catmull-clark-solid", "mlca", "linear-solid"}) {
        cases.push_back({std::string("block by ") + scheme, LatticeOf(TestShapes::HexBlock(3)), Sdc::SchemeOf(scheme)});
        cases.push_back(
            {std::string("mixed by ") + scheme, LatticeOf(TestShapes::MixedCells()), Sdc::SchemeOf(scheme)});
    }
    for (const char* scheme : {"box-spline", "smooth-tet", "interpolatory", "linear-solid"}) {
        auto tets = TestShapes::RandomSubset(TestShapes::KuhnBlock(3), 70, 5);
        TestShapes::Jitter(tets, 0.1, 3);
        cases.push_back({std::string("tets by ") + scheme, LatticeOf(tets), Sdc::SchemeOf(scheme)});
        cases.push_back(
            {std::string("octs by ") + scheme, LatticeOf(TestShapes::OctsAndTets()), Sdc::SchemeOf(scheme)});
    }
    return cases;
}

/// Points in the box of a lattice, made a quarter larger on all sides.
inline std::vector<double> PointsAround(const ControlLattice& lattice, int n, std::uint64_t seed) {
    double low[3] = {1e300, 1e300, 1e300}, high[3] = {-1e300, -1e300, -1e300};
    for (std::size_t i = 0; i < lattice.positions.size(); ++i) {
        low[i % 3] = std::min(low[i % 3], lattice.positions[i]);
        high[i % 3] = std::max(high[i % 3], lattice.positions[i]);
    }
    TestShapes::Random random(seed);
    std::vector<double> points;
    for (int i = 0; i < 3 * n; ++i) {
        const double middle = (low[i % 3] + high[i % 3]) / 2, half = (high[i % 3] - low[i % 3]) / 2;
        points.push_back(middle + 1.25 * half * random.Uniform());
    }
    return points;
}

/// The control points, each coordinate moved by up to `amount`.
inline std::vector<double> Moved(std::vector<double> positions, double amount, std::uint64_t seed) {
    TestShapes::Random random(seed);
    for (double& x : positions) x += amount * random.Uniform();
    return positions;
}

/// An affine map that is no similarity.
inline std::vector<double> Affine(const std::vector<double>& positions) {
    std::vector<double> mapped;
    for (std::size_t i = 0; i < positions.size(); i += 3) {
        const double x = positions[i], y = positions[i + 1], z = positions[i + 2];
        mapped.insert(mapped.end(),
                      {0.9 * x - 0.4 * y + 0.2 * z + 1, 0.5 * x + 1.1 * y - 0.1 * z - 2, 0.3 * y + 0.8 * z});
    }
    return mapped;
}

/// The largest difference of two arrays.
inline double Distance(const std::vector<double>& a, const std::vector<double>& b) {
    double largest = a.size() == b.size() ? 0 : 1e300;
    for (std::size_t i = 0; i < a.size() && i < b.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
    return largest;
}

}  // namespace SolidSubdiv::Deform
