// SPDX-License-Identifier: Apache-2.0
// Area vectors of faces, summed at their corners in the order of the faces.
#include <solidsubdiv/apps/deform/vertex_normals.h>

#include <cmath>
#include <numeric>
#include <string>
#include <utility>

#include <solidsubdiv/sdc/errors.h>
#include <solidsubdiv/sdc/parallel.h>

namespace SolidSubdiv::Deform {

namespace {

constexpr Offset kGrain = 4096;

void CheckFaces(Index n_points, std::span<const Offset> offsets, std::span<const Index> corners) {
    if (offsets.empty() || offsets.front() != 0 || offsets.back() != static_cast<Offset>(corners.size())) {
        throw InvalidInput("the offsets of the model's faces must go from 0 to its " + std::to_string(corners.size()) +
                           " corners");
    }
    for (std::size_t f = 0; f + 1 < offsets.size(); ++f) {
        const std::string face = "face " + std::to_string(f) + " of the model ";
        if (offsets[f + 1] < offsets[f] || offsets[f + 1] > offsets.back()) {
            throw InvalidInput(face + "has the offsets " + std::to_string(offsets[f]) + " and " +
                               std::to_string(offsets[f + 1]));
        }
        for (Offset k = offsets[f]; k < offsets[f + 1]; ++k) {
            if (corners[k] < 0 || corners[k] >= n_points) {
                throw InvalidInput(face + "has the point " + std::to_string(corners[k]) + ", out of " +
                                   std::to_string(n_points));
            }
        }
    }
}

}  // namespace

VertexNormals::VertexNormals(Index n_points, std::span<const Offset> offsets, std::span<const Index> corners) {
    CheckFaces(n_points, offsets, corners);
    offsets_.assign(offsets.begin(), offsets.end());
    corners_.assign(corners.begin(), corners.end());
    point_offsets_.assign(static_cast<std::size_t>(n_points) + 1, 0);
    for (Index v : corners_) ++point_offsets_[v];
    Sdc::ScanLengths(point_offsets_);
    faces_.resize(corners_.size());
    std::vector<Offset> next(point_offsets_.begin(), point_offsets_.end() - 1);
    for (Index f = 0; f < n_faces(); ++f) {
        for (Offset k = offsets_[f]; k < offsets_[f + 1]; ++k) faces_[next[corners_[k]]++] = f;
    }
    area_vectors_.resize(3 * static_cast<std::size_t>(n_faces()));
    normals_.resize(3 * static_cast<std::size_t>(n_points));
    is_listed_.assign(static_cast<std::size_t>(n_faces()) + static_cast<std::size_t>(n_points), 0);
}

void VertexNormals::ComputeAreaVector(Index face, std::span<const double> points) {
    double* area = area_vectors_.data() + 3 * static_cast<std::size_t>(face);
    area[0] = area[1] = area[2] = 0;
    const auto at = [&](Offset k) { return points.data() + 3 * static_cast<std::size_t>(corners_[k]); };
    // The fan from the first corner: its triangles' area vectors have the same sum whatever the corner.
    for (Offset k = offsets_[face] + 1; k + 1 < offsets_[face + 1]; ++k) {
        const double *o = at(offsets_[face]), *p = at(k), *q = at(k + 1);
        const double a[3] = {p[0] - o[0], p[1] - o[1], p[2] - o[2]}, b[3] = {q[0] - o[0], q[1] - o[1], q[2] - o[2]};
        area[0] += a[1] * b[2] - a[2] * b[1];
        area[1] += a[2] * b[0] - a[0] * b[2];
        area[2] += a[0] * b[1] - a[1] * b[0];
    }
}

void VertexNormals::ComputeNormal(Index point) {
    double sum[3] = {0, 0, 0};
    for (Offset k = point_offsets_[point]; k < point_offsets_[point + 1]; ++k) {
        for (int axis = 0; axis < 3; ++axis) {
            sum[axis] += area_vectors_[3 * static_cast<std::size_t>(faces_[k]) + static_cast<std::size_t>(axis)];
        }
    }
    const double length = std::hypot(sum[0], sum[1], sum[2]);
    double* normal = normals_.data() + 3 * static_cast<std::size_t>(point);
    for (int axis = 0; axis < 3; ++axis) normal[axis] = length > 0 ? sum[axis] / length : 0;
}

void VertexNormals::Compute(std::span<const double> points) {
    Sdc::ParallelFor(n_faces(), kGrain, [&](Offset begin, Offset end) {
        for (Offset f = begin; f < end; ++f) ComputeAreaVector(static_cast<Index>(f), points);
    });
    Sdc::ParallelFor(static_cast<Offset>(normals_.size() / 3), kGrain, [&](Offset begin, Offset end) {
        for (Offset v = begin; v < end; ++v) ComputeNormal(static_cast<Index>(v));
    });
}

std::span<const Index> VertexNormals::Update(std::span<const Index> moved, std::span<const double> points) {
    listed_.clear();
    updated_.clear();
    if (normals_.empty()) return updated_;
    if (moved.size() > normals_.size() / 6) {  // half of them: all, in parallel
        Compute(points);
        updated_.resize(normals_.size() / 3);
        std::iota(updated_.begin(), updated_.end(), 0);
        return updated_;
    }
    char *is_listed_face = is_listed_.data(), *is_listed_point = is_listed_.data() + n_faces();
    for (Index v : moved) {
        for (Offset k = point_offsets_[v]; k < point_offsets_[v + 1]; ++k) {
            if (std::exchange(is_listed_face[faces_[k]], 1) == 0) listed_.push_back(faces_[k]);
        }
    }
    for (Index f : listed_) {
        is_listed_face[f] = 0;
        ComputeAreaVector(f, points);
        for (Offset k = offsets_[f]; k < offsets_[f + 1]; ++k) {
            if (std::exchange(is_listed_point[corners_[k]], 1) == 0) updated_.push_back(corners_[k]);
        }
    }
    for (Index v : updated_) {
        is_listed_point[v] = 0;
        ComputeNormal(v);
    }
    return updated_;
}

}  // namespace SolidSubdiv::Deform
