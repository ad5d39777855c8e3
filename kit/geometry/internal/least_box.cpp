// SPDX-License-Identifier: Apache-2.0
// Many starts, turns to least rectangles, and points that join in.
#include <solidsubdiv/kit/geometry/internal/least_box.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include <solidsubdiv/kit/geometry/internal/least_rectangle.h>
#include <solidsubdiv/sdc/parallel.h>

namespace SolidSubdiv::Geometry::Internal {

namespace {

constexpr double kLess = 1 - 1e-12;  // smaller by less than this is smaller by rounding
constexpr int kMostRounds = 100;     // every round makes the box smaller: few do, this is for rounding's sake
constexpr int kMostJoins = 12;       // a circle's points would join for ever
constexpr int kMostFinalists = 8;

/// Directions to the places of a grid on the surface of a cube, one of each opposite pair.
std::vector<Vec3> GridDirections() {
    constexpr int kSteps = 3;
    std::vector<Vec3> directions;
    for (int x = -kSteps; x <= kSteps; ++x) {
        for (int y = -kSteps; y <= kSteps; ++y) {
            for (int z = -kSteps; z <= kSteps; ++z) {
                const bool is_first = x > 0 || (x == 0 && (y > 0 || (y == 0 && z > 0)));
                if (is_first && std::gcd(std::gcd(x, y), z) == 1) directions.push_back({1. * x, 1. * y, 1. * z});
            }
        }
    }
    return directions;
}

/// A frame turned about its axes one after another, by all combinations of up to n steps of an angle (in degrees)
/// either way: the same set whichever way the axes point.
std::vector<Frame> TurnsOf(const Frame& frame, double angle, int n) {
    const auto turn = [&](const Frame& f, std::size_t axis, int step) {
        const double radians = step * angle / 180 * std::numbers::pi;
        return TurnAbout(f, axis, std::cos(radians), std::sin(radians));
    };
    std::vector<Frame> frames;
    for (int i = -n; i <= n; ++i) {
        for (int j = -n; j <= n; ++j) {
            for (int k = -n; k <= n; ++k) frames.push_back(turn(turn(turn(frame, 0, i), 1, j), 2, k));
        }
    }
    return frames;
}

/// What many turns have lost by rounding.
Frame Orthonormal(Frame f) {
    f[0] = (1 / Length(f[0])) * f[0];
    f[1] = f[1] - Dot(f[0], f[1]) * f[0];
    f[1] = (1 / Length(f[1])) * f[1];
    f[2] = Cross(f[0], f[1]);
    return f;
}

}  // namespace

LeastBox::LeastBox(std::span<const double> points, const PrincipalAxes& principal, const Box& box)
    : points_(points), principal_(principal.axes), origin_{box.low[0], box.low[1], box.low[2]} {
    const double diagonal = box.Diagonal();
    least_length_ = 1e-10 * diagonal;
    if (!(diagonal > 0)) {
        few_.assign(points.begin(), points.begin() + 3);
        return;
    }
    // Directions are stretched as the points are, so that points of a needle do not crowd at its ends.
    const std::vector<Extremes> reach = FindExtremes(points_, origin_, principal_);
    std::array<Vec3, 3> scaled;
    for (std::size_t k = 0; k < 3; ++k) {
        scaled[k] = 1 / std::max(reach[k].greatest - reach[k].least, 1e-3 * diagonal) * principal_[k];
    }
    std::vector<Vec3> directions = GridDirections();
    for (Vec3& d : directions) d = d.x * scaled[0] + d.y * scaled[1] + d.z * scaled[2];
    Join(FindExtremes(points_, origin_, directions));
}

void LeastBox::Join(std::span<const Extremes> extremes) {
    std::vector<std::array<double, 3>> all(few_.size() / 3);
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = {few_[3 * i], few_[3 * i + 1], few_[3 * i + 2]};
    for (const Extremes& e : extremes) {
        for (const Vec3& p : {e.at_least, e.at_greatest}) all.push_back({p.x, p.y, p.z});
    }
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    few_.clear();
    for (const auto& p : all) few_.insert(few_.end(), p.begin(), p.end());
}

double LeastBox::VolumeOf(std::span<const Extremes> reach) const {
    double volume = 1;
    for (const Extremes& e : reach) volume *= std::max(e.greatest - e.least, least_length_);
    return volume;
}

double LeastBox::VolumeAmongFew(const Frame& frame) const { return VolumeOf(FindExtremes(few_, origin_, frame)); }

Frame LeastBox::TurnAmongFew(Frame frame, std::array<bool, 3> axes) const {
    double volume = VolumeAmongFew(frame);
    std::vector<Point2> seen(few_.size() / 3);
    for (int round = 0; round < kMostRounds; ++round) {
        const double before = volume;
        for (std::size_t k = 0; k < 3; ++k) {
            if (!axes[k]) continue;
            for (std::size_t i = 0; i < seen.size(); ++i) {
                const Vec3 p = PointAt(few_, static_cast<Index>(i)) - origin_;
                seen[i] = {Dot(frame[(k + 1) % 3], p), Dot(frame[(k + 2) % 3], p)};
            }
            const Rectangle least = LeastRectangle(seen, least_length_);
            const Frame turned = Orthonormal(TurnAbout(frame, k, least.direction[0], least.direction[1]));
            const double its_volume = VolumeAmongFew(turned);
            if (!(its_volume < kLess * volume)) continue;
            frame = turned;
            volume = its_volume;
        }
        if (!(volume < before)) break;
    }
    return frame;
}

Frame LeastBox::Turn(Frame frame, std::array<bool, 3> axes) {
    Frame least = frame;
    double volume = VolumeOf(FindExtremes(points_, origin_, frame));
    for (int round = 0; round < kMostJoins; ++round) {
        frame = TurnAmongFew(frame, axes);
        const std::vector<Extremes> reach = FindExtremes(points_, origin_, frame);
        const double its_volume = VolumeOf(reach);
        if (its_volume < kLess * volume) {
            least = frame;
            volume = its_volume;
        }
        if (VolumeAmongFew(frame) >= kLess * its_volume) break;  // the few reach as far as all
        Join(reach);
    }
    return least;
}

void LeastBox::Try(const Frame& frame, Candidate& least) const {
    const double volume = VolumeOf(FindExtremes(points_, origin_, frame));
    if (volume < kLess * least.volume) least = {frame, volume};
}

void LeastBox::TryTurns(std::vector<Frame> frames, Candidate& least) {
    Sdc::ParallelFor(static_cast<Offset>(frames.size()), 1, [&](Offset begin, Offset end) {
        for (Offset i = begin; i < end; ++i) {
            Frame& frame = frames[static_cast<std::size_t>(i)];
            frame = TurnAmongFew(frame, {true, true, true});
        }
    });
    // The most promising first; with what has joined in meanwhile. What is no less among few is not among all.
    for (int i = 0; i < kMostFinalists; ++i) {
        std::vector<double> promises(frames.size());
        std::transform(frames.begin(), frames.end(), promises.begin(),
                       [&](const Frame& frame) { return VolumeAmongFew(frame); });
        const auto best = std::min_element(promises.begin(), promises.end());
        if (*best >= (1 - 1e-9) * least.volume) return;
        Frame& frame = frames[static_cast<std::size_t>(best - promises.begin())];
        frame = Turn(frame, {true, true, true});
        Try(frame, least);
    }
}

Frame LeastBox::Find() {
    Candidate least;
    Try(kCoordinateAxes, least);
    Try(principal_, least);
    TryTurns(TurnsOf(principal_, 18, 2), least);  // a quarter turn is five steps
    // Round shapes have many boxes of nearly the same volume near each other.
    for (double angle : {6., 2., .6}) TryTurns(TurnsOf(least.frame, angle, 1), least);
    return Turn(least.frame, {true, true, true});
}

}  // namespace SolidSubdiv::Geometry::Internal
