// SPDX-License-Identifier: Apache-2.0
// Triangles are split at the middles of their edges, found by the edges' ends.
#include <solidsubdiv/apps/fit/internal/start/ellipsoid.h>

#include <algorithm>
#include <map>
#include <utility>

#include <solidsubdiv/apps/fit/internal/start/vec3.h>
#include <solidsubdiv/kit/geometry/oriented_box.h>

namespace SolidSubdiv::Fit::Starting {

Ellipsoid MakeEllipsoid(std::span<const double> points, Index n_control) {
    Ellipsoid made;
    made.positions = {1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1};
    made.triangles = {0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5};
    while (made.triangles.size() / 3 < std::max<std::size_t>(4096, 10 * static_cast<std::size_t>(n_control))) {
        std::map<std::pair<Index, Index>, Index> middles;
        const auto middle = [&](Index a, Index b) {
            const auto [place, is_new] =
                middles.emplace(std::minmax(a, b), static_cast<Index>(made.positions.size() / 3));
            if (is_new) {
                const Vec3 p = Unit(PointAt(made.positions, a) + PointAt(made.positions, b));
                made.positions.insert(made.positions.end(), {p.x, p.y, p.z});
            }
            return place->second;
        };
        std::vector<Index> split;
        for (std::size_t t = 0; t < made.triangles.size(); t += 3) {
            const Index a = made.triangles[t], b = made.triangles[t + 1], c = made.triangles[t + 2];
            const Index ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
            split.insert(split.end(), {a, ab, ca, ab, b, bc, ca, bc, c, ab, bc, ca});
        }
        made.triangles = std::move(split);
    }
    Geometry::OrientedBox box = Geometry::MakeBox(points, Geometry::BoxKind::Oriented);
    const auto middle = box.At({.5 * box.lengths[0], .5 * box.lengths[1], .5 * box.lengths[2]});
    const double least = .01 * *std::max_element(box.lengths.begin(), box.lengths.end());
    for (Index v = 0; static_cast<std::size_t>(v) < made.positions.size() / 3; ++v) {
        const Vec3 unit = PointAt(made.positions, v);
        Vec3 p{middle[0], middle[1], middle[2]};
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3 axis{box.axes[k][0], box.axes[k][1], box.axes[k][2]};
            p = p + .5 * std::max(box.lengths[k], least) * unit[k] * axis;
        }
        SetPoint(made.positions, v, p);
    }
    return made;
}

}  // namespace SolidSubdiv::Fit::Starting
