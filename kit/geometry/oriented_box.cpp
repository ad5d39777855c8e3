// SPDX-License-Identifier: Apache-2.0
// Boxes by frames: each kind chooses a frame, then all points say how large the box is.
#include <solidsubdiv/kit/geometry/oriented_box.h>

#include <string>
#include <vector>

#include <solidsubdiv/kit/geometry/internal/extremes.h>
#include <solidsubdiv/kit/geometry/internal/least_box.h>
#include <solidsubdiv/kit/geometry/internal/principal_axes.h>
#include <solidsubdiv/kit/geometry/internal/usable_positions.h>

namespace SolidSubdiv::Geometry {

namespace {

using namespace Internal;

Frame OrientedFrame(std::span<const double> points, const PrincipalAxes& principal, const Box& box) {
    constexpr double kTie = 1e-6;  // of the largest variance; nearer components are rounding of 30 bits, magnified
    const auto& v = principal.variances;
    const bool first_two = v[0] - v[1] <= kTie * v[0], last_two = v[1] - v[2] <= kTie * v[0];
    if (!first_two && !last_two) return principal.axes;
    LeastBox search(points, principal, box);
    if (first_two && last_two) return search.Find();
    return search.Turn(principal.axes, {last_two, false, first_two});
}

/// Of the frames with these axes, in any order and direction, the one nearest to the coordinate axes.
Frame NearestToCoordinates(const Frame& frame) {
    constexpr int kOrders[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
    Frame nearest = frame;
    double most = -4;
    for (const auto& order : kOrders) {
        for (unsigned signs = 0; signs < 4; ++signs) {
            Frame turned;
            for (std::size_t k = 0; k < 2; ++k) turned[k] = (signs >> k & 1 ? -1. : 1.) * frame[order[k]];
            turned[2] = Cross(turned[0], turned[1]);
            const double trace = turned[0].x + turned[1].y + turned[2].z;
            if (trace <= most + 1e-9) continue;  // ties by rounding go to the first
            most = trace;
            nearest = turned;
        }
    }
    return nearest;
}

}  // namespace

std::array<double, 3> OrientedBox::At(const std::array<double, 3>& t) const {
    std::array<double, 3> point = corner;
    for (std::size_t k = 0; k < 3; ++k) {
        for (std::size_t c = 0; c < 3; ++c) point[c] += t[k] * axes[k][c];
    }
    return point;
}

std::array<double, 3> OrientedBox::CoordinatesOf(std::span<const double, 3> point) const {
    std::array<double, 3> t{};
    for (std::size_t k = 0; k < 3; ++k) {
        for (std::size_t c = 0; c < 3; ++c) t[k] += (point[c] - corner[c]) * axes[k][c];
    }
    return t;
}

BoxKind BoxKindOf(std::string_view name) {
    if (name == "aabb") return BoxKind::AxisAligned;
    if (name == "obb") return BoxKind::Oriented;
    if (name == "minimum") return BoxKind::Minimum;
    throw InvalidInput("there is no box '" + std::string(name) + "'; there are aabb, obb and minimum");
}

OrientedBox MakeBox(std::span<const double> points, BoxKind kind) {
    if (points.empty()) throw InvalidInput("a box needs a point to be around; there is none");
    if (points.size() % 3 != 0) {
        throw InvalidInput(std::to_string(points.size()) + " numbers for positions of points; must be three a point");
    }
    RequireUsable(points, "point");
    const Box box = BoundingBox(points);
    Frame frame = kCoordinateAxes;
    if (kind != BoxKind::AxisAligned) {
        const PrincipalAxes principal = FindPrincipalAxes(points, box);
        frame =
            kind == BoxKind::Oriented ? OrientedFrame(points, principal, box) : LeastBox(points, principal, box).Find();
        frame = NearestToCoordinates(frame);
    }
    const Vec3 low{box.low[0], box.low[1], box.low[2]};
    const std::vector<Extremes> reach = FindExtremes(points, low, frame);
    OrientedBox made{.corner = box.low, .axes = {}, .lengths = {}};
    for (std::size_t k = 0; k < 3; ++k) {
        made.axes[k] = {frame[k].x, frame[k].y, frame[k].z};
        made.lengths[k] = reach[k].greatest - reach[k].least;
    }
    made.corner = made.At({reach[0].least, reach[1].least, reach[2].least});
    return made;
}

}  // namespace SolidSubdiv::Geometry
