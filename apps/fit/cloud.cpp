// SPDX-License-Identifier: Apache-2.0
// Clouds closed on a grid of voxels; normals by planes.
#include <solidsubdiv/apps/fit/cloud.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include <solidsubdiv/apps/fit/internal/neighbors.h>
#include <solidsubdiv/apps/voxel/volume_surface.h>
#include <solidsubdiv/kit/geometry/box.h>
#include <solidsubdiv/kit/geometry/closest_point.h>
#include <solidsubdiv/sdc/errors.h>
#include <solidsubdiv/sdc/parallel.h>

namespace SolidSubdiv::Fit {

using namespace Internal;

namespace {

/// Squared distances to the nearest sample of value 0 along a line, of values that are squared distances across it: the
/// lower envelope of parabolas. Source: felzenszwalb2012distance.
void SquaredDistancesAlong(std::vector<double>& f, std::vector<std::size_t>& v, std::vector<double>& z,
                           std::vector<double>& out) {
    const std::size_t n = f.size();
    std::size_t k = 0;
    v[0] = 0, z[0] = -HUGE_VAL, z[1] = HUGE_VAL;
    const auto meet = [&](std::size_t q, std::size_t p) {
        const auto a = static_cast<double>(q), b = static_cast<double>(p);
        return (f[q] + a * a - f[p] - b * b) / (2 * (a - b));
    };
    for (std::size_t q = 1; q < n; ++q) {
        double s = meet(q, v[k]);
        while (k > 0 && s <= z[k]) s = meet(q, v[--k]);
        v[++k] = q, z[k] = s, z[k + 1] = HUGE_VAL;
    }
    k = 0;
    for (std::size_t q = 0; q < n; ++q) {
        while (z[k + 1] < static_cast<double>(q)) ++k;
        const double d = static_cast<double>(q) - static_cast<double>(v[k]);
        out[q] = d * d + f[v[k]];
    }
    f.swap(out);
}

/// Of each voxel, in voxels: the distance to the nearest that is marked.
std::vector<double> DistancesTo(const std::vector<bool>& marked, const std::array<Offset, 3>& dims) {
    std::vector<double> squared(marked.size());
    // As far as nothing is, but finite: differences of infinities are not numbers.
    for (std::size_t i = 0; i < squared.size(); ++i) squared[i] = marked[i] ? 0 : 1e12;
    Offset stride = 1;
    for (const Offset n : dims) {
        Sdc::ParallelFor(static_cast<Offset>(squared.size()) / n, 64, [&](Offset begin, Offset end) {
            const auto size = static_cast<std::size_t>(n);
            std::vector<double> line(size), out(size), z(size + 1);
            std::vector<std::size_t> v(size);
            for (Offset l = begin; l < end; ++l) {
                const Offset start = l / stride * stride * n + l % stride;
                for (std::size_t i = 0; i < size; ++i) {
                    line[i] = squared[static_cast<std::size_t>(start + static_cast<Offset>(i) * stride)];
                }
                SquaredDistancesAlong(line, v, z, out);
                for (std::size_t i = 0; i < size; ++i) {
                    squared[static_cast<std::size_t>(start + static_cast<Offset>(i) * stride)] = line[i];
                }
            }
        });
        stride *= n;
    }
    for (double& d : squared) d = std::sqrt(d);
    return squared;
}

/// Voxels around a cloud and the distance of each from it, in voxels.
class CloudGrid {
  public:
    CloudGrid(std::span<const double> points, double largest_radius) {
        const Geometry::Box box = Geometry::BoundingBox(points);
        double longest = 0;
        for (std::size_t k = 0; k < 3; ++k) longest = std::max(longest, box.high[k] - box.low[k]);
        width_ = longest / kVoxels;
        const double margin = largest_radius + 3 * width_;
        volume_.voxel_to_world = {width_, 0, 0,      box.low[0] - margin, 0, width_, 0, box.low[1] - margin,
                                  0,      0, width_, box.low[2] - margin};
        for (std::size_t k = 0; k < 3; ++k) {
            volume_.dims[k] = static_cast<Offset>(std::ceil((box.high[k] - box.low[k] + 2 * margin) / width_)) + 1;
        }
        MeasureDistances(points);
    }

    /// What is positive inside, in voxels: the closing by balls of a radius.
    /// @param n_inside voxels that are inside by more than a shell of dense points is by chance
    Geometry::Volume Closing(double radius, Offset& n_inside) const {
        Geometry::Volume closing = volume_;
        const double r = radius / width_;
        closing.values = DistancesTo(Outside(r), volume_.dims);
        n_inside = 0;
        constexpr double kDeep = 0.75;
        // Voxels outside begin half a voxel beyond the balls, for the most part.
        for (double& d : closing.values) n_inside += (d -= r + 0.5) >= kDeep;
        return closing;
    }

  private:
    static constexpr double kVoxels = 64;

    /// To voxels that hold a point, and near them, where half a voxel makes a difference, to the points themselves.
    void MeasureDistances(std::span<const double> points) {
        const std::array<Offset, 3>& n = volume_.dims;
        std::vector<bool> holds_point(static_cast<std::size_t>(volume_.n_voxels()));
        const Geometry::AffineMap& m = volume_.voxel_to_world;
        for (std::size_t p = 0; p < points.size(); p += 3) {
            std::array<Offset, 3> v{};
            for (std::size_t k = 0; k < 3; ++k) v[k] = std::lround((points[p + k] - m[4 * k + 3]) / width_);
            holds_point[static_cast<std::size_t>(v[0] + n[0] * (v[1] + n[1] * v[2]))] = true;
        }
        distances_ = DistancesTo(holds_point, n);
        constexpr double kNear = 4;
        std::vector<std::size_t> near;
        std::vector<double> centres;
        for (std::size_t i = 0; i < distances_.size(); ++i) {
            if (distances_[i] > kNear) continue;
            const auto at = static_cast<Offset>(i);
            const auto centre = volume_.ToWorld({static_cast<double>(at % n[0]), static_cast<double>(at / n[0] % n[1]),
                                                 static_cast<double>(at / n[0] / n[1])});
            near.push_back(i);
            centres.insert(centres.end(), centre.begin(), centre.end());
        }
        const auto nearest = Geometry::ClosestPoints(points, {}).Find(centres);
        for (std::size_t i = 0; i < near.size(); ++i) distances_[near[i]] = nearest[i].distance / width_;
    }

    /// What a walk from a corner reaches beyond the balls, from voxel to voxel over faces.
    std::vector<bool> Outside(double r) const {
        const std::array<Offset, 3>& n = volume_.dims;
        std::vector<bool> outside(distances_.size());
        std::vector<std::array<Offset, 3>> open = {{0, 0, 0}};
        outside[0] = true;
        while (!open.empty()) {
            const std::array<Offset, 3> p = open.back();
            open.pop_back();
            for (std::size_t axis = 0; axis < 3; ++axis) {
                for (const Offset step : {-1, 1}) {
                    std::array<Offset, 3> q = p;
                    q[axis] += step;
                    if (q[axis] < 0 || q[axis] >= n[axis]) continue;
                    const auto at = static_cast<std::size_t>(q[0] + n[0] * (q[1] + n[1] * q[2]));
                    if (outside[at] || distances_[at] <= r) continue;
                    outside[at] = true;
                    open.push_back(q);
                }
            }
        }
        return outside;
    }

    double width_ = 0;
    Geometry::Volume volume_;  ///< without values
    std::vector<double> distances_;
};

/// The points but for those that lie alone: whose sixth neighbour is four spacings away.
std::vector<double> WithoutLonely(std::span<const double> points, const NeighborTree& tree, double spacing) {
    std::vector<double> kept;
    for (Index p = 0; static_cast<std::size_t>(p) < points.size() / 3; ++p) {
        const Vec3 at = PointAt(points, p);
        if (std::sqrt(tree.Find(at, 7).back().squared_distance) > 4 * spacing) continue;
        kept.insert(kept.end(), {at.x, at.y, at.z});
    }
    return kept;
}

/// @pre not all points coincide
void CloseCloud(std::span<const double> points, CloudShape& shape, const Progress& progress) {
    const double diagonal = Geometry::BoundingBox(points).Diagonal();
    // From what just joins neighbours to a quarter of the diagonal: holes as wide as half the shape.
    std::vector<double> radii;
    const double least = std::max(1.5 * shape.spacing, diagonal / 100);
    for (double r = least; r < diagonal / 4; r *= 1.6) radii.push_back(r);
    if (radii.empty()) return;
    radii.push_back(diagonal / 4);
    const CloudGrid grid(points, radii.back());
    std::vector<Offset> counts(radii.size());
    for (std::size_t i = 0; i < radii.size(); ++i) {
        Report(progress, "start: cloud", static_cast<double>(i) / static_cast<double>(radii.size()));
        grid.Closing(radii[i], counts[i]);
    }
    // Sealed: half of what the widest encloses; unsealed shells hold next to nothing.
    const Offset most = *std::max_element(counts.begin(), counts.end());
    constexpr Offset kLeastVoxels = 64;
    if (most < kLeastVoxels) return;
    std::size_t best = 0;
    while (2 * counts[best] < most) ++best;
    Offset n_inside = 0;
    const Geometry::Volume closing = grid.Closing(radii[best], n_inside);
    try {
        Voxel::VolumeSurface made = Voxel::SurfaceOfLevel(closing, 0, {.smooth = 1});
        shape.positions = std::move(made.positions);
        shape.triangles = std::move(made.triangles);
        shape.radius = radii[best];
    } catch (const InvalidInput&) {  // so thin that smoothing takes it away: nothing to make a start of
    }
}

/// Normals of planes through neighbours, of either sign.
std::vector<double> PlaneNormals(std::span<const double> points, const NeighborTree& tree) {
    constexpr std::size_t kNeighbors = 12;
    std::vector<double> normals(points.size());
    Sdc::ParallelFor(static_cast<Offset>(points.size() / 3), 256, [&](Offset begin, Offset end) {
        for (auto p = static_cast<Index>(begin); p < static_cast<Index>(end); ++p) {
            const auto near = tree.Find(PointAt(points, p), kNeighbors + 1);
            Vec3 middle;
            for (const auto& n : near)
                middle = middle + 1.0 / static_cast<double>(near.size()) * PointAt(points, n.point);
            Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
            for (const auto& n : near) {
                const Vec3 d = PointAt(points, n.point) - middle;
                const Eigen::Vector3d e(d.x, d.y, d.z);
                spread += e * e.transpose();
            }
            const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(spread);
            const Eigen::Vector3d n = solver.eigenvectors().col(0);
            // Points on a line have no plane.
            const bool is_plane = solver.eigenvalues()[1] > 1e-6 * solver.eigenvalues()[2];
            if (is_plane) SetPoint(normals, p, {n[0], n[1], n[2]});
        }
    });
    return normals;
}

/// Of the surface nearest to each point, of length 1.
std::vector<Vec3> NearestNormals(std::span<const double> points, const CloudShape& shape) {
    std::vector<Vec3> normals;
    for (const auto& at : Geometry::ClosestPoints(shape.positions, shape.triangles).Find(points)) {
        const Index* const t = &shape.triangles[3 * static_cast<std::size_t>(at.element)];
        const Vec3 a = PointAt(shape.positions, t[0]);
        normals.push_back(Unit(Cross(PointAt(shape.positions, t[1]) - a, PointAt(shape.positions, t[2]) - a)));
    }
    return normals;
}

void OrientNormals(std::span<const double> points, CloudShape& shape) {
    if (shape.triangles.empty()) {
        // Which way they look nobody knows: distances count in all directions.
        if (shape.has_estimated_normals) std::fill(shape.normals.begin(), shape.normals.end(), 0.0);
        return;
    }
    const std::vector<Vec3> outwards = NearestNormals(points, shape);
    double sum = 0;
    for (std::size_t i = 0; i < outwards.size(); ++i) {
        const Vec3 n = PointAt(shape.normals, static_cast<Index>(i));
        const double along = Dot(n, outwards[i]);
        sum += along;
        if (shape.has_estimated_normals && along < 0) SetPoint(shape.normals, static_cast<Index>(i), -1.0 * n);
    }
    if (shape.has_estimated_normals || !(sum < 0)) return;
    for (double& x : shape.normals) x = -x;
    shape.has_turned_normals = true;
}

}  // namespace

CloudShape ShapeOfCloud(std::span<const double> points, std::span<const double> normals, const Progress& progress) {
    const std::size_t n = points.size() / 3;
    if (n < 4) {
        throw InvalidInput("has " + std::to_string(n) + (n == 1 ? " point" : " points") +
                           "; a shape needs four at least");
    }
    if (!normals.empty() && normals.size() != points.size()) {
        throw InvalidInput("has " + std::to_string(n) + " points and " + std::to_string(normals.size() / 3) +
                           " normals");
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (!std::isfinite(points[i])) throw InvalidInput("point " + std::to_string(i / 3) + " is not finite");
    }
    if (!(Geometry::BoundingBox(points).Diagonal() > 0)) throw InvalidInput("all points are one");
    const NeighborTree tree(points);
    CloudShape shape;
    shape.spacing = SpacingOf(points, tree);
    const std::vector<double> dense = WithoutLonely(points, tree, shape.spacing);
    // Where most points coincide the spacing tells nothing of the others.
    const bool is_dense = 2 * dense.size() >= points.size() && Geometry::BoundingBox(dense).Diagonal() > 0;
    CloseCloud(is_dense ? dense : points, shape, progress);
    shape.has_estimated_normals = normals.empty();
    shape.normals = normals.empty() ? PlaneNormals(points, tree) : std::vector<double>(normals.begin(), normals.end());
    for (Index p = 0; static_cast<std::size_t>(p) < n; ++p) SetPoint(shape.normals, p, Unit(PointAt(shape.normals, p)));
    OrientNormals(points, shape);
    return shape;
}

}  // namespace SolidSubdiv::Fit
