// SPDX-License-Identifier: Apache-2.0
// Validator limit-places: limit rows at random places of every scheme against walks by refinement alone.
#include "limit_places.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <random>

#include <solidsubdiv/sdc/parallel.h>

#include "limit_shapes.h"
#include "points.h"
#include "validators.h"

namespace SolidSubdiv::Validation {

namespace {

constexpr int kLevels = 14;  // fits are of level 12: third powers of sizes of 1e-11, second ones of 1e-7

double Distance(const Vector3& a, const Vector3& b) { return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]); }

/// How far the last estimate may be off, by the changes of the last levels; infinite where they do not say. Errors fall
/// by 2^order a level where the limit is smooth, and unevenly, as the place lies elsewhere in each element: so changes
/// of earlier levels count too, as what would be left of them. Where changes fall slowly, what is to come is more than
/// the last.
template <class Get>
double BoundOf(const std::vector<LimitEstimate>& walk, int order, Get&& get) {
    const auto change = [&](int k) {
        const std::size_t i = walk.size() - static_cast<std::size_t>(k);
        return Distance(get(walk[i]), get(walk[i - 1]));
    };
    double largest = 0;
    for (int k = 1; order * (k - 1) <= 9 && k <= static_cast<int>(walk.size()) - 1; ++k) {
        largest = std::max(largest, std::ldexp(change(k), -order * (k - 1)));
    }
    const double recent = change(1) + change(2), before = change(3) + change(4);
    const double fall = before > 0 ? std::sqrt(recent / before) : 0;  // a level
    const double round_off = std::ldexp(1e-13, 12 * (3 - order));     // of differences of level 12
    if (fall > 0.95 && recent > round_off) return std::numeric_limits<double>::infinity();
    return 8 * largest / (1 - std::min(fall, 0.95));
}

Vector3 Sum(const Far::StencilRows<double>& rows, Index row, const std::vector<double>& positions) {
    Vector3 point{};
    for (std::size_t k = 0; k < rows.Indices(row).size(); ++k) {
        const std::size_t v = static_cast<std::size_t>(rows.Indices(row)[k]);
        for (std::size_t i = 0; i < 3; ++i) point[i] += rows.Weights(row)[k] * positions[3 * v + i];
    }
    return point;
}

double SumOfWeights(const Far::StencilRows<double>& rows, Index row) {
    double sum = 0;
    for (double w : rows.Weights(row)) sum += w;
    return sum;
}

/// 1: has no parts.
std::size_t CountParts(const Vtr::PolyhedralLevel& level, Index element, bool is_cell) {
    if (!is_cell) {
        const std::size_t n = level.BoundaryVertices(element).size();
        return n == 4 ? 1 : n;
    }
    std::size_t n = 0;
    for (Index f : level.CellFaces(element)) n += level.FaceVertices(f).size();
    return level.IsHex(element) ? 1 : n;
}

std::string Quantiles(std::vector<double> bounds) {
    if (bounds.empty()) return "none";
    std::sort(bounds.begin(), bounds.end());
    char text[80];
    std::snprintf(text, sizeof text, "median %.1e, nine of ten within %.1e", bounds[bounds.size() / 2],
                  bounds[bounds.size() * 9 / 10]);
    return text;
}

}  // namespace

void LimitTally::Merge(const LimitTally& other) {
    n_to_tolerance += other.n_to_tolerance;
    n_to_bound += other.n_to_bound;
    n_without_limit += other.n_without_limit;
    n_slopes += other.n_slopes;
    n_curvatures += other.n_curvatures;
    for (std::size_t k = 0; k < 3; ++k) n_unsettled[k] += other.n_unsettled[k];
    const auto append = [](auto& to, const auto& from) { to.insert(to.end(), from.begin(), from.end()); };
    append(bounds, other.bounds);
    append(slope_bounds, other.slope_bounds);
    append(curvature_bounds, other.curvature_bounds);
}

std::string LimitTally::Text() const {
    return std::to_string(n_to_tolerance) + " points to 1e-9, " + std::to_string(n_to_bound) + " to a bound (" +
           Quantiles(bounds) + "); " + std::to_string(n_slopes) + " slopes (" + Quantiles(slope_bounds) + "), " +
           std::to_string(n_curvatures) + " second derivatives (" + Quantiles(curvature_bounds) + "); " +
           std::to_string(n_without_limit) +
           " places without limit; not settled by walks: " + std::to_string(n_unsettled[0]) + " points, " +
           std::to_string(n_unsettled[1]) + " slopes, " + std::to_string(n_unsettled[2]) + " second derivatives";
}

LimitRows MakeLimitRows(const Far::TopologyRefiner& refiner, const Sdc::Scheme& scheme,
                        std::span<const Far::Place> places, const Far::LimitPlacesOptions& options) {
    const auto table = Far::LimitStencilTable::Create(refiner, scheme, places, options);
    LimitRows result{table.rows(), {}, std::vector<int>(places.size(), options.order)};
    for (int k = 0; k < table.n_derivatives(); ++k) result.derivatives.push_back(table.DerivativeRows(k));
    for (const Far::Defect& defect : table.defects()) {
        result.orders[static_cast<std::size_t>(defect.element)] =
            defect.code == Far::DefectCode::NoLimit ? -1 : static_cast<int>(defect.measure) - 1;
    }
    return result;
}

std::vector<Far::Place> RandomLimitPlaces(const Far::TopologyRefiner& refiner, Far::Elements elements, int n,
                                          std::uint32_t seed, WhereInElements where) {
    std::mt19937 random(seed);
    const auto below = [&](std::size_t m) { return random() % static_cast<unsigned>(m); };
    const auto uniform = [&] { return (static_cast<double>(random()) + 0.5) / 4294967296.0; };
    const bool is_cell = elements == Far::Elements::Cells, is_polyhedral = refiner.is_polyhedral();
    const Index n_elements = is_cell         ? static_cast<Index>(refiner.n_cells(0))
                             : is_polyhedral ? refiner.polyhedral_level(0).n_boundary_faces
                                             : refiner.level(0).n_boundary_faces;
    // Inside, at least about 1/64 from all faces.
    const auto is_on_side = [&] { return where == WhereInElements::OnSides && below(2) == 0; };
    const std::size_t d = is_cell ? 3 : 2;
    std::vector<Far::Place> places;
    for (int i = 0; i < n && n_elements > 0; ++i) {
        Far::Place place{.element = static_cast<Index>(below(static_cast<std::size_t>(n_elements)))};
        std::array<double, 3>& at = place.at;
        const std::size_t n_parts = is_polyhedral ? CountParts(refiner.polyhedral_level(0), place.element, is_cell) : 0;
        if (n_parts == 1) {
            for (std::size_t k = 0; k < d; ++k) {
                at[k] = is_on_side() ? static_cast<double>(below(2)) : 1.0 / 64 + uniform() * 31 / 32;
            }
        } else {
            if (n_parts > 1) place.part = static_cast<Index>(below(n_parts));
            std::array<double, 4> weights{};
            double sum = 0;
            for (std::size_t k = 0; k <= d; ++k) sum += weights[k] = is_on_side() ? 0 : 0.1 - std::log(uniform());
            if (sum == 0) weights[0] = sum = 1;
            for (std::size_t k = 0; k < d; ++k) at[k] = weights[k + 1] / sum;
            if (is_cell && !is_polyhedral && place.element >= refiner.level(0).n_tets) {
                for (double& x : at) x = below(2) == 0 ? x : -x;
            }
        }
        places.push_back(place);
    }
    return places;
}

std::vector<std::vector<std::vector<LimitEstimate>>> WalkToPlaces(const OwnedMesh& mesh, Sdc::Split split,
                                                                  const std::vector<Sdc::Scheme>& schemes,
                                                                  const std::vector<double>& positions,
                                                                  std::span<const Far::Place> places,
                                                                  Far::Elements elements) {
    std::vector<std::vector<std::vector<LimitEstimate>>> walks(schemes.size(),
                                                               std::vector<std::vector<LimitEstimate>>(places.size()));
    Sdc::ParallelFor(static_cast<Offset>(places.size()), 1, [&](Offset begin, Offset end) {
        for (std::size_t i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i) {
            Estimates found = WalkToPlace(mesh, split, schemes, positions, places[i], elements, kLevels);
            for (std::size_t s = 0; s < schemes.size(); ++s) walks[s][i] = std::move(found[s]);
        }
    });
    return walks;
}

LimitTally CompareWithWalks(const LimitRows& rows, const std::vector<double>& positions,
                            const std::vector<std::vector<LimitEstimate>>& walks, Findings& findings) {
    LimitTally tally;
    const double size = SizeOf(positions);
    for (Index i = 0; i < rows.rows.n_rows(); ++i) {
        const std::vector<LimitEstimate>& walk = walks[static_cast<std::size_t>(i)];
        const int order = rows.orders[static_cast<std::size_t>(i)];
        if (order < 0) {
            ++tally.n_without_limit;
            continue;
        }
        const auto where = [&](const std::string& what) { return what + " at place " + std::to_string(i); };
        if (walk.size() < 5) {
            findings.Fault(where("no walk"));
            continue;
        }
        const auto compare = [&](const Vector3& ours, int derivative, auto&& get, const std::string& what,
                                 std::vector<double>& bounds, std::int64_t& n) {
            const double bound = BoundOf(walk, 3 - derivative, get) / size + (derivative > 0 ? kSlopeRoundOff : 0);
            if (bound > 0.1) {
                ++tally.n_unsettled[static_cast<std::size_t>(derivative)];
                return;
            }
            const double error = Distance(ours, get(walk.back())) / size;
            const bool is_certain = bound <= kLimitCertainty;
            findings.Error(is_certain ? error : std::max(0.0, error - bound), [&] { return where(what); });
            if (!is_certain) bounds.push_back(bound);
            ++(is_certain && &n == &tally.n_to_bound ? tally.n_to_tolerance : n);
        };
        findings.Error(std::abs(SumOfWeights(rows.rows, i) - 1), [&] { return where("sum of weights"); });
        compare(
            Sum(rows.rows, i, positions), 0, [](const LimitEstimate& e) { return e.point; }, "point", tally.bounds,
            tally.n_to_bound);
        const std::size_t d = walk.back().slopes.size();
        for (std::size_t k = 0; k < rows.derivatives.size(); ++k) {
            const bool is_slope = k < d;
            if (order < (is_slope ? 1 : 2)) continue;
            const std::string what = "derivative " + std::to_string(k);
            const double sum = std::abs(SumOfWeights(rows.derivatives[k], i));
            findings.Error(std::max(0.0, sum - kSlopeRoundOff), [&] { return where("sum of " + what); });
            compare(
                Sum(rows.derivatives[k], i, positions), is_slope ? 1 : 2,
                [&](const LimitEstimate& e) { return is_slope ? e.slopes[k] : e.curvatures[k - d]; }, what,
                is_slope ? tally.slope_bounds : tally.curvature_bounds, is_slope ? tally.n_slopes : tally.n_curvatures);
        }
    }
    return tally;
}

Findings ValidateLimitPlaces(const Context& context) {
    Findings findings;
    LimitTally all;
    std::uint32_t seed = 0;
    for (const LimitShape& shape : LimitShapes()) {
        const auto refiner = Far::TopologyRefiner::Create(shape.mesh.Descriptor(), shape.split);
        const auto compare = [&](Far::Elements elements, WhereInElements where, int n, const std::string& name) {
            const auto places = RandomLimitPlaces(refiner, elements, context.is_quick ? (n + 3) / 4 : n, ++seed, where);
            if (places.empty()) return;
            const auto walks = WalkToPlaces(shape.mesh, shape.split, shape.schemes, shape.positions, places, elements);
            for (std::size_t s = 0; s < shape.schemes.size(); ++s) {
                LimitRows rows = MakeLimitRows(refiner, shape.schemes[s], places, {.elements = elements, .order = 2});
                if (where == WhereInElements::OnSides) {
                    for (int& order : rows.orders) order = std::min(order, 0);
                }
                Findings found;
                all.Merge(CompareWithWalks(rows, shape.positions, walks[s], found));
                findings.Merge(found, shape.name + ", " + std::string(Sdc::NameOf(shape.schemes[s])) + " (" +
                                          std::to_string(s) + "), " + name);
            }
        };
        const int n_on_sides = (shape.n_in_cells + shape.n_on_faces + 3) / 4;
        compare(Far::Elements::Cells, WhereInElements::Inside, shape.n_in_cells, "in cells");
        compare(Far::Elements::BoundaryFaces, WhereInElements::Inside, shape.n_on_faces, "in boundary faces");
        compare(Far::Elements::Cells, WhereInElements::OnSides, n_on_sides, "on sides of cells");
        compare(Far::Elements::BoundaryFaces, WhereInElements::OnSides, n_on_sides, "on sides of boundary faces");
    }
    findings.notes.push_back(all.Text());
    findings.skipped.push_back(
        "derivatives on faces, edges and corners of elements, where limits of many schemes are not smooth");
    findings.skipped.push_back("sharp features under Chaikin's creasing: CreasesAt does not say what they change");
    return findings;
}

}  // namespace SolidSubdiv::Validation
