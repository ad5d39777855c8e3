// SPDX-License-Identifier: Apache-2.0
// Edges of the boundary, each held to all sharp edges of the target: a thousand times a few thousand, no more.
#include <solidsubdiv/apps/fit/creases.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>

#include <solidsubdiv/apps/fit/internal/vec3.h>
#include <solidsubdiv/far/topology_refiner.h>
#include <solidsubdiv/sdc/creases.h>
#include <solidsubdiv/sdc/errors.h>

namespace SolidSubdiv::Fit {

using namespace Internal;

namespace {

struct Segment {
    Vec3 start, end;

    /// Of a point.
    Vec3 Nearest(const Vec3& p) const {
        const Vec3 along = end - start;
        const double square = Dot(along, along);
        const double t = square > 0 ? std::clamp(Dot(p - start, along) / square, 0.0, 1.0) : 0;
        return start + t * along;
    }
};

std::set<std::pair<Index, Index>> BoundaryEdges(const ControlMesh& mesh) {
    const bool is_polyhedral = !mesh.hexes.empty() || !mesh.quads.empty();
    const auto refiner =
        Far::TopologyRefiner::Create(mesh.View(), is_polyhedral ? Sdc::Split::Polyhedral : Sdc::Split::TetOct);
    std::set<std::pair<Index, Index>> edges;
    const auto add = [&](std::span<const Index> face) {
        for (std::size_t k = 0; k < face.size(); ++k) edges.insert(std::minmax({face[k], face[(k + 1) % face.size()]}));
    };
    if (is_polyhedral) {
        const Vtr::PolyhedralLevel& level = refiner.polyhedral_level(0);
        for (Index b = 0; b < level.n_boundary_faces; ++b) add(level.boundary_rows.Row(level.boundary_vertices, b));
    } else {
        for (Index b = 0; b < refiner.level(0).n_boundary_faces; ++b) add(refiner.level(0).BoundaryVertices(b));
    }
    return edges;
}

/// Whether all of an edge runs along sharp ones.
bool RunsAlong(const Segment& edge, std::span<const Segment> sharp, double near) {
    const Vec3 along = edge.end - edge.start;
    constexpr double kLeastCosine = 0.8;
    for (double t : {0.1, 0.3, 0.5, 0.7, 0.9}) {
        const Vec3 p = edge.start + t * along;
        const bool is_near = std::any_of(sharp.begin(), sharp.end(), [&](const Segment& s) {
            return Length(s.Nearest(p) - p) <= near * Length(along) &&
                   std::abs(Dot(Unit(s.end - s.start), Unit(along))) >= kLeastCosine;
        });
        if (!is_near) return false;
    }
    return true;
}

}  // namespace

void CreaseOptions::Validate() const {
    if (!(degrees > 0 && degrees < 180)) {
        throw InvalidInput("fit: degrees is " + std::to_string(degrees) + "; it must be between 0 and 180");
    }
    if (!(near > 0 && near <= 1)) throw InvalidInput("fit: near is " + std::to_string(near) + "; it must be in (0, 1]");
}

std::vector<Index> SharpEdges(const TargetSurface& target, double degrees) {
    std::map<std::pair<Index, Index>, std::vector<Vec3>> normals;
    for (std::size_t t = 0; t + 2 < target.triangles.size(); t += 3) {
        const Index* const v = &target.triangles[t];
        const Vec3 a = PointAt(target.positions, v[0]);
        const Vec3 n = Unit(Cross(PointAt(target.positions, v[1]) - a, PointAt(target.positions, v[2]) - a));
        if (!(Dot(n, n) > 0)) continue;  // slivers of no area have no say
        for (std::size_t k = 0; k < 3; ++k) normals[std::minmax({v[k], v[(k + 1) % 3]})].push_back(n);
    }
    const double least = std::cos(degrees * 3.14159265358979323846 / 180);
    std::vector<Index> edges;
    for (const auto& edge : normals) {
        if (edge.second.size() != 2 || Dot(edge.second[0], edge.second[1]) >= least) continue;
        edges.insert(edges.end(), {edge.first.first, edge.first.second});
    }
    return edges;
}

double SharpAngle(const TargetSurface& target) {
    constexpr double kPart = 0.6, kSharp = 50;
    const auto n_from = [&](double degrees) { return static_cast<double>(SharpEdges(target, degrees).size()); };
    const double n_bent = n_from(40);
    return n_bent > 0 && n_from(70) >= kPart * n_bent ? kSharp : 0;
}

Index MarkCreases(ControlMesh& mesh, const TargetSurface& target, const CreaseOptions& options) {
    options.Validate();
    std::vector<Segment> sharp;
    const std::vector<Index> edges = SharpEdges(target, options.degrees);
    for (std::size_t i = 0; i < edges.size(); i += 2) {
        sharp.push_back({PointAt(target.positions, edges[i]), PointAt(target.positions, edges[i + 1])});
    }
    if (sharp.empty()) return 0;
    Index n_creases = 0;
    for (const auto& edge : BoundaryEdges(mesh)) {
        if (!RunsAlong({PointAt(mesh.positions, edge.first), PointAt(mesh.positions, edge.second)}, sharp,
                       options.near)) {
            continue;
        }
        mesh.crease_edges.insert(mesh.crease_edges.end(), {edge.first, edge.second});
        mesh.crease_sharpness.push_back(Sdc::kInfinitelySharp);
        ++n_creases;
    }
    return n_creases;
}

}  // namespace SolidSubdiv::Fit
