// SPDX-License-Identifier: Apache-2.0
// A model for tests: a closed surface of triangles.
#pragma once

#include <array>
#include <cmath>
#include <map>
#include <span>
#include <vector>

#include <solidsubdiv/sdc/types.h>

namespace SolidSubdiv::TestShapes {

/// A sphere of triangles, counterclockwise from outside: an octahedron whose faces are cut into n^2.
struct Sphere {
    std::vector<double> points;
    std::vector<Index> triangles;
    std::vector<Offset> offsets;  ///< of triangles as polygons

    Sphere(int n, double radius, const std::array<double, 3>& center = {0, 0, 0}) {
        std::map<std::array<int, 3>, Index> ids;
        const auto id = [&](const std::array<int, 3>& p) {
            const auto [place, is_new] = ids.emplace(p, static_cast<Index>(ids.size()));
            const double length = std::hypot(p[0], p[1], p[2]);
            for (std::size_t axis = 0; is_new && axis < 3; ++axis) {
                points.push_back(center[axis] + radius * p[axis] / length);
            }
            return place->second;
        };
        for (int octant = 0; octant < 8; ++octant) {
            const std::array<int, 3> sign = {octant & 1 ? -1 : 1, octant & 2 ? -1 : 1, octant & 4 ? -1 : 1};
            const auto at = [&](int i, int j) { return id({sign[0] * i, sign[1] * j, sign[2] * (n - i - j)}); };
            const auto add = [&](Index a, Index b, Index c) {
                const bool is_even = sign[0] * sign[1] * sign[2] > 0;
                triangles.insert(triangles.end(), {a, is_even ? b : c, is_even ? c : b});
            };
            for (int i = 0; i < n; ++i) {
                for (int j = 0; i + j < n; ++j) {
                    add(at(i, j), at(i + 1, j), at(i, j + 1));
                    if (i + j + 2 <= n) add(at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
                }
            }
        }
        for (Offset k = 0; k <= static_cast<Offset>(triangles.size()); k += 3) offsets.push_back(k);
    }
    Index n_points() const { return static_cast<Index>(points.size() / 3); }
};

inline std::vector<double> Copy(std::span<const double> values) { return {values.begin(), values.end()}; }

}  // namespace SolidSubdiv::TestShapes
