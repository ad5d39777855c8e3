// SPDX-License-Identifier: Apache-2.0
// Programs that refine triangle surfaces, behind plain types: each from arrays of positions and triangles in memory to
// refined positions and triangles in memory, on one thread.
#pragma once

#include <array>
#include <cmath>
#include <functional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "perf/machine.h"
#include "perf/race.h"
#include "test_shapes.h"

namespace SolidSubdiv::Perf {

/// Sums that tell whether two programs made the same points, in whatever order.
struct PointSums {
    double n_points = 0, n_faces = 0;
    std::array<double, 3> coordinates{}, squares{};

    void Add(double x, double y, double z) {
        ++n_points;
        const std::array p{x, y, z};
        for (std::size_t c = 0; c < 3; ++c) coordinates[c] += p[c], squares[c] += p[c] * p[c];
    }
    /// @throws std::runtime_error that names the program
    void RequireSame(const PointSums& other, const std::string& name) const {
        bool is_same = n_points == other.n_points && n_faces == other.n_faces;
        for (std::size_t c = 0; c < 3; ++c) {
            // Numbers are floats after three levels of sums: 1e-6 of their size holds them all. A mean size is at most
            // the root of the mean square.
            const double size = std::sqrt(squares[c] * n_points);
            is_same = is_same && std::abs(coordinates[c] - other.coordinates[c]) <= 1e-6 * size &&
                      std::abs(squares[c] - other.squares[c]) <= 2e-6 * squares[c];
        }
        if (!is_same) throw std::runtime_error(name + " has other points or faces than its peers");
    }
};

/// Of packed points.
template <class Real>
PointSums SumsOf(std::span<const Real> points, double n_faces) {
    PointSums sums{.n_faces = n_faces};
    for (std::size_t i = 0; i < points.size(); i += 3) {
        sums.Add(static_cast<double>(points[i]), static_cast<double>(points[i + 1]),
                 static_cast<double>(points[i + 2]));
    }
    return sums;
}

struct SurfacePipeline {
    std::string name{};                  ///< program and number type
    std::function<void()> run{};         ///< or
    std::function<Seconds()> run_apart;  ///< in another process
    std::function<PointSums()> sums{};   ///< of what the last run made
    std::function<void()> clear{};
};

struct SurfacePeers {
    std::vector<SurfacePipeline> loop{}, butterfly{};
    std::string missing{};  ///< says why there are none
};
/// Half-edge meshes of floats, with room for the last level from the start.
SurfacePeers OpenMeshPeers(const TestShapes::Shape& shape, int n_levels);
SurfacePeers CgalPeers(const TestShapes::Shape& shape, int n_levels);
/// A child process. Its points are floats, and its input is made beforehand.
SurfacePeers VtkPeers(const TestShapes::Shape& shape, int n_levels, Freed freed);

}  // namespace SolidSubdiv::Perf
