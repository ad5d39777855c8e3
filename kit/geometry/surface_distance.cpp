// SPDX-License-Identifier: Apache-2.0
// Triangles are cut into n^2 equal parts, as many as their area asks for; each part is measured at its middle.
#include <solidsubdiv/kit/geometry/surface_distance.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include <solidsubdiv/kit/geometry/internal/vec3.h>

namespace SolidSubdiv::Geometry {

using namespace Internal;

namespace {

struct Samples {
    std::vector<double> points{};   ///< (n, 3)
    std::vector<double> weights{};  ///< (n)
    std::vector<Index> vertices{};  ///< (n)
    std::vector<Index> elements{};  ///< (n)

    void Add(const Vec3& p, double weight, Index vertex, Index element) {
        points.insert(points.end(), {p.x, p.y, p.z});
        weights.push_back(weight);
        vertices.push_back(vertex);
        elements.push_back(element);
    }
};

/// Middles of the n^2 equal parts of a triangle.
void AddMiddles(const Vec3& a, const Vec3& b, const Vec3& c, int n, double area, Index vertex, Index element,
                Samples& samples) {
    const auto add = [&](double i, double j) {
        samples.Add((1 - (i + j) / n) * a + (i / n) * b + (j / n) * c, area / n / n, vertex, element);
    };
    for (int i = 0; i < n; ++i) {
        for (int j = 0; i + j < n; ++j) {
            add(i + 1.0 / 3, j + 1.0 / 3);
            if (i + j + 1 < n) add(i + 2.0 / 3, j + 2.0 / 3);
        }
    }
}

Samples Sample(std::span<const double> positions, std::span<const Index> triangles, Offset n_points) {
    Samples samples;
    const auto n_vertices = static_cast<Index>(positions.size() / 3);
    if (triangles.empty()) {
        for (Index v = 0; v < n_vertices; ++v) samples.Add(PointAt(positions, v), 1, v, v);
        return samples;
    }
    std::vector<double> areas;
    std::vector<Index> element_of(static_cast<std::size_t>(n_vertices), kNoIndex);
    for (std::size_t t = 0; t < triangles.size(); t += 3) {
        const Vec3 a = PointAt(positions, triangles[t]);
        areas.push_back(
            Length(Cross(PointAt(positions, triangles[t + 1]) - a, PointAt(positions, triangles[t + 2]) - a)) / 2);
        for (std::size_t k = 0; k < 3; ++k) {
            element_of[static_cast<std::size_t>(triangles[t + k])] = static_cast<Index>(t / 3);
        }
    }
    const double whole = std::accumulate(areas.begin(), areas.end(), 0.0);
    for (std::size_t t = 0; t < areas.size(); ++t) {
        const double wanted = whole > 0 ? areas[t] / whole * static_cast<double>(n_points) : 0;
        const int n = std::max(1, static_cast<int>(std::lround(std::sqrt(wanted))));
        const Index* const v = &triangles[3 * t];
        AddMiddles(PointAt(positions, v[0]), PointAt(positions, v[1]), PointAt(positions, v[2]), n, areas[t], v[0],
                   static_cast<Index>(t), samples);
    }
    // Corners stand for no area, but the farthest point is often one.
    for (Index v = 0; v < n_vertices; ++v) {
        const Index element = element_of[static_cast<std::size_t>(v)];
        if (element != kNoIndex) samples.Add(PointAt(positions, v), 0, v, element);
    }
    return samples;
}

}  // namespace

DistanceSummary MeasureDistance(std::span<const double> positions, std::span<const Index> triangles,
                                const ClosestPoints& target, const DistanceOptions& options) {
    const Samples samples = Sample(positions, triangles, options.n_points);
    const std::vector<ClosestPoint> found = target.Find(samples.points);
    DistanceSummary result;
    std::vector<std::size_t> order;  // those that count
    double weight = 0, whole = 0;
    for (std::size_t i = 0; i < found.size(); ++i) {
        const double d = found[i].distance;
        whole += samples.weights[i];
        const double* const p = &samples.points[3 * i];
        if (options.is_left_out && options.is_left_out(found[i], {p[0], p[1], p[2]}, samples.elements[i])) continue;
        order.push_back(i);
        weight += samples.weights[i];
        result.mean += samples.weights[i] * d;
        result.rms += samples.weights[i] * d * d;
        if (d > result.most || result.most_vertex == kNoIndex) {
            result.most = d;
            result.most_vertex = samples.vertices[i];
        }
    }
    result.n_points = static_cast<Offset>(order.size());
    if (whole > 0) result.left_out = 1 - weight / whole;
    if (!(weight > 0)) return result;
    result.mean /= weight;
    result.rms = std::sqrt(result.rms / weight);
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return found[a].distance < found[b].distance || (found[a].distance == found[b].distance && a < b);
    });
    double nearer = 0;
    for (std::size_t i : order) {
        if (nearer < 0.95 * weight) result.p95 = found[i].distance;
        if (nearer < 0.99 * weight) result.p99 = found[i].distance;
        nearer += samples.weights[i];
    }
    return result;
}

}  // namespace SolidSubdiv::Geometry
