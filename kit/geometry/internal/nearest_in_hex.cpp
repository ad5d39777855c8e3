// SPDX-License-Identifier: Apache-2.0
// Descent and bounds in turns; see the header.
#include <solidsubdiv/kit/geometry/internal/nearest_in_hex.h>

#include <solidsubdiv/kit/geometry/internal/descend.h>

#include <limits>
#include <tuple>
#include <vector>

namespace SolidSubdiv::Geometry::Internal {

namespace {

/// At least so far from the origin, along `direction`, lies the hull of the corners; 0 where it can't be told.
/// `nearest` is the corner that comes nearest.
double DistanceAlong(const Trilinear& map, const Vec3& direction, Vec3* nearest = nullptr) {
    const double length = Length(direction);
    double least = std::numeric_limits<double>::infinity(), greatest = -least;
    for (const Vec3& c : map.corners) {
        const double d = Dot(direction, c);
        if (nearest != nullptr && d < least) *nearest = c;
        least = std::min(least, d);
        greatest = std::max(greatest, d);
    }
    return length > 0 ? std::max({0.0, least / length, -greatest / length}) : 0;
}

/// At least so far from the origin is the whole part along the normals of its faces, which decide where it is almost a
/// parallelepiped; looks no further once that is more than `reach`.
double BoundAlongNormals(const Trilinear& map, double reach) {
    const auto c = map.Jacobian({0.5, 0.5, 0.5});
    double bound = 0;
    for (std::size_t k = 0; k < 3 && bound <= reach; ++k) {
        bound = std::max(bound, DistanceAlong(map, Cross(c[(k + 1) % 3], c[(k + 2) % 3])));
    }
    return bound;
}

/// The same along `towards` too, and then as far as the corners tell at all.
double LowerBound(const Trilinear& map, double reach, const Vec3& towards) {
    double bound = std::max(BoundAlongNormals(map, reach), DistanceAlong(map, towards));
    if (bound > reach) return bound;
    // From the middle to the point of the hull nearest to the origin, a few steps.
    constexpr int kSteps = 6;
    Vec3 at{};
    for (const Vec3& corner : map.corners) at = at + 0.125 * corner;
    for (int i = 0; i < kSteps; ++i) {
        Vec3 corner;
        bound = std::max(bound, DistanceAlong(map, at, &corner));
        const Vec3 way = corner - at;
        const double length = Dot(way, way), share = -Dot(at, way);
        if (bound > reach || !(length > 0 && share > 0)) return bound;
        at = at + std::min(1.0, share / length) * way;
    }
    return bound;
}

struct BoundedPart {
    TrilinearPart part;
    double bound = 0;
    int depth = 0;
};

/// Parts of the least bound come first; of equal ones the order is that of their places.
bool IsLater(const BoundedPart& a, const BoundedPart& b) {
    if (a.bound != b.bound) return a.bound > b.bound;
    const Vec3 &p = a.part.low, &q = b.part.low;
    return std::tie(p.x, p.y, p.z, a.depth) > std::tie(q.x, q.y, q.z, b.depth);
}

class Search {
  public:
    /// Looks for a place within `enough`, or for the nearest where `wants_nearest`.
    Search(const Trilinear& hex, double enough, bool wants_nearest)
        : hex_(hex), enough_(enough), wants_nearest_(wants_nearest) {}

    Nearest Run() {
        BoundedPart next{{.map = hex_}};
        next.bound = BoundAlongNormals(hex_, Reach());
        for (int n_parts = 1; next.bound <= Reach(); ++n_parts) {
            if (next.depth % 3 == 0) DescendFrom(next.part.Middle());
            if (best_.distance <= enough_ || n_parts > kMostParts) break;
            for (const TrilinearPart& half : next.part.Halves()) {
                const double bound = std::max(next.bound, LowerBound(half.map, Reach(), point_));
                if (bound > Reach()) continue;
                heap_.push_back({half, bound, next.depth + 1});
                std::push_heap(heap_.begin(), heap_.end(), IsLater);
            }
            if (heap_.empty()) break;
            std::pop_heap(heap_.begin(), heap_.end(), IsLater);
            next = heap_.back();
            heap_.pop_back();
        }
        return best_;
    }

  private:
    static constexpr double kGap = 1e-6;
    // Reached only in cells that are folded several times, by points that are almost as far from many places: what is
    // left open then is little, since parts are taken by their bounds.
    static constexpr int kMostParts = 20000;

    /// What is beyond is of no interest.
    double Reach() const { return wants_nearest_ ? best_.distance * (1 - kGap) - enough_ : enough_; }

    void DescendFrom(const Vec3& start) {
        const Nearest found = Descend(hex_, start, enough_ / 16);
        if (!(found.distance < best_.distance)) return;
        best_ = found;
        point_ = hex_.PointOf(found.at);
    }

    const Trilinear& hex_;
    double enough_;
    bool wants_nearest_;
    Nearest best_;
    Vec3 point_{};  // of best_
    std::vector<BoundedPart> heap_;
};

}  // namespace

Nearest NearestInHex(const Trilinear& hex, double round_off, double limit) {
    if (LowerBound(hex, limit, {}) > limit) return {};
    return Search(hex, round_off, true).Run();
}

Nearest HoldInHex(const Trilinear& hex, double reach) { return Search(hex, reach, false).Run(); }

}  // namespace SolidSubdiv::Geometry::Internal
