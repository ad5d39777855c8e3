// SPDX-License-Identifier: Apache-2.0
// Angle-weighted normals with a crease angle; see internal/corner_normals.h.
#include <solidsubdiv/kit/picture/internal/corner_normals.h>
#include <solidsubdiv/sdc/parallel.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace SolidSubdiv::Picture::Internal {

std::vector<Vec3f> CornerNormals(std::span<const Vec3d> positions, std::span<const Index> triangles,
                                 double crease_angle) {
    const auto n_corners = static_cast<Offset>(triangles.size());
    const auto point = [&](Offset corner) {
        return positions[static_cast<std::size_t>(triangles[static_cast<std::size_t>(corner)])];
    };

    // Of every corner: its triangle's unit normal times its angle, and which corners share its vertex.
    std::vector<Vec3d> weighted(triangles.size());
    Sdc::ParallelFor(n_corners / 3, 1024, [&](Offset begin, Offset end) {
        for (Offset t = begin; t < end; ++t) {
            const Vec3d p[3] = {point(3 * t), point(3 * t + 1), point(3 * t + 2)};
            const Vec3d normal = Unit(Cross(p[1] - p[0], p[2] - p[0]));
            for (int i = 0; i < 3; ++i) {
                const Vec3d a = Unit(p[(i + 1) % 3] - p[i]), b = Unit(p[(i + 2) % 3] - p[i]);
                weighted[static_cast<std::size_t>(3 * t + i)] = std::acos(std::clamp(Dot(a, b), -1.0, 1.0)) * normal;
            }
        }
    });
    std::vector<Offset> start(positions.size() + 1, 0);
    for (Index v : triangles) ++start[static_cast<std::size_t>(v)];
    Sdc::ScanLengths(start);
    std::vector<Offset> corners(triangles.size()), next(start.begin(), start.end() - 1);
    for (Offset c = 0; c < n_corners; ++c) {
        corners[static_cast<std::size_t>(next[static_cast<std::size_t>(triangles[static_cast<std::size_t>(c)])]++)] = c;
    }

    std::vector<Vec3f> normals(triangles.size());
    const double least_cosine =
        std::cos(crease_angle * std::numbers::pi / 180) - 1e-9;  // 0 degrees: coplanar ones still meet
    Sdc::ParallelFor(n_corners, 1024, [&](Offset begin, Offset end) {
        for (Offset c = begin; c < end; ++c) {
            const auto vertex = static_cast<std::size_t>(triangles[static_cast<std::size_t>(c)]);
            const Vec3d own = Unit(weighted[static_cast<std::size_t>(c)]);
            Vec3d sum{};
            for (Offset k = start[vertex]; k < start[vertex + 1]; ++k) {
                const Vec3d other = weighted[static_cast<std::size_t>(corners[static_cast<std::size_t>(k)])];
                if (Dot(own, other) >= least_cosine * Length(other)) sum += other;
            }
            const Vec3d normal = Unit(sum);
            normals[static_cast<std::size_t>(c)] = static_cast<Vec3f>(Length(normal) > 0 ? normal : own);
        }
    });
    return normals;
}

}  // namespace SolidSubdiv::Picture::Internal
