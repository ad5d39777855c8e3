// SPDX-License-Identifier: Apache-2.0
// A model to drag, and the least change of its control points by dense elimination.
#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include <solidsubdiv/apps/deform/deformer.h>
#include <solidsubdiv/apps/deform/direct_manipulation.h>

#include "apps/deform/editing_testing.h"
#include "apps/deform/sphere_testing.h"

namespace SolidSubdiv::Deform {

inline constexpr double kHard = std::numeric_limits<double>::infinity();

/// A sphere in 2^3 hexes.
struct Ball {
    ControlLattice lattice = TestShapes::Hierarchy(2, 1).lattices[0];
    TestShapes::Sphere sphere{8, .7};
    Embedding embedding = Embedding::Create(lattice.View(), lattice.positions, sphere.points, {});

    DragOptions KeepVolume() const { return {.preserve_volume = true, .triangles = sphere.triangles}; }
};

inline std::set<Index> OutsideOf(const Embedding& embedding) {
    std::set<Index> points;
    for (const OutsidePoint& out : embedding.outside()) points.insert(out.point);
    return points;
}

inline std::vector<double> PointsOf(const Embedding& embedding, std::span<const double> control_points) {
    std::vector<double> points(3 * static_cast<std::size_t>(embedding.n_points()));
    Deformer(embedding).Deform(control_points, points);
    return points;
}

/// A target that far from where a point is.
inline DragTarget TargetBeside(const std::vector<double>& points, Index point, const std::array<double, 3>& by,
                               double weight = kHard) {
    DragTarget target{.point = point, .weight = weight};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        target.position[axis] = points[3 * static_cast<std::size_t>(point) + axis] + by[axis];
    }
    return target;
}

inline double DistanceOf(const std::vector<double>& points, const DragTarget& target) {
    const double* x = points.data() + 3 * static_cast<std::size_t>(target.point);
    return std::hypot(x[0] - target.position[0], x[1] - target.position[1], x[2] - target.position[2]);
}

/// Solves a small system by elimination with pivots.
inline std::vector<double> SolveDense(std::vector<std::vector<double>> matrix, std::vector<double> right) {
    const std::size_t n = right.size();
    for (std::size_t i = 0; i < n; ++i) {
        std::size_t pivot = i;
        for (std::size_t k = i; k < n; ++k) pivot = std::abs(matrix[k][i]) > std::abs(matrix[pivot][i]) ? k : pivot;
        std::swap(matrix[i], matrix[pivot]);
        std::swap(right[i], right[pivot]);
        for (std::size_t k = 0; k < n; ++k) {
            if (k == i) continue;
            const double factor = matrix[k][i] / matrix[i][i];
            for (std::size_t j = i; j < n; ++j) matrix[k][j] -= factor * matrix[i][j];
            right[k] -= factor * right[i];
        }
    }
    for (std::size_t i = 0; i < n; ++i) right[i] /= matrix[i][i];
    return right;
}

/// control_points + A^T (A A^T + 1 / weights)^-1 (targets - points), A the targets' rows without locked columns.
inline std::vector<double> LeastChange(const Embedding& embedding, const std::vector<double>& control_points,
                                       const std::vector<DragTarget>& targets, const std::vector<Index>& locked) {
    const std::size_t n = targets.size(), n_control_points = control_points.size() / 3;
    std::vector<std::vector<double>> a(n, std::vector<double>(n_control_points)), gram(n, std::vector<double>(n));
    const std::vector<double> points = PointsOf(embedding, control_points);
    for (std::size_t t = 0; t < n; ++t) {
        const Far::StencilRows<double> row = embedding.ControlRows(std::array{targets[t].point});
        for (std::size_t k = 0; k < row.indices.size(); ++k)
            a[t][static_cast<std::size_t>(row.indices[k])] += row.weights[k];
        for (Index i : locked) a[t][static_cast<std::size_t>(i)] = 0;
    }
    for (std::size_t s = 0; s < n; ++s) {
        for (std::size_t t = 0; t < n; ++t) {
            for (std::size_t i = 0; i < n_control_points; ++i) gram[s][t] += a[s][i] * a[t][i];
        }
        gram[s][s] += 1 / targets[s].weight;
    }
    std::vector<double> result = control_points;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        std::vector<double> right;
        for (const DragTarget& t : targets) {
            right.push_back(t.position[axis] - points[3 * static_cast<std::size_t>(t.point) + axis]);
        }
        const std::vector<double> y = SolveDense(gram, right);
        for (std::size_t t = 0; t < n; ++t) {
            for (std::size_t i = 0; i < n_control_points; ++i) result[3 * i + axis] += a[t][i] * y[t];
        }
    }
    return result;
}

}  // namespace SolidSubdiv::Deform
