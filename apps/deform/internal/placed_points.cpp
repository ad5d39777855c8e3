// SPDX-License-Identifier: Apache-2.0
// Points are located; those outside take the nearest place, and, if cells carry them, its map continued linearly.
#include <solidsubdiv/apps/deform/internal/placed_points.h>

#include <solidsubdiv/apps/deform/internal/vector3.h>
#include <solidsubdiv/far/limit_stencil_table.h>
#include <solidsubdiv/kit/geometry/box.h>
#include <solidsubdiv/kit/geometry/limit_locator.h>
#include <solidsubdiv/kit/geometry/locator.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace SolidSubdiv::Deform::Internal {

namespace {

/// The step in a cell's coordinates to a point that is missed by `missing`; at most `longest` along each.
Vector3 StepTo(const std::array<Vector3, 3>& columns, const Vector3& missing, double longest) {
    Vector3 step = SolveColumns(columns, missing);
    const double largest = std::max({std::abs(step[0]), std::abs(step[1]), std::abs(step[2])});
    if (largest > longest) {
        for (double& x : step) x *= longest / largest;
    }
    return step;
}

/// How many cells of mean size reach as far as points are carried: maps are continued no further. (A flat cell's map
/// would blow up deformations, and rounding.)
double LongestStep(const RefinedLattice& lattice, const EmbedOptions& options) {
    const double cells = options.falloff > 0 ? options.falloff / lattice.mean_edge : 1;
    return std::ldexp(std::max(cells, 1.0), lattice.level());
}

/// How near limits are searched: a tenth of what an undeformed lattice may move points by, unless rounding of large
/// coordinates forbids.
double LimitTolerance(const RefinedLattice& lattice) {
    const double diagonal = Geometry::BoundingBox(lattice.positions).Diagonal();
    double largest = 0;
    for (double x : lattice.positions) largest = std::max(largest, std::abs(x));
    return std::max(1e-13 * diagonal, 256 * std::numeric_limits<double>::epsilon() * largest);
}

/// A point that moves.
struct Moving {
    Index point;
    Far::Place place;
    bool is_continued;  ///< its place's map is continued linearly to it
};

/// Falls from 1 to 0 over [0, falloff], with its first derivative.
double FactorAt(double distance, double falloff) {
    const double t = distance / falloff;
    return t < 1 ? (1 - t * t) * (1 - t * t) : 0;
}

/// Lists what moves and, in `outside`, what no cell holds.
std::vector<Moving> ListMoving(const Geometry::Location& found, const EmbedOptions& options, double mean_edge,
                               std::vector<OutsidePoint>& outside) {
    const double falloff = options.falloff > 0 ? options.falloff : mean_edge;
    std::vector<Moving> moving;
    moving.reserve(found.places.size());
    auto next_outside = found.outside.begin();
    for (std::size_t i = 0; i < found.places.size(); ++i) {
        const Index point = static_cast<Index>(i);
        const bool is_outside = next_outside != found.outside.end() && next_outside->point == point;
        double factor = 1;
        if (is_outside) {
            if (options.outside == Outside::Leave) factor = 0;
            if (options.outside == Outside::Carry) factor = FactorAt(next_outside->distance, falloff);
            outside.push_back({point, next_outside->distance, factor, {}});
            ++next_outside;
        }
        if (factor > 0) moving.push_back({point, found.places[i], is_outside && options.outside == Outside::Carry});
    }
    return moving;
}

void SortByCell(std::vector<InCell>& cells) {
    std::sort(cells.begin(), cells.end(),
              [](const InCell& a, const InCell& b) { return a.cell != b.cell ? a.cell < b.cell : a.point < b.point; });
}

/// Under the tet/oct split every point is in a tet; coordinates beyond their ranges continue its map.
void PlaceInTets(const RefinedLattice& lattice, std::span<const double> points, std::span<const Moving> moving,
                 double longest, PlacedPoints& placed) {
    const Far::Level& level = lattice.refiner.level(lattice.level());
    for (const Moving& m : moving) {
        InCell in{m.place.element, m.point, m.place.at};
        if (m.place.element >= level.n_tets) {
            const auto [u, v, w] = m.place.at;
            in.cell = level.n_tets + 4 * (m.place.element - level.n_tets) + (v < 0) + 2 * (w < 0);
            in.at = {(1 - std::abs(v) - std::abs(w) - u) / 2, std::abs(v), std::abs(w)};
        }
        if (m.is_continued) {
            const std::array<Index, 4> corners = TetCorners(level, in.cell);
            const Vector3 origin = PointAt(lattice.positions, corners[0]);
            std::array<Vector3, 3> columns;
            for (std::size_t k = 0; k < 3; ++k) columns[k] = Minus(PointAt(lattice.positions, corners[k + 1]), origin);
            Vector3 missing = Minus(PointAt(points, m.point), origin);
            for (std::size_t k = 0; k < 3; ++k) {
                for (std::size_t c = 0; c < 3; ++c) missing[c] -= in.at[k] * columns[k][c];
            }
            const Vector3 step = StepTo(columns, missing, longest);
            for (std::size_t k = 0; k < 3; ++k) in.at[k] += step[k];
        }
        placed.in_tets.push_back(in);
    }
    SortByCell(placed.in_tets);
}

/// A row and its derivatives by the three coordinates of its place: the row of the point, continued linearly.
void AppendContinued(std::span<const Index> indices, std::span<const double> weights,
                     const std::array<std::vector<double>, 3>& derivatives, std::span<const double> positions,
                     const Vector3& point, double longest, Far::StencilRows<double>& rows) {
    const Vector3 nearest = WeightedSum(indices, weights, positions);
    std::array<Vector3, 3> columns;
    for (std::size_t k = 0; k < 3; ++k) columns[k] = WeightedSum(indices, derivatives[k], positions);
    const Vector3 step = StepTo(columns, Minus(point, nearest), longest);
    for (std::size_t j = 0; j < indices.size(); ++j) {
        rows.indices.push_back(indices[j]);
        rows.weights.push_back(weights[j] + step[0] * derivatives[0][j] + step[1] * derivatives[1][j] +
                               step[2] * derivatives[2][j]);
    }
    rows.offsets.push_back(static_cast<Offset>(rows.indices.size()));
}

void Append(std::span<const Index> indices, std::span<const double> weights, Far::StencilRows<double>& rows) {
    rows.indices.insert(rows.indices.end(), indices.begin(), indices.end());
    rows.weights.insert(rows.weights.end(), weights.begin(), weights.end());
    rows.offsets.push_back(static_cast<Offset>(rows.indices.size()));
}

/// Under the polyhedral split points in hexahedra keep their coordinates; in other cells they have rows, and so do
/// those that are continued.
void PlaceInPolyhedra(const RefinedLattice& lattice, std::span<const double> points, std::span<const Moving> moving,
                      double longest, PlacedPoints& placed) {
    const Vtr::PolyhedralLevel& level = lattice.refiner.polyhedral_level(lattice.level());
    for (const Moving& m : moving) {
        if (!m.is_continued && level.IsHex(m.place.element)) {
            placed.in_hexes.push_back({m.place.element, m.point, m.place.at});
            continue;
        }
        placed.row_points.push_back(m.point);
        // The map is linear along each coordinate: its derivatives are differences. The row itself comes first.
        std::vector<Far::Place> places{m.place};
        for (std::size_t k = 0; k < 3 && m.is_continued; ++k) {
            for (double x : {0.0, 1.0}) {
                places.push_back(m.place);
                places.back().at[k] = x;
            }
        }
        const auto rows = Far::MakePlaceRows(lattice.refiner, lattice.level(), places);
        if (!m.is_continued) {
            Append(rows.Indices(0), rows.Weights(0), placed.rows);
            continue;
        }
        std::array<std::vector<double>, 3> derivatives;
        for (std::size_t k = 0; k < 3; ++k) {
            const auto zero = rows.Weights(static_cast<Index>(1 + 2 * k)),
                       one = rows.Weights(static_cast<Index>(2 + 2 * k));
            for (std::size_t j = 0; j < zero.size(); ++j) derivatives[k].push_back(one[j] - zero[j]);
        }
        AppendContinued(rows.Indices(0), rows.Weights(0), derivatives, lattice.positions, PointAt(points, m.point),
                        longest, placed.rows);
    }
    SortByCell(placed.in_hexes);
}

/// In the limit all points have rows; where it has no derivatives it is continued by a constant.
void PlaceInLimit(const RefinedLattice& lattice, std::span<const double> points, std::span<const Moving> moving,
                  const EmbedOptions& options, double longest, PlacedPoints& placed) {
    const bool has_continued =
        std::any_of(moving.begin(), moving.end(), [](const Moving& m) { return m.is_continued; });
    Far::LimitStencilTableFactory factory(lattice.refiner, options.scheme,
                                          {.level = lattice.level(), .order = has_continued ? 1 : 0});
    constexpr std::size_t kBatch = 1 << 16;
    for (std::size_t first = 0; first < moving.size(); first += kBatch) {
        const auto batch = moving.subspan(first, std::min(kBatch, moving.size() - first));
        std::vector<Far::Place> places;
        for (const Moving& m : batch) places.push_back(m.place);
        const Far::LimitStencilTable table = factory.Create(places);
        for (std::size_t i = 0; i < batch.size(); ++i) {
            const Index row = static_cast<Index>(i);
            const auto indices = table.rows().Indices(row);
            if (indices.empty()) {
                throw InvalidInput("point " + std::to_string(batch[i].point) +
                                   " is where the scheme has no limit; embed it at a level");
            }
            placed.row_points.push_back(batch[i].point);
            if (!batch[i].is_continued) {
                Append(indices, table.rows().Weights(row), placed.rows);
                continue;
            }
            std::array<std::vector<double>, 3> derivatives;
            for (int k = 0; k < 3; ++k) {
                const auto d = table.DerivativeWeights(k).subspan(static_cast<std::size_t>(table.rows().offsets[row]),
                                                                  indices.size());
                derivatives[static_cast<std::size_t>(k)].assign(d.begin(), d.end());
            }
            AppendContinued(indices, table.rows().Weights(row), derivatives, lattice.positions,
                            PointAt(points, batch[i].point), longest, placed.rows);
        }
    }
}

}  // namespace

std::array<Index, 4> TetCorners(const Far::Level& level, Index tet) {
    if (tet < level.n_tets) {
        const auto v = level.TetVertices(tet);
        return {v[0], v[1], v[2], v[3]};
    }
    const Index part = tet - level.n_tets;
    const auto v = level.OctVertices(part / 4);
    return {v[0], v[1], v[part & 1 ? 3 : 2], v[part & 2 ? 5 : 4]};
}

PlacedPoints Place(const RefinedLattice& lattice, std::span<const double> points, const EmbedOptions& options) {
    Geometry::Location found;
    if (options.limit) {
        Geometry::LimitLocator locator(lattice.refiner, options.scheme, lattice.level(), lattice.positions);
        const double tolerance = std::max(options.tolerance, LimitTolerance(lattice));
        found = locator.Locate(points, {.tolerance = tolerance, .progress = options.progress});
    } else {
        const Geometry::Locator locator(lattice.refiner, lattice.level(), lattice.positions);
        found = locator.Locate(points, {.tolerance = options.tolerance, .progress = options.progress});
    }
    PlacedPoints placed;
    placed.rows.n_sources = lattice.refiner.n_vertices(lattice.level());
    const std::vector<Moving> moving = ListMoving(found, options, lattice.mean_edge, placed.outside);
    const double longest = LongestStep(lattice, options);
    if (options.limit) {
        PlaceInLimit(lattice, points, moving, options, longest, placed);
    } else if (lattice.refiner.is_polyhedral()) {
        PlaceInPolyhedra(lattice, points, moving, longest, placed);
    } else {
        PlaceInTets(lattice, points, moving, longest, placed);
    }
    return placed;
}

}  // namespace SolidSubdiv::Deform::Internal
