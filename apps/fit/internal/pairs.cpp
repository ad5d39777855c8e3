// SPDX-License-Identifier: Apache-2.0
// Nearest points both ways, and how much each counts.
#include <solidsubdiv/apps/fit/internal/pairs.h>

#include <algorithm>
#include <cmath>

namespace SolidSubdiv::Fit::Internal {

namespace {

Vec3 AsVec3(const std::array<double, 3>& p) { return {p[0], p[1], p[2]}; }

/// Twice the area, along the normal.
Vec3 AreaNormal(std::span<const double> positions, const Index* t) {
    const Vec3 a = PointAt(positions, t[0]);
    return Cross(PointAt(positions, t[1]) - a, PointAt(positions, t[2]) - a);
}

/// Normals of the vertices by area; not of length 1.
std::vector<Vec3> VertexNormals(std::span<const double> positions, std::span<const Index> triangles) {
    std::vector<Vec3> normals(positions.size() / 3);
    for (std::size_t t = 0; t < triangles.size(); t += 3) {
        const Vec3 n = AreaNormal(positions, &triangles[t]);
        for (std::size_t k = 0; k < 3; ++k) {
            Vec3& sum = normals[static_cast<std::size_t>(triangles[t + k])];
            sum = sum + n;
        }
    }
    return normals;
}

/// Areas that vertices stand for, summing to 1; equal ones where there are no triangles.
std::vector<double> VertexAreas(std::span<const double> positions, std::span<const Index> triangles) {
    const std::size_t n = positions.size() / 3;
    std::vector<double> areas(n, triangles.empty() ? 1.0 : 0.0);
    double whole = triangles.empty() ? static_cast<double>(n) : 0;
    for (std::size_t t = 0; t < triangles.size(); t += 3) {
        const double area = Length(AreaNormal(positions, &triangles[t]));
        for (std::size_t k = 0; k < 3; ++k) areas[static_cast<std::size_t>(triangles[t + k])] += area;
        whole += 3 * area;
    }
    for (double& a : areas) a /= whole > 0 ? whole : 1;
    return areas;
}

/// Geman and McClure's weights, which fall to 0 for far pairs: 1 / (1 + (d / c)^2)^2, with c = robust times the median
/// distance. Source: zhou2016fast, equation (6).
void CountFarLess(std::span<Pair> pairs, double robust) {
    if (pairs.empty() || !(robust > 0)) return;
    std::vector<double> distances;
    for (const Pair& p : pairs) distances.push_back(p.distance);
    const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
    std::nth_element(distances.begin(), middle, distances.end());
    const double scale = robust * *middle;
    if (!(scale > 0)) return;
    for (Pair& p : pairs) {
        const double x = 1 + p.distance * p.distance / (scale * scale);
        p.weight /= x * x;
    }
}

}  // namespace

double NormalRms(std::span<const double> vertices, std::span<const Index> triangles, const TargetSurface& target,
                 std::span<const Geometry::ClosestPoint> nearest) {
    const std::vector<Vec3> normals = VertexNormals(vertices, triangles);
    const std::vector<double> areas = VertexAreas(vertices, triangles);
    double sum = 0, whole = 0;
    for (std::size_t v = 0; v < areas.size(); ++v) {
        const Vec3 n = NormalOf(target, nearest[v].element), own = Unit(normals[v]);
        if (Length(n) == 0 || Length(own) == 0) continue;
        const double angle = std::atan2(Length(Cross(own, n)), Dot(own, n));
        sum += areas[v] * angle * angle;
        whole += areas[v];
    }
    return whole > 0 ? std::sqrt(sum / whole) : 0;
}

PairFinder::PairFinder(const Problem& problem, Offset most_points) : problem_(problem) {
    if (!problem.partners.empty()) return;
    target_.emplace(problem.target.positions, problem.target.triangles);
    FindPoints(most_points);
    coverage_.emplace(problem.target);
}

void PairFinder::FindPoints(Offset most_points) {
    const TargetSurface& target = problem_.target;
    const std::vector<double> areas = VertexAreas(target.positions, target.triangles);
    const std::vector<Vec3> normals = VertexNormals(target.positions, target.triangles);
    const Offset n = static_cast<Offset>(areas.size()), n_points = std::min(n, most_points);
    double whole = 0;
    for (Offset i = 0; i < n_points; ++i) {
        const Index v = static_cast<Index>(i * n / n_points);
        const double area = areas[static_cast<std::size_t>(v)];
        if (!(area > 0)) continue;
        const Vec3 p = PointAt(target.positions, v);
        points_.positions.insert(points_.positions.end(), {p.x, p.y, p.z});
        points_.normals.push_back(
            Unit(target.normals.empty() ? normals[static_cast<std::size_t>(v)] : PointAt(target.normals, v)));
        points_.areas.push_back(area);
        whole += area;
    }
    for (double& area : points_.areas) area /= whole;
}

std::vector<Pair> PairFinder::Find(std::span<const double> vertices, double robust, Index& n_of_surface) const {
    const MovingSurface& surface = problem_.surface;
    const std::vector<Vec3> normals = VertexNormals(vertices, surface.triangles);
    const std::vector<double> areas = VertexAreas(vertices, surface.triangles);
    const auto look_away = [](const Vec3& a, const Vec3& b) { return Dot(a, b) < 0; };
    std::vector<Pair> pairs;
    if (!problem_.partners.empty()) {
        for (Index v = 0; v < surface.rows.n_rows(); ++v) {
            const auto i = static_cast<std::size_t>(v);
            const Vec3 partner = PointAt(problem_.partners, v);
            pairs.push_back({{v, v, v}, {1, 0, 0}, partner, {}, Length(partner - PointAt(vertices, v)), areas[i]});
        }
        n_of_surface = static_cast<Index>(pairs.size());
        return pairs;
    }
    const auto on_target = target_->Find(vertices);
    for (Index v = 0; v < surface.rows.n_rows(); ++v) {
        const auto i = static_cast<std::size_t>(v);
        const Geometry::ClosestPoint& at = on_target[i];
        const Vec3 n = NormalOf(problem_.target, at.element);
        if (!(areas[i] > 0) || look_away(n, normals[i]) || !coverage_->Covers(at, PointAt(vertices, v), normals[i]))
            continue;
        pairs.push_back({{v, v, v}, {1, 0, 0}, AsVec3(at.position), n, at.distance, areas[i]});
    }
    n_of_surface = static_cast<Index>(pairs.size());
    CountFarLess(pairs, robust);

    const Geometry::ClosestPoints moving(vertices, surface.triangles);
    const auto on_surface = moving.Find(points_.positions);
    for (std::size_t i = 0; i < on_surface.size(); ++i) {
        const Geometry::ClosestPoint& at = on_surface[i];
        const Vec3& n = points_.normals[i];
        const Index* const t = &surface.triangles[3 * static_cast<std::size_t>(at.element)];
        if (look_away(n, AreaNormal(vertices, t))) continue;
        const Vec3 point = PointAt(points_.positions, static_cast<Index>(i)), way = AsVec3(at.position) - point;
        // The side of what the surface lacks, an ear or a neck: it is met across its normal, and must draw there.
        constexpr double kLeastCosine = 0.25;
        const bool is_side = std::abs(Dot(way, n)) < kLeastCosine * Length(way);
        pairs.push_back({{t[0], t[1], t[2]}, at.weights, point, is_side ? Vec3{} : n, at.distance, points_.areas[i]});
    }
    CountFarLess(std::span(pairs).subspan(static_cast<std::size_t>(n_of_surface)), robust);
    return pairs;
}

}  // namespace SolidSubdiv::Fit::Internal
