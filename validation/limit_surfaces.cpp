// SPDX-License-Identifier: Apache-2.0
// Comparing limits of surfaces with OpenSubdiv's.
#include "limit_surfaces.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "points.h"

namespace SolidSubdiv::Validation {

namespace {

double Length(const Vector3& a) { return std::hypot(a[0], a[1], a[2]); }

Vector3 At(const std::vector<double>& points, std::size_t i) {
    return {points[3 * i], points[3 * i + 1], points[3 * i + 2]};
}

Vector3 Minus(const Vector3& a, const Vector3& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

double Dot(const Vector3& a, const Vector3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Vector3 Cross(const Vector3& a, const Vector3& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Vector3 Unit(const Vector3& a) {
    const double length = Length(a);
    return {a[0] / length, a[1] / length, a[2] / length};
}

}  // namespace

BoundarySurface::BoundarySurface(const Far::TopologyRefiner& refiner, const std::vector<double>& positions,
                                 const SurfaceTags& tags)
    : is_triangular(!refiner.is_polyhedral()) {
    const Index n_faces =
        is_triangular ? refiner.level(0).n_boundary_faces : refiner.polyhedral_level(0).n_boundary_faces;
    std::map<Index, int> number;
    std::vector<double> used;
    for (Index b = 0; b < n_faces; ++b) {
        const std::span<const Index> vertices =
            is_triangular ? refiner.level(0).BoundaryVertices(b) : refiner.polyhedral_level(0).BoundaryVertices(b);
        Polygon& face = faces_.emplace_back();
        for (Index v : vertices) {
            const auto [found, is_new] = number.emplace(v, static_cast<int>(mesh_vertices.size()));
            face.push_back(found->second);
            if (!is_new) continue;
            mesh_vertices.push_back(v);
            for (std::size_t i = 0; i < 3; ++i) used.push_back(positions[3 * static_cast<std::size_t>(v) + i]);
        }
    }
    SurfaceTags own = tags;
    for (auto& ends : own.creases) ends = {number.at(ends[0]), number.at(ends[1])};
    for (int& v : own.corners) v = number.at(v);
    const int n = static_cast<int>(mesh_vertices.size());
    if (is_triangular) {
        triangles = {n, {}, used, own};
        for (const Polygon& f : faces_) triangles.triangles.push_back({f[0], f[1], f[2]});
    } else {
        polygons = {.n_vertices = n, .faces = faces_, .positions = used, .tags = own};
    }
}

Far::Place BoundarySurface::OurPlace(const SurfacePlace& place) const {
    const auto [face, corner, s, t] = place;
    if (!HasParts(face)) return {face, 0, {s, t, 0}};
    // A quad's halves are in the parts at the edges after its corner and before.
    const int n = static_cast<int>(faces_[static_cast<std::size_t>(face)].size());
    if (s >= t) return {face, corner, {1 - s + (s - t) / 2, (s - t) / 2, 0}};
    return {face, (corner + n - 1) % n, {(t - s) / 2, 1 - t + (t - s) / 2, 0}};
}

std::vector<Far::Place> BoundarySurface::OurPlaces(std::span<const SurfacePlace> places) const {
    std::vector<Far::Place> ours;
    for (const SurfacePlace& place : places) ours.push_back(OurPlace(place));
    return ours;
}

std::vector<Far::Place> BoundarySurface::CornerPlaces() const {
    std::vector<Far::Place> places(mesh_vertices.size());
    for (std::size_t f = 0; f < faces_.size(); ++f) {
        for (std::size_t k = 0; k < faces_[f].size(); ++k) {
            Far::Place& place = places[static_cast<std::size_t>(faces_[f][k])];
            place = {.element = static_cast<Index>(f)};
            if (HasParts(static_cast<int>(f))) {
                place.part = static_cast<Index>(k);
                place.at = {1, 0, 0};
            } else {
                const std::size_t last = faces_[f].size() - 1;
                place.at = {k == 1 || (k == 2 && last == 3) ? 1.0 : 0.0, k >= 2 ? 1.0 : 0.0, 0};
            }
        }
    }
    return places;
}

void CompareAtPlaces(const LimitRows& rows, const BoundarySurface& surface, std::span<const SurfacePlace> places,
                     const std::vector<double>& positions, Findings& findings) {
    const SurfaceLimits theirs = surface.LimitsAt(places);
    const double size = SizeOf(positions);
    const std::vector<double> points = Apply(rows.rows, positions);
    std::vector<std::vector<double>> derivatives;
    for (const auto& derivative : rows.derivatives) derivatives.push_back(Apply(derivative, positions));
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (!theirs.is_exact[i]) continue;
        const auto where = [&](const std::string& what) {
            return what + " at place " + std::to_string(i) + " of face " + std::to_string(places[i].face);
        };
        if (rows.orders[i] < 0) {
            findings.Fault(where("no limit"));
            continue;
        }
        findings.Error(Length(Minus(At(points, i), At(theirs.points, i))) / size, [&] { return where("point"); });
        if (surface.HasParts(places[i].face)) continue;  // their coordinates are others
        for (std::size_t k = 0; k < derivatives.size(); ++k) {
            const int order = k < 2 ? 1 : 2;
            if (rows.orders[i] < order) continue;
            // Each level doubles differences.
            const double scale = std::ldexp(size, order * theirs.depths[i]);
            const double error = Length(Minus(At(derivatives[k], i), At(theirs.derivatives[k], i))) / scale;
            findings.Error(order == 1 ? std::max(0.0, error - kSlopeRoundOff) : error,
                           [&] { return where("derivative " + std::to_string(k)); });
        }
    }
}

void CompareAtVertices(const LimitRows& corners, const BoundarySurface& surface, const std::vector<double>& positions,
                       Findings& findings) {
    const VertexLimits theirs = surface.LimitsOfVertices();
    if (theirs.points.empty()) {
        findings.skipped.push_back("vertices, as surfaces meet in some, where OpenSubdiv's limit masks are not safe");
        return;
    }
    const double size = SizeOf(positions);
    const std::vector<double> points = Apply(corners.rows, positions), u = Apply(corners.derivatives[0], positions),
                              v = Apply(corners.derivatives[1], positions);
    for (std::size_t i = 0; i < surface.mesh_vertices.size(); ++i) {
        if (theirs.is_dart[i]) continue;  // their masks are those of smooth vertices
        const auto where = [&](const std::string& what) {
            return what + " of vertex " + std::to_string(surface.mesh_vertices[i]);
        };
        if (corners.orders[i] < 0) {
            findings.Fault(where("no limit"));
            continue;
        }
        findings.Error(Length(Minus(At(points, i), At(theirs.points, i))) / size, [&] { return where("point"); });
        if (!(theirs.is_smooth[i] || theirs.is_smooth_border[i]) || corners.orders[i] < 1) continue;
        const Vector3 normal = Unit(Cross(At(u, i), At(v, i)));
        Vector3 their_normal = Unit(At(theirs.normals, i));
        if (theirs.is_smooth_border[i] && Dot(normal, their_normal) < 0) their_normal = Minus({}, their_normal);
        findings.Error(Length(Minus(normal, their_normal)), [&] { return where("normal"); });
    }
}

}  // namespace SolidSubdiv::Validation
