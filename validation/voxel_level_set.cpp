// SPDX-License-Identifier: Apache-2.0
// Validator voxel-level-set: OpenVDB's level sets, exact distances, and volumes by the divergence theorem.
#include "voxel_level_set.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

#include <solidsubdiv/far/primvar_refiner.h>
#include <solidsubdiv/kit/geometry/tessellation_inside.h>
#include <solidsubdiv/kit/io/formats.h>

#include "points.h"
#include "validators.h"

namespace SolidSubdiv::Validation {

namespace {

using Point = std::array<double, 3>;
using Corners = std::array<Index, 3>;

Point Minus(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
double Dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Point Cross(const Point& a, const Point& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Point PointOf(const TriangleSurface& surface, std::size_t corner) {
    const double* const p = &surface.points[3 * static_cast<std::size_t>(surface.triangles[corner])];
    return {p[0], p[1], p[2]};
}

std::string NameOf(const VoxelBlock& block, std::size_t i) {
    const auto p = block.PlaceOf(i);
    return "voxel (" + std::to_string(p[0]) + ", " + std::to_string(p[1]) + ", " + std::to_string(p[2]) + ")";
}

double Exceeds(double value, double allowed) { return std::isnan(value) ? value : std::max(0.0, value - allowed); }

VoxelShape Refined(const std::filesystem::path& path, int level, const Sdc::Scheme& scheme) {
    const Io::Mesh mesh = Io::ReadSolid(path);
    VoxelShape shape{path.filename().string(), Far::TopologyRefiner::Create(mesh.topology, Sdc::Split::TetOct), level,
                     mesh.positions};
    shape.refiner.RefineUniform({.max_level = level});
    for (int l = 1; l <= level; ++l) {
        std::vector<double> fine(3 * static_cast<std::size_t>(shape.refiner.n_vertices(l)));
        Far::PrimvarRefiner(shape.refiner, scheme).Interpolate<double>(l, shape.positions, fine, 3);
        shape.positions = std::move(fine);
    }
    return shape;
}

void CheckShape(const VoxelShape& shape, double voxel_size, double (*exact)(const Point&), Findings& findings) {
    const ShapeVoxels ours = VoxelizeShape(shape, voxel_size, 3);
    const TriangleSurface surface = BoundaryOf(shape);
    VoxelBlock theirs = ours.distances;
    MeshToVolume(surface, theirs);
    Findings found;
    CompareLevelSets(ours.distances, theirs, surface, found);
    findings.Merge(found, shape.name + " against OpenVDB");
    found = {};
    CompareVolumes(ours, surface, found);
    findings.Merge(found, shape.name + ", volume");
    if (!exact) return;
    found = {};
    CompareDistances(ours.distances, exact, SagittaOf(surface, exact), found);
    findings.Merge(found, shape.name + " against exact distances");
}

}  // namespace

TriangleSurface BoundaryOf(const VoxelShape& shape) {
    static constexpr std::size_t kFaces[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};
    const auto tets = Geometry::CutIntoTets(shape.refiner, shape.level);
    std::map<Corners, std::vector<Corners>> by_corners;
    for (std::size_t t = 0; t < tets.size(); t += 4) {
        for (const auto& f : kFaces) {
            const Corners face{tets[t + f[0]], tets[t + f[1]], tets[t + f[2]]};
            Corners sorted = face;
            std::sort(sorted.begin(), sorted.end());
            by_corners[sorted].push_back(face);
        }
    }
    TriangleSurface surface{shape.positions, {}};
    for (const auto& [sorted, faces] : by_corners) {
        if (faces.size() == 1) surface.triangles.insert(surface.triangles.end(), faces[0].begin(), faces[0].end());
    }
    return surface;
}

double VolumeOf(const TriangleSurface& surface) {
    double volume = 0;
    for (std::size_t t = 0; t < surface.triangles.size(); t += 3) {
        volume += Dot(PointOf(surface, t), Cross(PointOf(surface, t + 1), PointOf(surface, t + 2))) / 6;
    }
    return volume;
}

double AreaOf(const TriangleSurface& surface) {
    double area = 0;
    for (std::size_t t = 0; t < surface.triangles.size(); t += 3) {
        const Point a = PointOf(surface, t);
        const Point n = Cross(Minus(PointOf(surface, t + 1), a), Minus(PointOf(surface, t + 2), a));
        area += std::sqrt(Dot(n, n)) / 2;
    }
    return area;
}

double WindingNumber(const TriangleSurface& surface, const Point& p) {
    double angle = 0;
    for (std::size_t t = 0; t < surface.triangles.size(); t += 3) {
        const Point a = Minus(PointOf(surface, t), p), b = Minus(PointOf(surface, t + 1), p),
                    c = Minus(PointOf(surface, t + 2), p);
        const double la = std::sqrt(Dot(a, a)), lb = std::sqrt(Dot(b, b)), lc = std::sqrt(Dot(c, c));
        angle += 2 * std::atan2(Dot(a, Cross(b, c)), la * lb * lc + Dot(a, b) * lc + Dot(b, c) * la + Dot(c, a) * lb);
    }
    return angle / (4 * std::acos(-1.0));
}

void CompareLevelSets(const VoxelBlock& ours, const VoxelBlock& theirs, const TriangleSurface& surface,
                      Findings& findings) {
    if (ours.values.size() != theirs.values.size()) return findings.Fault("another number of voxels");
    double within = 0, beyond = 0;
    int n_theirs_wrong = 0;
    for (std::size_t i = 0; i < ours.values.size(); ++i) {
        const double a = ours.values[i] / ours.voxel_size, b = theirs.values[i] / ours.voxel_size;
        // On the surface either sign is right.
        if (std::signbit(a) != std::signbit(b) && std::max(std::abs(a), std::abs(b)) > 1e-4) {
            const auto place = ours.PlaceOf(i);
            const double turns = WindingNumber(
                surface, {place[0] * ours.voxel_size, place[1] * ours.voxel_size, place[2] * ours.voxel_size});
            if ((turns > 0.5) != std::signbit(a)) findings.Fault(NameOf(ours, i) + " has another sign");
            ++n_theirs_wrong;
        }
        const double difference = std::abs(std::abs(a) - std::abs(b));
        const bool is_exact = std::abs(b) < kExactBand;
        (is_exact ? within : beyond) = std::max(is_exact ? within : beyond, difference);
        if (is_exact) findings.Error(Exceeds(difference, 0.1), [&] { return NameOf(ours, i); });
    }
    char note[200];
    std::snprintf(
        note, sizeof note,
        "within %g voxels distances differ by up to %.2g of a voxel, farther by %.2g; OpenVDB's sign is wrong "
        "at %d of %zu voxels",
        kExactBand, within, beyond, n_theirs_wrong, ours.values.size());
    findings.notes.push_back(note);
}

void CompareDistances(const VoxelBlock& ours, const std::function<double(const Point&)>& exact, double sagitta,
                      Findings& findings) {
    double largest = 0;
    for (std::size_t i = 0; i < ours.values.size(); ++i) {
        const auto place = ours.PlaceOf(i);
        const double size = ours.voxel_size;
        const double distance = exact({place[0] * size, place[1] * size, place[2] * size});
        if (std::abs(distance) > sagitta && std::signbit(distance) != std::signbit(ours.values[i])) {
            findings.Fault(NameOf(ours, i) + " has another sign");
        }
        if (std::abs(distance) > ours.half_width * size - sagitta) continue;
        const double difference = std::abs(ours.values[i] - distance);
        largest = std::max(largest, difference);
        // 1e-5 of a voxel for floats.
        findings.Error(Exceeds(difference / size, sagitta / size + 1e-5), [&] { return NameOf(ours, i); });
    }
    char note[150];
    std::snprintf(note, sizeof note, "distances differ by up to %.2g of a voxel, facets are off by %.2g",
                  largest / ours.voxel_size, sagitta / ours.voxel_size);
    findings.notes.push_back(note);
}

double SagittaOf(const TriangleSurface& surface, const std::function<double(const Point&)>& exact) {
    constexpr int kSteps = 6;
    double largest = 0;
    for (std::size_t t = 0; t < surface.triangles.size(); t += 3) {
        const Point a = PointOf(surface, t), b = PointOf(surface, t + 1), c = PointOf(surface, t + 2);
        for (int i = 0; i <= kSteps; ++i) {
            for (int j = 0; i + j <= kSteps; ++j) {
                Point p;
                for (std::size_t k = 0; k < 3; ++k) {
                    p[k] = a[k] + (b[k] - a[k]) * i / kSteps + (c[k] - a[k]) * j / kSteps;
                }
                largest = std::max(largest, std::abs(exact(p)));
            }
        }
    }
    return 1.05 * largest;  // samples miss the largest by a few percent
}

void CompareVolumes(const ShapeVoxels& voxels, const TriangleSurface& surface, Findings& findings) {
    const double size = voxels.fog.voxel_size, volume = VolumeOf(surface), layer = AreaOf(surface) * size;
    double negative = 0, filled = 0;
    for (double x : voxels.distances.values) negative += std::signbit(x) ? size * size * size : 0;
    for (double x : voxels.fog.values) filled += x * size * size * size;
    const double of_voxels = std::abs(negative - volume) / layer, of_fog = std::abs(filled - volume) / layer;
    findings.Error(Exceeds(of_voxels, kLayersOfVoxels), [] { return "negative voxels"; });
    findings.Error(Exceeds(of_fog, kLayersOfFog), [] { return "fog"; });
    char note[200];
    std::snprintf(note, sizeof note,
                  "volume %.6g: negative voxels differ by %.2g of it (%.2g layers), fog by %.2g (%.2g layers)", volume,
                  std::abs(negative - volume) / volume, of_voxels, std::abs(filled - volume) / volume, of_fog);
    findings.notes.push_back(note);
}

Findings ValidateVoxelLevelSet(const Context& context) {
    Findings findings;
    const double size = context.is_quick ? 0.06 : 0.03;
    CheckShape(MakeBall(context.is_quick ? 8 : 16), size, DistanceToBall, findings);
    CheckShape(MakeTorus(context.is_quick ? 4 : 8), size, DistanceToTorus, findings);
    CheckShape(MakeTurnedBox(4), size, DistanceToTurnedBox, findings);
    const VoxelShape bunny = Refined(context.shapes / "demo" / "bunny_lattice.vtu", 2, Sdc::BoxSpline{});
    CheckShape(bunny, SizeOf(bunny.positions) / (context.is_quick ? 60 : 150), nullptr, findings);
    return findings;
}

}  // namespace SolidSubdiv::Validation
