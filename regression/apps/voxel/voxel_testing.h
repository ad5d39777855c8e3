// SPDX-License-Identifier: Apache-2.0
// Solids of every kind of cell for tests of the room, and voxels of them found the plain way.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <solidsubdiv/apps/voxel/voxelize.h>
#include <solidsubdiv/far/primvar_refiner.h>
#include <solidsubdiv/kit/geometry/tessellation_inside.h>

#include "polyhedral_shapes.h"
#include "sanitized.h"

namespace SolidSubdiv::Voxel {

using Vec = std::array<double, 3>;
using Voxel3 = std::array<int, 3>;

inline Vec Minus(const Vec& a, const Vec& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline double Dot(const Vec& a, const Vec& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Vec Cross(const Vec& a, const Vec& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline Vec PointOf(const std::vector<double>& positions, Index v) {
    const std::size_t i = 3 * static_cast<std::size_t>(v);
    return {positions[i], positions[i + 1], positions[i + 2]};
}

/// A level of a solid.
struct Solid {
    std::string name;
    Far::TopologyRefiner refiner;
    int level;
    std::vector<double> positions;

    Grids Voxelize(const VoxelizeOptions& options) const { return Voxel::Voxelize(refiner, level, positions, options); }
    std::vector<Index> Tets() const { return Geometry::CutIntoTets(refiner, level); }
    Vec Point(Index v) const { return PointOf(positions, v); }
};

inline Solid SolidOf(std::string name, const Far::TopologyDescriptor& cells, std::vector<double> positions,
                     const char* scheme = "", int level = 0) {
    const bool is_tet_oct = cells.hexes.empty() && cells.polyhedron_offsets.empty();
    auto refiner = Far::TopologyRefiner::Create(cells, is_tet_oct ? Sdc::Split::TetOct : Sdc::Split::Polyhedral);
    refiner.RefineUniform({.max_level = level});
    for (int l = 1; l <= level; ++l) {
        std::vector<double> fine(3 * static_cast<std::size_t>(refiner.n_vertices(l)));
        Far::PrimvarRefiner(refiner, Sdc::SchemeOf(scheme)).Interpolate<double>(l, positions, fine, 3);
        positions = std::move(fine);
    }
    return {std::move(name), std::move(refiner), level, std::move(positions)};
}
inline Solid SolidOf(std::string name, const TestShapes::PolyhedralShape& s, const char* scheme = "", int level = 0) {
    Far::TopologyDescriptor cells{.n_vertices = s.n_vertices, .hexes = s.hexes};
    if (s.cell_offsets.size() > 1) {
        cells.polyhedron_offsets = s.cell_offsets;
        cells.polyhedron_face_offsets = s.face_offsets;
        cells.polyhedron_vertices = s.face_vertices;
    }
    std::vector<Index> by_corners[6];  // of three, four and five corners
    for (std::size_t f = 0; f + 1 < s.polygon_offsets.size(); ++f) {
        auto& faces = by_corners[s.polygon_offsets[f + 1] - s.polygon_offsets[f]];
        faces.insert(faces.end(), s.polygon_vertices.begin() + s.polygon_offsets[f],
                     s.polygon_vertices.begin() + s.polygon_offsets[f + 1]);
    }
    const std::vector<Offset> offsets{0, 5};
    cells.triangles = by_corners[3];
    cells.quads = by_corners[4];
    if (!by_corners[5].empty()) {
        cells.polygon_offsets = offsets;
        cells.polygon_vertices = by_corners[5];
    }
    cells.edges = s.edges;
    return SolidOf(std::move(name), cells, s.positions, scheme, level);
}
inline Solid SolidOf(std::string name, const TestShapes::Shape& s, const char* scheme = "", int level = 0) {
    return SolidOf(
        std::move(name),
        {.n_vertices = s.n_vertices, .tets = s.tets, .octs = s.octs, .triangles = s.triangles, .edges = s.edges},
        s.positions, scheme, level);
}

/// Each coordinate moved by up to `amount`, so that no symmetry hides a fault.
template <class Shape>
Shape Jittered(Shape shape, double amount, std::uint64_t seed) {
    TestShapes::Random random(seed);
    for (double& x : shape.positions) x += amount * random.Uniform();
    return shape;
}

/// Cells of all kinds, refined ones, ones that touch in edges and vertices, sheets and rods, inverted and folded ones.
inline std::vector<Solid> Solids() {
    using namespace TestShapes;
    std::vector<Solid> solids;
    solids.push_back(SolidOf("hexahedra", Jittered(HexBlock(2), 0.1, 1)));
    solids.push_back(SolidOf("mixed cells", Jittered(MixedCells(), 0.05, 2)));
    solids.push_back(SolidOf("tets", Jittered(RandomSubset(KuhnBlock(3), 60, 2), 0.1, 3)));
    solids.push_back(SolidOf("octahedra", Jittered(OctsAndTets(), 0.05, 4)));
    solids.push_back(SolidOf("touching cubes", Jittered(TouchingCubes(), 0.05, 5)));
    solids.push_back(SolidOf("sheets on hexahedra", Jittered(CubeWithSheets(), 0.05, 6)));
    solids.push_back(SolidOf("sheets on tets", Jittered(MixedDimensions(), 0.05, 7)));
    solids.push_back(SolidOf("mixed cells, level 2", MixedCells(), "catmull-clark-solid", 2));
    solids.push_back(SolidOf("octahedra, level 2", OctsAndTets(), "box-spline", 2));
    solids.push_back(SolidOf("sheets, level 1", CubeWithSheets(), "catmull-clark-solid", 1));
    solids.push_back(SolidOf("sheets on tets, level 1", MixedDimensions(), "linear-solid", 1));
    solids.push_back(SolidOf("folded tets", Jittered(KuhnBlock(3), 0.7, 8)));
    solids.push_back(SolidOf("folded hexahedra", Jittered(HexBlock(3), 0.7, 9)));
    return solids;
}

/// Of so many voxels one is compared with brute force: a sanitizer needs minutes for all.
inline constexpr int kOneIn = kIsSanitized ? 11 : 1;

/// Voxels of a box, z fastest.
struct VoxelBox {
    Voxel3 low, high;

    template <class Visit>
    void ForEach(Visit&& visit) const {
        for (int x = low[0]; x <= high[0]; ++x) {
            for (int y = low[1]; y <= high[1]; ++y) {
                for (int z = low[2]; z <= high[2]; ++z) visit(Voxel3{x, y, z});
            }
        }
    }
    /// One in kOneIn of them, with their places in the list.
    template <class Visit>
    void ForCompared(Visit&& visit) const {
        std::size_t i = 0;
        ForEach([&](const Voxel3& v) {
            if (i % kOneIn == 0) visit(v, i);
            ++i;
        });
    }
};

/// Around all points, and `margin` voxels wider.
inline VoxelBox BoxAround(const Solid& solid, double voxel_size, int margin) {
    VoxelBox box{{1 << 30, 1 << 30, 1 << 30}, {-(1 << 30), -(1 << 30), -(1 << 30)}};
    for (std::size_t i = 0; i < solid.positions.size(); ++i) {
        const double x = solid.positions[i] / voxel_size;
        box.low[i % 3] = std::min(box.low[i % 3], static_cast<int>(std::floor(x)) - margin);
        box.high[i % 3] = std::max(box.high[i % 3], static_cast<int>(std::ceil(x)) + margin);
    }
    return box;
}
inline Vec Center(const Voxel3& v, double voxel_size) {
    return {v[0] * voxel_size, v[1] * voxel_size, v[2] * voxel_size};
}
inline std::string NameOf(const Voxel3& v) {
    return std::to_string(v[0]) + " " + std::to_string(v[1]) + " " + std::to_string(v[2]);
}

/// From a point to a triangle, by cases of where the nearest point lies.
inline double DistanceToTriangle(const Vec& p, const std::array<Vec, 3>& t) {
    const Vec n = Cross(Minus(t[1], t[0]), Minus(t[2], t[0]));
    bool is_over = Dot(n, n) > 0;
    double least = HUGE_VAL;
    for (std::size_t k = 0; k < 3; ++k) {
        const Vec edge = Minus(t[(k + 1) % 3], t[k]), to_p = Minus(p, t[k]);
        is_over = is_over && Dot(Cross(n, edge), to_p) >= 0;
        const double s = Dot(edge, edge) > 0 ? std::clamp(Dot(to_p, edge) / Dot(edge, edge), 0.0, 1.0) : 0.0;
        const Vec rest{to_p[0] - s * edge[0], to_p[1] - s * edge[1], to_p[2] - s * edge[2]};
        least = std::min(least, std::sqrt(Dot(rest, rest)));
    }
    return is_over ? std::abs(Dot(n, Minus(p, t[0]))) / std::sqrt(Dot(n, n)) : least;
}

/// Distances and cells of points, by trying all.
class BruteForce {
  public:
    explicit BruteForce(const Solid& solid) : solid_(solid), tets_(solid.Tets()) {
        static constexpr std::size_t kFaces[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};
        std::map<std::array<Index, 3>, int> counts;
        for (std::size_t t = 0; t < tets_.size(); t += 4) {
            for (const auto& f : kFaces) ++counts[Sorted({tets_[t + f[0]], tets_[t + f[1]], tets_[t + f[2]]})];
        }
        // What two tets share is inside.
        for (const auto& [face, n] : counts) {
            if (n == 1) triangles_.push_back({solid.Point(face[0]), solid.Point(face[1]), solid.Point(face[2])});
        }
        for (const auto& t : triangles_) triangle_balls_.push_back(BallOf(t));
        for (std::size_t t = 0; t < tets_.size() / 4; ++t) tet_balls_.push_back(BallOf(Corners(t)));
    }
    double Distance(const Vec& p) const {
        double least = HUGE_VAL;
        for (std::size_t t = 0; t < triangles_.size(); ++t) {
            if (triangle_balls_[t].Distance(p) < least) least = std::min(least, DistanceToTriangle(p, triangles_[t]));
        }
        return least;
    }
    /// How far a point is outside of a tet: at most 0 if the tet holds it, and no more than that if it is far.
    double Outside(std::size_t tet, const Vec& p) const {
        const std::array<Vec, 4> v = Corners(tet);
        double most = -HUGE_VAL;
        for (std::size_t f = 0; f < 4; ++f) {
            const Vec &a = v[(f + 1) % 4], n = Cross(Minus(v[(f + 2) % 4], a), Minus(v[(f + 3) % 4], a));
            const double side = Dot(n, Minus(v[f], a));
            if (side == 0) return HUGE_VAL;  // flat
            most = std::max(most, (side > 0 ? -1 : 1) * Dot(n, Minus(p, a)) / std::sqrt(Dot(n, n)));
        }
        if (most <= 0 || most > 1e-6) return most;
        // A plane of a sliver may be near where the tet is not.
        double least = HUGE_VAL;
        for (std::size_t f = 0; f < 4; ++f) {
            least = std::min(least, DistanceToTriangle(p, {v[(f + 1) % 4], v[(f + 2) % 4], v[(f + 3) % 4]}));
        }
        return least;
    }
    /// The least of all tets.
    double Outside(const Vec& p) const {
        double least = HUGE_VAL;
        for (std::size_t t = 0; t < tets_.size() / 4; ++t) {
            const double far = tet_balls_[t].Distance(p);
            least = std::min(least, far > 1e-3 ? far : Outside(t, p));
        }
        return least;
    }
    const std::vector<Index>& tets() const { return tets_; }

  private:
    struct Ball {
        Vec center;
        double radius;
        double Distance(const Vec& p) const {
            const Vec d = Minus(p, center);
            return std::sqrt(Dot(d, d)) - radius;
        }
    };
    template <std::size_t kCorners>
    static Ball BallOf(const std::array<Vec, kCorners>& corners) {
        Ball ball{corners[0], 0};
        for (const Vec& v : corners) ball.radius = std::max(ball.radius, Ball{v, 0}.Distance(corners[0]));
        return ball;
    }
    std::array<Vec, 4> Corners(std::size_t tet) const {
        std::array<Vec, 4> v;
        for (std::size_t k = 0; k < 4; ++k) v[k] = solid_.Point(tets_[4 * tet + k]);
        return v;
    }
    static std::array<Index, 3> Sorted(std::array<Index, 3> face) {
        std::sort(face.begin(), face.end());
        return face;
    }

    const Solid& solid_;
    std::vector<Index> tets_;
    std::vector<std::array<Vec, 3>> triangles_;
    std::vector<Ball> triangle_balls_, tet_balls_;
};

}  // namespace SolidSubdiv::Voxel
