// SPDX-License-Identifier: Apache-2.0
// Checks, a shift and a scale.
#include <solidsubdiv/apps/fit/internal/start/target_shape.h>

#include <algorithm>
#include <map>
#include <utility>

#include <solidsubdiv/kit/geometry/box.h>
#include <solidsubdiv/kit/geometry/compact_surface.h>
#include <solidsubdiv/sdc/disjoint_sets.h>
#include <solidsubdiv/sdc/errors.h>

namespace SolidSubdiv::Fit::Starting {

namespace {

/// Six times what each component encloses, negative where its triangles look inwards.
std::vector<double> VolumesOf(std::span<const double> positions, std::span<const Index> triangles) {
    Sdc::DisjointSets sets(positions.size() / 3);
    const auto at = [&](std::size_t i) { return static_cast<std::size_t>(triangles[i]); };
    for (std::size_t t = 0; t < triangles.size(); t += 3) {
        sets.Unite(at(t), at(t + 1));
        sets.Unite(at(t), at(t + 2));
    }
    std::map<std::size_t, double> volumes;
    for (std::size_t t = 0; t < triangles.size(); t += 3) {
        const Vec3 a = PointAt(positions, triangles[t]), b = PointAt(positions, triangles[t + 1]);
        volumes[sets.Find(at(t))] += Dot(a, Cross(b, PointAt(positions, triangles[t + 2])));
    }
    std::vector<double> values;
    for (const auto& piece : volumes) values.push_back(piece.second);
    return values;
}

}  // namespace

TargetShape::TargetShape(const TargetSurface& target) : triangles(target.triangles.begin(), target.triangles.end()) {
    target.Validate();
    positions.assign(target.positions.begin(), target.positions.end());
    if (!triangles.empty()) {
        // Points that no triangle has are no part of a surface.
        Geometry::CompactSurface surface =
            Geometry::MakeCompactSurface(triangles, static_cast<Index>(positions.size() / 3));
        positions = Geometry::GatherRows(target.positions, 3, surface.vertices);
        triangles = std::move(surface.corners);
    }
    const Geometry::Box box = Geometry::BoundingBox(positions);
    middle = {.5 * (box.low[0] + box.high[0]), .5 * (box.low[1] + box.high[1]), .5 * (box.low[2] + box.high[2])};
    scale = std::max({box.Extent(0), box.Extent(1), box.Extent(2)});
    if (!(scale > 0)) throw InvalidInput("the triangles of the target are all at one place");
    const auto n_used = static_cast<Index>(positions.size() / 3);
    for (Index v = 0; v < n_used; ++v) SetPoint(positions, v, 1 / scale * (PointAt(positions, v) - middle));
    components = Geometry::SurfaceComponents(triangles, n_used);
    // What is open encloses nothing: it looks where it looks.
    double largest = 0;
    for (double volume : VolumesOf(positions, triangles)) {
        if (std::abs(volume) > std::abs(largest)) largest = volume;
    }
    was_turned = largest < 0 && CountBorderEdges() == 0;
    for (std::size_t t = 0; was_turned && t < triangles.size(); t += 3) std::swap(triangles[t + 1], triangles[t + 2]);
}

Offset TargetShape::CountBorderEdges() const {
    Offset n = 0;
    for (const auto& c : components) n += c.n_border_edges;
    return n;
}

Offset TargetShape::CountFlippedEdges() const {
    Offset n = 0;
    for (const auto& c : components) n += c.n_flipped_edges;
    return n;
}

Offset TargetShape::Euler() const {
    Offset euler = 0;
    for (const auto& c : components) euler += c.EulerCharacteristic();
    return euler;
}

Vec3 TargetShape::NormalOf(Index triangle) const {
    const Index* const t = &triangles[3 * static_cast<std::size_t>(triangle)];
    const Vec3 a = PointAt(positions, t[0]);
    return Unit(Cross(PointAt(positions, t[1]) - a, PointAt(positions, t[2]) - a));
}

SolidTopology TargetShape::Topology() const {
    SolidTopology topology{0, 0, Euler()};
    for (double volume : VolumesOf(positions, triangles)) {
        const bool is_cavity = IsOriented() && volume < 0;
        ++(is_cavity ? topology.n_cavities : topology.n_solids);
    }
    return topology;
}

void TargetShape::Restore(std::vector<double>& points) const {
    for (Index v = 0; static_cast<std::size_t>(v) < points.size() / 3; ++v) {
        SetPoint(points, v, middle + scale * PointAt(points, v));
    }
}

}  // namespace SolidSubdiv::Fit::Starting
