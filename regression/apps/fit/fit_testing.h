// SPDX-License-Identifier: Apache-2.0
// Control meshes and targets for tests of the room.
#pragma once

#include <solidsubdiv/apps/fit/fit.h>

#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "apps/fit/surface_testing.h"
#include "polyhedral_shapes.h"

namespace SolidSubdiv::Fit {

inline void Map(std::vector<double>& positions, const std::function<std::array<double, 3>(std::array<double, 3>)>& f) {
    for (std::size_t i = 0; i < positions.size(); i += 3) {
        const auto p = f({positions[i], positions[i + 1], positions[i + 2]});
        std::copy(p.begin(), p.end(), positions.begin() + static_cast<std::ptrdiff_t>(i));
    }
}

/// n^3 hexahedra of [0, 1]^3, bulged so that nothing is flat.
inline ControlMesh BulgedHexes(int n) {
    const TestShapes::PolyhedralShape block = TestShapes::HexBlock(n);
    ControlMesh mesh{.positions = block.positions, .hexes = block.hexes};
    Map(mesh.positions, [n](std::array<double, 3> p) {
        for (double& x : p) x /= n;
        const double bulge = 1 + 0.3 * std::sin(3 * p[0] + p[1]) * std::cos(2 * p[2]);
        return std::array<double, 3>{p[0] * bulge, p[1] + 0.2 * p[0] * p[0], p[2] * (1 + 0.1 * p[1])};
    });
    return mesh;
}

/// The same in tets.
inline ControlMesh BulgedTets(int n) {
    const TestShapes::Shape block = TestShapes::KuhnBlock(n);
    ControlMesh mesh{.positions = block.positions, .tets = block.tets};
    Map(mesh.positions, [n](std::array<double, 3> p) {
        for (double& x : p) x /= n;
        return std::array<double, 3>{p[0] * (1 + 0.2 * p[2]), p[1] + 0.2 * p[0] * p[0], p[2] + 0.1 * p[1]};
    });
    return mesh;
}

/// An octahedron's triangles cut in four `times` over, on a sphere of radius 1.
inline ControlMesh SphereCage(int times) {
    const TestShapes::Shape octahedron = TestShapes::OctahedronSurface();
    const auto refiner = [&] {
        auto r = Far::TopologyRefiner::Create({.n_vertices = octahedron.n_vertices, .triangles = octahedron.triangles},
                                              Sdc::Split::TetOct);
        r.RefineUniform({.max_level = times});
        return r;
    }();
    ControlMesh mesh{.positions = octahedron.positions};
    for (int l = 1; l <= times; ++l) {
        const auto table = Far::StencilTable::CreateComposite(refiner, Sdc::LinearSurface{}, {{.level = l}});
        if (l < times) continue;
        mesh.positions = MovingSurface{table.level(1), {}}.Positions(octahedron.positions);
    }
    const auto& level = refiner.level(times);
    for (Index f = 0; f < level.n_boundary_faces; ++f) {
        const auto v = level.BoundaryVertices(f);
        mesh.triangles.insert(mesh.triangles.end(), v.begin(), v.end());
    }
    Map(mesh.positions, [](std::array<double, 3> p) {
        const double length = std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
        return std::array<double, 3>{p[0] / length, p[1] / length, p[2] / length};
    });
    return mesh;
}

inline Surface SurfaceOf(const Problem& problem) {
    return {problem.surface.Positions(problem.control), problem.surface.triangles};
}

/// Control points that the surface depends on.
inline std::vector<bool> IsSeen(const Problem& problem) {
    std::vector<bool> is_seen(problem.control.size() / 3);
    for (std::size_t k = 0; k < problem.surface.rows.indices.size(); ++k) {
        if (problem.surface.rows.weights[k] != 0)
            is_seen[static_cast<std::size_t>(problem.surface.rows.indices[k])] = true;
    }
    return is_seen;
}

inline void Shake(std::vector<double>& positions, double amount, std::uint64_t seed) {
    TestShapes::Random random(seed);
    for (double& x : positions) x += amount * random.Uniform();
}

/// The largest difference at points that the surface depends on.
inline double LargestDifference(const Problem& problem, const std::vector<double>& a, const std::vector<double>& b) {
    const auto is_seen = IsSeen(problem);
    double largest = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (is_seen[i / 3]) largest = std::max(largest, std::abs(a[i] - b[i]));
    }
    return largest;
}

/// The error's text, or "no error".
template <class Run>
std::string ErrorOf(Run&& run) {
    try {
        run();
    } catch (const InvalidInput& error) {
        return error.what();
    }
    return "no error";
}

}  // namespace SolidSubdiv::Fit
