// SPDX-License-Identifier: Apache-2.0
// Points on a triangular grid in each triangle.
#include <solidsubdiv/apps/fit/open_surface.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include <solidsubdiv/apps/fit/control_mesh.h>
#include <solidsubdiv/apps/fit/internal/vec3.h>
#include <solidsubdiv/sdc/errors.h>

namespace SolidSubdiv::Fit {

using namespace Internal;

CloudShape CloseSurface(std::span<const double> positions, std::span<const Index> triangles, const Progress& progress) {
    TargetSurface{.positions = positions, .triangles = triangles}.Validate();
    struct Triangle {
        Vec3 a, b, c;
        Vec3 normal() const { return Cross(b - a, c - a); }
    };
    std::vector<Triangle> parts;
    double area = 0;
    for (std::size_t t = 0; t < triangles.size(); t += 3) {
        parts.push_back({PointAt(positions, triangles[t]), PointAt(positions, triangles[t + 1]),
                         PointAt(positions, triangles[t + 2])});
        area += .5 * Length(parts.back().normal());
    }
    if (!(area > 0)) throw InvalidInput("the triangles of the target have no area");
    constexpr double kPoints = 20'000;
    constexpr int kMostParts = 200;  // of the edge of one triangle
    const double spacing = std::sqrt(area / kPoints);
    std::vector<double> points, normals;
    for (const Triangle& t : parts) {
        const Vec3 n = Unit(t.normal());
        if (Length(n) == 0) continue;
        const double longest = std::max({Length(t.b - t.a), Length(t.c - t.b), Length(t.a - t.c)});
        const int rate = std::clamp(static_cast<int>(std::ceil(longest / spacing)), 1, kMostParts);
        // Middles of the cells of a grid: points of neighbouring triangles never coincide.
        for (int i = 0; i < rate; ++i) {
            for (int j = 0; i + j < rate; ++j) {
                const double u = (i + 1. / 3) / rate, v = (j + 1. / 3) / rate;
                const Vec3 p = t.a + u * (t.b - t.a) + v * (t.c - t.a);
                points.insert(points.end(), {p.x, p.y, p.z});
                normals.insert(normals.end(), {n.x, n.y, n.z});
            }
        }
    }
    return ShapeOfCloud(points, normals, progress);
}

}  // namespace SolidSubdiv::Fit
