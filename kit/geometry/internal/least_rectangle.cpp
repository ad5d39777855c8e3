// SPDX-License-Identifier: Apache-2.0
// Convex hulls by a monotone chain, rectangles by rotating calipers.
#include <solidsubdiv/kit/geometry/internal/least_rectangle.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace SolidSubdiv::Geometry::Internal {

namespace {

double Cross(const Point2& a, const Point2& b) { return a[0] * b[1] - a[1] * b[0]; }
double Dot(const Point2& a, const Point2& b) { return a[0] * b[0] + a[1] * b[1]; }
Point2 Minus(const Point2& a, const Point2& b) { return {a[0] - b[0], a[1] - b[1]}; }

}  // namespace

std::vector<Point2> ConvexHull(std::vector<Point2> points) {
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
    if (points.size() < 3) return points;
    std::vector<Point2> hull;
    // The lower chain from left to right, then the upper one back.
    for (int chain = 0; chain < 2; ++chain) {
        const std::size_t start = hull.size();
        for (const Point2& p : points) {
            while (hull.size() >= start + 2 &&
                   Cross(Minus(hull.back(), hull[hull.size() - 2]), Minus(p, hull.back())) <= 0) {
                hull.pop_back();
            }
            hull.push_back(p);
        }
        hull.pop_back();  // the other chain's first
        std::reverse(points.begin(), points.end());
    }
    return hull;
}

Rectangle LeastRectangle(const std::vector<Point2>& points, double least_length) {
    const std::vector<Point2> hull = ConvexHull(points);
    Rectangle least;
    if (hull.size() < 2) return least;
    least.area = std::numeric_limits<double>::infinity();
    const std::size_t n = hull.size();
    const auto edge = [&](std::size_t i) { return Minus(hull[(i + 1) % n], hull[i % n]); };
    std::size_t right = 1, top = 1, left = 1;  // how far along the hull the calipers are; they never turn back
    for (std::size_t i = 0; i < n; ++i) {
        const Point2 along = edge(i);
        const double length = std::hypot(along[0], along[1]);
        const Point2 u{along[0] / length, along[1] / length}, across{-u[1], u[0]};
        right = std::max(right, i + 1);
        while (right < i + n && Dot(edge(right), u) > 0) ++right;
        top = std::max(top, right);
        while (top < i + n && Dot(edge(top), across) > 0) ++top;
        left = std::max(left, top);
        while (left < i + n && Dot(edge(left), u) < 0) ++left;
        const double width = Dot(Minus(hull[right % n], hull[left % n]), u);
        const double height = Dot(Minus(hull[top % n], hull[i]), across);
        const double area = std::max(width, least_length) * std::max(height, least_length);
        if (area < least.area) least = {u, area};
    }
    return least;
}

}  // namespace SolidSubdiv::Geometry::Internal
