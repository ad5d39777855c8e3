// SPDX-License-Identifier: Apache-2.0
// Points in the order of a curve, each down a hierarchy of the cells' boxes.
#include <solidsubdiv/kit/geometry/locator.h>

#include <solidsubdiv/kit/geometry/internal/box_tree.h>
#include <solidsubdiv/kit/geometry/internal/cell_places.h>
#include <solidsubdiv/kit/geometry/internal/curve_order.h>
#include <solidsubdiv/kit/geometry/internal/usable_positions.h>
#include <solidsubdiv/sdc/parallel.h>

#include <string>

namespace SolidSubdiv::Geometry {

using namespace Internal;

namespace {

constexpr Offset kGrain = 1024, kOutsideGrain = 16, kAtATime = 16;
constexpr Offset kBlock = Offset{1} << 20;  // between two reports of progress

/// Keeps the order of numbers. What lies far beyond the cells is as good as what lies beyond them.
float ToFloat(double x) { return static_cast<float>(std::clamp(x, -4.0, 4.0)); }

}  // namespace

void LocateOptions::Validate() const {
    if (!(tolerance >= 0 && tolerance <= kLargestCoordinate)) {
        throw InvalidInput("tolerance is " + std::to_string(tolerance) + "; must be 0 or more, at most 1e75");
    }
}

struct Locator::State {
    CellPlaces cells;
    BoxTree tree{};
    Vec3 middle{};
    double scale = 1;  ///< a power of 2: moved by -middle and multiplied by it, all cells lie within [-1, 1]^3
    double round_off = 0;

    std::array<double, 3> Scaled(const Vec3& p) const {
        return {scale * (p.x - middle.x), scale * (p.y - middle.y), scale * (p.z - middle.z)};
    }

    BoxTree::Point Rounded(const Vec3& point) const {
        const auto p = Scaled(point);
        return {ToFloat(p[0]), ToFloat(p[1]), ToFloat(p[2])};
    }

    void MeasureVertices(std::span<const double> positions) {
        double low[3], high[3], largest = 0;
        std::fill_n(low, 3, std::numeric_limits<double>::infinity());
        std::fill_n(high, 3, -low[0]);
        for (std::size_t i = 0; i < positions.size(); ++i) {
            low[i % 3] = std::min(low[i % 3], positions[i]);
            high[i % 3] = std::max(high[i % 3], positions[i]);
            largest = std::max(largest, std::abs(positions[i]));
        }
        middle = {0.5 * (low[0] + high[0]), 0.5 * (low[1] + high[1]), 0.5 * (low[2] + high[2])};
        const double half =
            0.5 * std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2], 1 / kLargestCoordinate});
        scale = std::exp2(-std::ceil(std::log2(half)));
        round_off = 64 * std::numeric_limits<double>::epsilon() * largest;
    }

    /// Boxes that hold what a tolerance of round_off gives to the cells. Rounding to float keeps the order of numbers,
    /// so a point within the bounds stays there when both are rounded.
    void MakeTree(std::span<const double> positions) {
        Array<FloatBox> boxes(static_cast<std::size_t>(cells.n_cells()));
        const double reach = 2 * scale * round_off;
        Sdc::ParallelFor(cells.n_cells(), kGrain, [&](Offset begin, Offset end) {
            for (Offset c = begin; c < end; ++c) {
                double low[3], high[3];
                std::fill_n(low, 3, std::numeric_limits<double>::infinity());
                std::fill_n(high, 3, -low[0]);
                for (Index v : cells.Vertices(static_cast<Index>(c))) {
                    const auto p = Scaled(PointAt(positions, v));
                    for (std::size_t k = 0; k < 3; ++k)
                        low[k] = std::min(low[k], p[k]), high[k] = std::max(high[k], p[k]);
                }
                FloatBox& box = boxes[static_cast<std::size_t>(c)];
                for (std::size_t k = 0; k < 3; ++k) {
                    box.low[k] = ToFloat(low[k] - reach);
                    box.high[k] = ToFloat(high[k] + reach);
                }
            }
        });
        tree = BoxTree(boxes);
    }

    struct Candidate {
        Index point, cell;
    };

    /// For each of a few points, kAtATime at most, the place in the lowest cell that holds it by round-off. One step
    /// after another for all of them: what the next step reads is on its way from memory meanwhile. `candidates` is
    /// room to work in.
    void FindHolders(std::span<const Index> numbers, std::span<const double> points, Far::Place* places,
                     std::vector<Candidate>& candidates) const {
        const double reach = scale * round_off;
        candidates.clear();
        std::array<BoxTree::Point, kAtATime> rounded;
        for (std::size_t k = 0; k < numbers.size(); ++k) {
            places[numbers[k]].element = kNoIndex;
            rounded[k] = Rounded(PointAt(points, numbers[k]));
        }
        tree.ForEachHolding(std::span(rounded).first(numbers.size()), [&](std::size_t k, Index cell) {
            candidates.push_back({numbers[k], cell});
            cells.FetchIndices(cell);
        });
        for (const Candidate& c : candidates) cells.FetchPositions(c.cell);
        for (const Candidate& c : candidates) {
            Far::Place& best = places[c.point];
            if (best.element != kNoIndex && c.cell > best.element) continue;
            const CellPlace found = cells.Hold(c.cell, PointAt(points, c.point), scale, reach);
            if (found.distance <= reach) best = found.place;
        }
    }

    /// The nearest place, in the lowest cell where distances are equal.
    CellPlace FindNearest(const Vec3& point) const {
        constexpr double kFloatRounding = 0x1p-22;  // of a box's coordinates, which are at most 1
        CellPlace best{.place = {.element = kNoIndex}};
        tree.ForEachNear(Scaled(point), kFloatRounding, [&](Index cell) {
            const CellPlace found = cells.FindNearest(cell, point, scale, scale * round_off, best.distance);
            const bool is_nearer =
                found.distance < best.distance || (found.distance == best.distance && cell < best.place.element);
            if (is_nearer) best = found;
            return best.distance;
        });
        return best;
    }
};

Locator::Locator(const Far::TopologyRefiner& refiner, int level, std::span<const double> positions) {
    RequirePositionsOfLevel(refiner, level, positions);
    if (refiner.n_cells(level) == 0) throw InvalidInput("there are no cells to locate points in");
    state_ = std::make_unique<State>(State{.cells = CellPlaces(refiner, level, positions)});
    state_->MeasureVertices(positions);
    state_->MakeTree(positions);
}

Locator::~Locator() = default;
Locator::Locator(Locator&&) noexcept = default;
Locator& Locator::operator=(Locator&&) noexcept = default;

double Locator::round_off() const { return state_->round_off; }
Offset Locator::Bytes() const { return state_->tree.Bytes(); }

Location Locator::Locate(std::span<const double> points, const LocateOptions& options) const {
    options.Validate();
    if (points.size() % 3 != 0) throw InvalidInput(std::to_string(points.size()) + " numbers are not rows of 3");
    if (points.size() / 3 > std::numeric_limits<Index>::max()) {
        throw InvalidInput(std::to_string(points.size() / 3) + " points: more than 2^31 - 1 at a time");
    }
    RequireUsable(points, "point");
    const State& s = *state_;
    const auto n = static_cast<Offset>(points.size() / 3);
    std::vector<std::uint32_t> keys(static_cast<std::size_t>(n));
    Sdc::ParallelFor(n, kGrain, [&](Offset begin, Offset end) {
        for (Offset i = begin; i < end; ++i) {
            keys[static_cast<std::size_t>(i)] = CurveKey(s.Rounded(PointAt(points, static_cast<Index>(i))).data());
        }
    });
    // Points that follow each other on the curve meet the same nodes and cells while these are in the caches.
    const std::vector<Index> order = OrderByKey(keys);

    Location location;
    location.places.resize(static_cast<std::size_t>(n));
    for (Offset first = 0; first < n; first += kBlock) {
        Report(options.progress, "locate", static_cast<double>(first) / static_cast<double>(n));
        const auto block = std::span(order).subspan(first, std::min(kBlock, n - first));
        Sdc::ParallelFor(static_cast<Offset>(block.size()), kGrain, [&](Offset begin, Offset end) {
            std::vector<State::Candidate> room;
            for (Offset k = begin; k < end; k += kAtATime) {
                s.FindHolders(block.subspan(k, std::min(kAtATime, end - k)), points, location.places.data(), room);
            }
        });
    }

    std::vector<OutsidePoint> lost;  // along the curve, for the same reason
    for (Index i : order) {
        if (location.places[static_cast<std::size_t>(i)].element == kNoIndex) {
            lost.push_back({i, std::numeric_limits<double>::infinity()});
        }
    }
    const bool must_look = options.wants_nearest || options.tolerance > s.round_off;
    if (must_look) {
        Report(options.progress, "nearest places", 0);
        Sdc::ParallelFor(static_cast<Offset>(lost.size()), kOutsideGrain, [&](Offset begin, Offset end) {
            for (auto k = static_cast<std::size_t>(begin); k < static_cast<std::size_t>(end); ++k) {
                const CellPlace nearest = s.FindNearest(PointAt(points, lost[k].point));
                location.places[static_cast<std::size_t>(lost[k].point)] = nearest.place;
                lost[k].distance = nearest.distance / s.scale;
            }
        });
    }
    for (const OutsidePoint& p : lost) {
        if (!(p.distance <= options.tolerance)) location.outside.push_back(p);
    }
    std::sort(location.outside.begin(), location.outside.end(),
              [](const OutsidePoint& a, const OutsidePoint& b) { return a.point < b.point; });
    return location;
}

}  // namespace SolidSubdiv::Geometry
