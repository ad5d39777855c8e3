// SPDX-License-Identifier: Apache-2.0
// A regular grid of cubes around points.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <solidsubdiv/apps/fit/fit.h>
#include <solidsubdiv/kit/geometry/box.h>
#include <solidsubdiv/sdc/errors.h>

namespace SolidSubdiv::Fit {

namespace {

/// Cells along the axes for cubes of a size: the box, and a layer on every side.
std::array<Index, 3> CountCells(const Geometry::Box& box, double size) {
    std::array<Index, 3> n{};
    for (std::size_t c = 0; c < 3; ++c) {
        n[c] = 2 + std::max(1, static_cast<Index>(std::ceil(box.Extent(static_cast<int>(c)) / size - 1e-9)));
    }
    return n;
}

}  // namespace

ControlMesh MakeBoxLattice(std::span<const double> points, Index n_control) {
    if (points.size() < 3) throw InvalidInput("fit: there are no points to make a lattice around");
    if (n_control < 64 || n_control > 100'000) {
        throw InvalidInput("fit: n_control is " + std::to_string(n_control) + "; it must be from 64 to 100000");
    }
    const Geometry::Box box = Geometry::BoundingBox(points);
    const double longest = std::max({box.Extent(0), box.Extent(1), box.Extent(2)});
    if (!(longest > 0)) throw InvalidInput("fit: all points are one; there is no lattice around it");
    // The most cells along the longest side that need no more control points.
    std::array<Index, 3> n = CountCells(box, longest);
    double size = longest;
    for (Index along = 2; along < n_control; ++along) {
        const std::array<Index, 3> more = CountCells(box, longest / along);
        if (static_cast<Offset>(more[0] + 1) * (more[1] + 1) * (more[2] + 1) > n_control) break;
        n = more;
        size = longest / along;
    }
    ControlMesh mesh;
    const auto number = [&](Index x, Index y, Index z) { return (z * (n[1] + 1) + y) * (n[0] + 1) + x; };
    for (Index z = 0; z <= n[2]; ++z) {
        for (Index y = 0; y <= n[1]; ++y) {
            for (Index x = 0; x <= n[0]; ++x) {
                const std::array<Index, 3> at = {x, y, z};
                for (std::size_t c = 0; c < 3; ++c) {
                    const double middle = 0.5 * (box.low[c] + box.high[c]);
                    mesh.positions.push_back(middle + size * (at[c] - 0.5 * n[c]));
                }
            }
        }
    }
    for (Index z = 0; z < n[2]; ++z) {
        for (Index y = 0; y < n[1]; ++y) {
            for (Index x = 0; x < n[0]; ++x) {
                for (Index k = z; k <= z + 1; ++k) {
                    for (const auto& [i, j] : {std::array{x, y}, {x + 1, y}, {x + 1, y + 1}, {x, y + 1}}) {
                        mesh.hexes.push_back(number(i, j, k));
                    }
                }
            }
        }
    }
    return mesh;
}

}  // namespace SolidSubdiv::Fit
