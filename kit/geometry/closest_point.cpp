// SPDX-License-Identifier: Apache-2.0
// Each point down a hierarchy of the elements' boxes, nearest first.
#include <solidsubdiv/kit/geometry/closest_point.h>

#include <cmath>
#include <limits>
#include <string>

#include <solidsubdiv/kit/geometry/box.h>
#include <solidsubdiv/kit/geometry/internal/box_tree.h>
#include <solidsubdiv/kit/geometry/internal/nearest_in_triangle.h>
#include <solidsubdiv/kit/geometry/internal/usable_positions.h>
#include <solidsubdiv/sdc/errors.h>
#include <solidsubdiv/sdc/parallel.h>

namespace SolidSubdiv::Geometry {

using namespace Internal;

struct ClosestPoints::State {
    std::span<const double> positions;
    std::span<const Index> triangles;
    Vec3 middle{};
    double scale = 1;  ///< moved by -middle and multiplied by it, everything lies within [-1, 1]^3
    BoxTree tree{};

    Index CountElements() const {
        return static_cast<Index>(triangles.empty() ? positions.size() : triangles.size()) / 3;
    }
    std::array<double, 3> Scaled(const Vec3& p) const {
        return {scale * (p.x - middle.x), scale * (p.y - middle.y), scale * (p.z - middle.z)};
    }
    std::array<Index, 3> Corners(Index element) const {
        if (triangles.empty()) return {element, element, element};
        const Index* const t = &triangles[3 * static_cast<std::size_t>(element)];
        return {t[0], t[1], t[2]};
    }

    FloatBox BoxOf(Index element) const {
        // What rounding to floats may take away.
        constexpr float kReach = 1e-6f;
        FloatBox box;
        std::fill_n(box.low, 3, std::numeric_limits<float>::infinity());
        std::fill_n(box.high, 3, -std::numeric_limits<float>::infinity());
        for (Index v : Corners(element)) {
            const auto p = Scaled(PointAt(positions, v));
            for (std::size_t k = 0; k < 3; ++k) {
                box.low[k] = std::min(box.low[k], static_cast<float>(p[k]) - kReach);
                box.high[k] = std::max(box.high[k], static_cast<float>(p[k]) + kReach);
            }
        }
        return box;
    }

    ClosestPoint Find(const Vec3& point) const {
        ClosestPoint best;
        double least = std::numeric_limits<double>::infinity();
        tree.ForEachNear(Scaled(point), 0, [&](Index element) {
            const auto corners = Corners(element);
            const Vec3 a = PointAt(positions, corners[0]) - point;
            std::array<double, 2> w{0, 0};
            Vec3 nearest = a;
            if (!triangles.empty()) {
                const Vec3 b = PointAt(positions, corners[1]) - point, c = PointAt(positions, corners[2]) - point;
                w = NearestInTriangle(a, b, c);
                nearest = (1 - w[0] - w[1]) * a + w[0] * b + w[1] * c;
            }
            const double square = Dot(nearest, nearest);
            // The lowest of those as near: the order of the boxes does not matter.
            if (square < least || (square == least && element < best.element)) {
                least = square;
                best.element = element;
                best.weights = {1 - w[0] - w[1], w[0], w[1]};
                best.position = {point.x + nearest.x, point.y + nearest.y, point.z + nearest.z};
            }
            return scale * std::sqrt(least);
        });
        best.distance = std::sqrt(least);
        return best;
    }
};

ClosestPoints::ClosestPoints(std::span<const double> positions, std::span<const Index> triangles)
    : state_(std::make_unique<State>(State{.positions = positions, .triangles = triangles})) {
    if (positions.size() < 3) throw InvalidInput("there is no point to be near to");
    RequireUsable(positions, "point");
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        if (triangles[i] < 0 || static_cast<std::size_t>(triangles[i]) >= positions.size() / 3) {
            throw InvalidInput("triangle " + std::to_string(i / 3) + " names point " + std::to_string(triangles[i]) +
                               "; there are " + std::to_string(positions.size() / 3));
        }
    }
    const Box box = BoundingBox(positions);
    State& s = *state_;
    s.middle = {0.5 * (box.low[0] + box.high[0]), 0.5 * (box.low[1] + box.high[1]), 0.5 * (box.low[2] + box.high[2])};
    s.scale = 2 / std::max({box.Extent(0), box.Extent(1), box.Extent(2), 1e-75});
    std::vector<FloatBox> boxes(static_cast<std::size_t>(s.CountElements()));
    Sdc::ParallelFor(s.CountElements(), 1024, [&](Offset begin, Offset end) {
        for (Offset e = begin; e < end; ++e) boxes[static_cast<std::size_t>(e)] = s.BoxOf(static_cast<Index>(e));
    });
    s.tree = BoxTree(boxes);
}

ClosestPoints::~ClosestPoints() = default;
ClosestPoints::ClosestPoints(ClosestPoints&&) noexcept = default;
ClosestPoints& ClosestPoints::operator=(ClosestPoints&&) noexcept = default;

std::vector<ClosestPoint> ClosestPoints::Find(std::span<const double> points) const {
    RequireUsable(points, "point");
    std::vector<ClosestPoint> found(points.size() / 3);
    Sdc::ParallelFor(static_cast<Offset>(found.size()), 64, [&](Offset begin, Offset end) {
        for (Offset i = begin; i < end; ++i) {
            found[static_cast<std::size_t>(i)] = state_->Find(PointAt(points, static_cast<Index>(i)));
        }
    });
    return found;
}

}  // namespace SolidSubdiv::Geometry
