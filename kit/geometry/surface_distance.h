// SPDX-License-Identifier: Apache-2.0
// How far one surface lies from another, measured at many points of the first.
//
//     const auto there = Geometry::MeasureDistance(fitted, fitted_triangles, target);
//     there.rms; there.most;
#pragma once

#include <array>
#include <functional>
#include <span>
#include <vector>

#include <solidsubdiv/kit/geometry/closest_point.h>

namespace SolidSubdiv::Geometry {

/// In the unit of the positions. Points count by the area that they stand for.
struct DistanceSummary {
    double rms = 0;
    double mean = 0;
    double p95 = 0, p99 = 0;  ///< so much of the area is nearer
    double most = 0;
    Index most_vertex = kNoIndex;  ///< corner of the triangle where `most` was found; of clouds the point
    Offset n_points = 0;           ///< measured at
    double left_out = 0;           ///< [0, 1]: the part of the area that was not counted
};

struct DistanceOptions {
    Offset n_points = 100'000;  ///< about how many points triangles get, by area, each one at least. [1, 1e9]
    /// Points that are not counted, by the point of the target nearest to them and the triangle that they lie in (of
    /// clouds: the point); none: all are.
    std::function<bool(const ClosestPoint& nearest, const std::array<double, 3>& point, Index element)> is_left_out{};
};

/// From a surface (triangles, each measured at its corners and at points spread inside) or a cloud (its points) to
/// another. The measured `most` is at most the one-sided Hausdorff distance; between points a surface may be farther.
/// @throws InvalidInput as ClosestPoints::Find
DistanceSummary MeasureDistance(std::span<const double> positions, std::span<const Index> triangles,
                                const ClosestPoints& target, const DistanceOptions& options = {});

}  // namespace SolidSubdiv::Geometry
