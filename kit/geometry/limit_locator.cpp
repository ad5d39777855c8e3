// SPDX-License-Identifier: Apache-2.0
// All points take their steps together, so that limit rows are made for many places at a time.
#include <solidsubdiv/kit/geometry/limit_locator.h>

#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include <solidsubdiv/kit/geometry/box.h>
#include <solidsubdiv/kit/geometry/internal/descend.h>

namespace SolidSubdiv::Geometry {

namespace {

using Internal::Vec3;

/// Sum of a row's weights times positions.
Vec3 PointOf(std::span<const Index> indices, const double* weights, std::span<const double> positions) {
    Vec3 point{};
    for (std::size_t k = 0; k < indices.size(); ++k) {
        const double* p = positions.data() + 3 * static_cast<std::size_t>(indices[k]);
        point = point + weights[k] * Vec3{p[0], p[1], p[2]};
    }
    return point;
}

std::vector<double> PointsOf(const Far::StencilRows<double>& rows, std::span<const double> positions) {
    std::vector<double> points;
    points.reserve(3 * static_cast<std::size_t>(rows.n_rows()));
    for (Index i = 0; i < rows.n_rows(); ++i) {
        const Vec3 p = PointOf(rows.Indices(i), rows.Weights(i).data(), positions);
        points.insert(points.end(), {p.x, p.y, p.z});
    }
    return points;
}

/// A point on its way.
struct Search {
    Far::Place place, best;  ///< to look at next, and where the limit was nearest
    double distance = std::numeric_limits<double>::infinity();
    Vec3 missing{}, move{};  ///< at the best place: from its limit to the point, and Newton's step
    int n_tries = 0;         ///< since then
    bool is_second = false;  ///< whether it has been stuck before, and where
    Far::Place stuck_at{};
    double stuck_distance = std::numeric_limits<double>::infinity();

    /// Whole steps, then halves of them; each is tried as it leads, and if it leads out of the cell within it as well.
    double Factor() const { return std::ldexp(1.0, -n_tries / 2); }
    bool StaysInCell() const { return n_tries % 2 == 1; }
};

constexpr int kMostTries = 16;

Vec3 At(std::span<const double> points, std::size_t i) { return {points[3 * i], points[3 * i + 1], points[3 * i + 2]}; }

}  // namespace

void LimitLocateOptions::Validate() const {
    if (!(tolerance >= 0) || std::isinf(tolerance)) {
        throw InvalidInput("tolerance is " + std::to_string(tolerance) + "; it must be 0 or more, and finite");
    }
    if (max_steps < 1 || max_steps > 1000) {
        throw InvalidInput("max_steps is " + std::to_string(max_steps) + "; it must be 1 to 1000");
    }
}

struct LimitLocator::State {
    State(const Far::TopologyRefiner& r, const Sdc::Scheme& scheme, int l, std::span<const double> p)
        : refiner(r),
          level(l),
          positions(p.begin(), p.end()),
          factory(r, scheme, {.level = l, .order = 1}),
          limits(LimitsOfVertices(scheme)),
          start(r, l, limits) {}

    std::vector<double> LimitsOfVertices(const Sdc::Scheme& scheme) const {
        const auto table = Far::LimitStencilTable::Create(refiner, scheme, {.level = level});
        if (positions.size() != 3 * static_cast<std::size_t>(table.rows().n_rows())) {
            throw InvalidInput(std::to_string(positions.size()) + " coordinates are given for the " +
                               std::to_string(table.rows().n_rows()) + " vertices of level " + std::to_string(level));
        }
        std::vector<double> points = PointsOf(table.rows(), positions);
        for (Index v : table.without_limit()) {  // no more than a start
            for (std::size_t c = 0; c < 3; ++c) {
                points[3 * static_cast<std::size_t>(v) + c] = positions[3 * static_cast<std::size_t>(v) + c];
            }
        }
        return points;
    }

    /// Whether coordinates are within their ranges (place.h), with what rounding does to them.
    bool IsInside(const Far::Place& place) const {
        constexpr double kSlack = 1e-12;
        const auto [u, v, w] = place.at;
        if (refiner.is_polyhedral() && refiner.polyhedral_level(level).IsHex(place.element)) {
            return std::min({u, v, w, 1 - u, 1 - v, 1 - w}) >= -kSlack;
        }
        if (!refiner.is_polyhedral() && place.element >= refiner.level(level).n_tets) {
            return std::abs(u) + std::abs(v) + std::abs(w) <= 1 + kSlack;
        }
        return std::min({u, v, w, 1 - u - v - w}) >= -kSlack;
    }

    std::array<double, 3> MiddleOf(Index cell) const {
        const bool is_oct = !refiner.is_polyhedral() && cell >= refiner.level(level).n_tets;
        const bool is_hex = refiner.is_polyhedral() && refiner.polyhedral_level(level).IsHex(cell);
        const double x = is_oct ? 0 : is_hex ? 0.5 : 0.25;
        return {x, x, x};
    }

    /// Moves coordinates into their ranges.
    void Clamp(Far::Place& place) const {
        auto& [u, v, w] = place.at;
        if (refiner.is_polyhedral() && refiner.polyhedral_level(level).IsHex(place.element)) {
            for (double& x : place.at) x = std::clamp(x, 0.0, 1.0);
            return;
        }
        const bool is_oct = !refiner.is_polyhedral() && place.element >= refiner.level(level).n_tets;
        for (double& x : place.at) x = is_oct ? x : std::max(x, 0.0);
        const double sum = std::abs(u) + std::abs(v) + std::abs(w);
        for (double& x : place.at) x /= std::max(sum, 1.0);
    }

    /// The limit at a place that was asked for: a step nearer, or not.
    void Look(const Far::LimitStencilTable& table, Index row, const Vec3& point, Search& search) const {
        const auto indices = table.rows().Indices(row);
        ++search.n_tries;
        if (indices.empty()) return;
        const Vec3 missing = point - PointOf(indices, table.rows().Weights(row).data(), positions);
        if (!(Length(missing) < search.distance)) return;
        const Offset first = table.rows().offsets[row];
        std::array<Vec3, 3> columns;
        for (int a = 0; a < 3; ++a) {
            columns[static_cast<std::size_t>(a)] =
                PointOf(indices, table.DerivativeWeights(a).data() + first, positions);
        }
        search.best = search.place;
        search.distance = Length(missing);
        search.missing = missing;
        search.move = Internal::SolveColumns(columns, missing);
        search.n_tries = 0;
    }

    const Far::TopologyRefiner& refiner;
    const int level;
    const std::vector<double> positions;
    Far::LimitStencilTableFactory factory;
    const std::vector<double> limits;  // of the level's vertices
    const Locator start;
};

LimitLocator::LimitLocator(const Far::TopologyRefiner& refiner, const Sdc::Scheme& scheme, int level,
                           std::span<const double> positions)
    : state_(std::make_unique<State>(refiner, scheme, level, positions)) {}
LimitLocator::~LimitLocator() = default;
LimitLocator::LimitLocator(LimitLocator&&) noexcept = default;
LimitLocator& LimitLocator::operator=(LimitLocator&&) noexcept = default;

Location LimitLocator::Locate(std::span<const double> points, const LimitLocateOptions& options) {
    options.Validate();
    const State& s = *state_;
    const double tolerance = options.tolerance > 0 ? options.tolerance : 1e-12 * BoundingBox(s.positions).Diagonal();
    const std::size_t n = points.size() / 3;
    std::vector<Search> searches(n);
    const Location started = s.start.Locate(points);
    for (std::size_t i = 0; i < n; ++i) searches[i].place = searches[i].best = started.places[i];
    std::vector<std::size_t> active(n);
    std::iota(active.begin(), active.end(), std::size_t{0});
    for (int step = 0; step < options.max_steps && !active.empty(); ++step) {
        Report(options.progress, "locate in the limit",
               1 - static_cast<double>(active.size()) / static_cast<double>(n));
        std::vector<Far::Place> asked;
        for (std::size_t i : active) asked.push_back(searches[i].place);
        const Far::LimitStencilTable table = state_->factory.Create(asked);

        std::vector<std::size_t> still_active, to_start;
        std::vector<Far::Place> beyond;  // of those to start again, the place aimed at, outside its cell
        for (std::size_t k = 0; k < active.size(); ++k) {
            const std::size_t i = active[k];
            Search& search = searches[i];
            s.Look(table, static_cast<Index>(k), At(points, i), search);
            if (search.distance <= tolerance) continue;
            if (search.n_tries >= kMostTries) {
                // Stuck, as where cells are nearly flat: once more, from the middle of the cell.
                if (std::exchange(search.is_second, true)) continue;
                search.place.element = search.best.element;
                search.place.part = search.best.part;
                search.place.at = s.MiddleOf(search.place.element);
                search.stuck_at = search.best;
                search.stuck_distance = std::exchange(search.distance, std::numeric_limits<double>::infinity());
                search.n_tries = 0;
                still_active.push_back(i);
                continue;
            }
            still_active.push_back(i);
            search.place = search.best;
            const bool has_step = std::isfinite(search.move.x + search.move.y + search.move.z);
            const Vec3 move = search.Factor() * (has_step ? search.move : Vec3{});
            search.place.at[0] += move.x;
            search.place.at[1] += move.y;
            search.place.at[2] += move.z;
            if (has_step && s.IsInside(search.place)) continue;
            if (has_step && search.StaysInCell()) {
                s.Clamp(search.place);
                continue;
            }
            to_start.push_back(i);
            beyond.push_back(search.place);
        }
        // Cells beyond: where the level's cells, laid out linearly, have the place aimed at; without a step, what is
        // missing is added.
        const auto rows = Far::MakePlaceRows(s.refiner, s.level, beyond);
        std::vector<double> aims = PointsOf(rows, s.limits);
        for (std::size_t k = 0; k < to_start.size(); ++k) {
            const Search& search = searches[to_start[k]];
            if (std::isfinite(search.move.x + search.move.y + search.move.z)) continue;
            aims[3 * k] += search.Factor() * search.missing.x;
            aims[3 * k + 1] += search.Factor() * search.missing.y;
            aims[3 * k + 2] += search.Factor() * search.missing.z;
        }
        const Location again = s.start.Locate(aims);
        for (std::size_t k = 0; k < to_start.size(); ++k) searches[to_start[k]].place = again.places[k];
        active = std::move(still_active);
    }
    Report(options.progress, "locate in the limit", 1);
    Location result;
    for (std::size_t i = 0; i < n; ++i) {
        const Search& search = searches[i];
        const bool was_nearer = search.stuck_distance < search.distance;
        const double distance = was_nearer ? search.stuck_distance : search.distance;
        result.places.push_back(was_nearer ? search.stuck_at : search.best);
        if (!(distance <= tolerance)) result.outside.push_back({static_cast<Index>(i), distance});
    }
    return result;
}

}  // namespace SolidSubdiv::Geometry
