// SPDX-License-Identifier: Apache-2.0
// Descent and bounds in turns; see the header.
#include <solidsubdiv/kit/geometry/internal/nearest_in_hex.h>

#include <solidsubdiv/kit/geometry/internal/descend.h>

namespace SolidSubdiv::Geometry::Internal {

namespace {

/// At least so far from the origin, along `direction`, lies the hull of the corners; 0 where it can't be told.
double DistanceAlong(const Trilinear& map, const Vec3& direction) {
    const double length = Length(direction);
    double least = std::numeric_limits<double>::infinity(), greatest = -least;
    for (const Vec3& c : map.corners) {
        const double d = Dot(direction, c);
        least = std::min(least, d);
        greatest = std::max(greatest, d);
    }
    return length > 0 ? std::max({0.0, least / length, -greatest / length}) : 0;
}

/// Whether the whole part is further than `reach` from the origin, as far as its corners tell. `towards`: a direction
/// in which it may be so.
bool IsBeyond(const Trilinear& map, double reach, const Vec3& towards) {
    const auto c = map.Jacobian({0.5, 0.5, 0.5});
    // Of an almost parallelepipedal part these decide: they are the normals of its faces.
    for (const Vec3& normal : {Cross(c[1], c[2]), Cross(c[2], c[0]), Cross(c[0], c[1])}) {
        if (DistanceAlong(map, normal) > reach) return true;
    }
    Vec3 middle{};
    for (const Vec3& corner : map.corners) middle = middle + 0.125 * corner;
    for (const Vec3& direction : {towards, middle, Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}) {
        if (DistanceAlong(map, direction) > reach) return true;
    }
    return false;
}

class Search {
  public:
    /// Looks for a place within `enough`, or for the nearest where `wants_nearest`.
    Search(const Trilinear& hex, double enough, bool wants_nearest)
        : hex_(hex), enough_(enough), wants_nearest_(wants_nearest) {}

    Nearest Run() {
        Visit({.map = hex_});
        return best_;
    }

  private:
    // A part is at most this often halved along an axis, and a cell has at most so many parts: reached only by points
    // that lie within round-off of a fold, where what was found is as good as what is left.
    static constexpr double kGap = 1e-6;
    static constexpr double kLeastSize = 0x1p-40;
    static constexpr int kMostParts = 20000;

    void Visit(const TrilinearPart& part) {
        const double reach = wants_nearest_ ? best_.distance * (1 - kGap) - enough_ : enough_;
        if (IsDone() || ++n_parts_ > kMostParts || IsBeyond(part.map, reach, point_)) return;
        const Nearest found = Descend(hex_, part.Middle(), enough_ / 16);
        if (found.distance < best_.distance) {
            best_ = found;
            point_ = hex_.PointOf(found.at);
        }
        if (IsDone() || std::min({part.size.x, part.size.y, part.size.z}) < kLeastSize) return;
        for (const TrilinearPart& half : part.Halves()) Visit(half);
    }
    bool IsDone() const { return best_.distance <= enough_; }

    const Trilinear& hex_;
    double enough_;
    bool wants_nearest_;
    Nearest best_;
    Vec3 point_{};  // of best_
    int n_parts_ = 0;
};

}  // namespace

Nearest NearestInHex(const Trilinear& hex, double round_off, double limit) {
    if (IsBeyond(hex, limit, {})) return {};
    return Search(hex, round_off, true).Run();
}

Nearest HoldInHex(const Trilinear& hex, double reach) { return Search(hex, reach, false).Run(); }

}  // namespace SolidSubdiv::Geometry::Internal
