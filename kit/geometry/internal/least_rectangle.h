// SPDX-License-Identifier: Apache-2.0
// The rectangle of least area around points of the plane.
#pragma once

#include <array>
#include <vector>

namespace SolidSubdiv::Geometry::Internal {

using Point2 = std::array<double, 2>;

struct Rectangle {
    Point2 direction{1, 0};  ///< unit vector along one side
    double area = 0;
};

/// Corners of the convex hull, counterclockwise from the first by x, then y; none on a straight line between others.
std::vector<Point2> ConvexHull(std::vector<Point2> points);

/// One side of it lies on an edge of the hull (freeman1975), so all edges are tried while four
/// calipers turn around the hull. Sides below `least_length` count as that. Of less than two different points: as made.
Rectangle LeastRectangle(const std::vector<Point2>& points, double least_length);

}  // namespace SolidSubdiv::Geometry::Internal
