// SPDX-License-Identifier: Apache-2.0
// Validator tricubic-regular: inside regular blocks Catmull-Clark solids and mlca are tensor products of cubic
// B-splines.
#include "tricubic_regular.h"

#include <cmath>

#include "points.h"
#include "validators.h"

namespace SolidSubdiv::Validation {

namespace {

constexpr std::size_t kWidth = 3;
using Place = std::array<int, 3>;

Far::TopologyRefiner RefineCubes(int n, int max_level) {
    std::vector<Index> hexes;
    const auto id = [n](int x, int y, int z) { return x + (n + 1) * (y + (n + 1) * z); };
    for (int z = 0; z < n; ++z) {
        for (int y = 0; y < n; ++y) {
            for (int x = 0; x < n; ++x) {
                for (int top : {0, 1}) {
                    hexes.insert(hexes.end(), {id(x, y, z + top), id(x + 1, y, z + top), id(x + 1, y + 1, z + top),
                                               id(x, y + 1, z + top)});
                }
            }
        }
    }
    Far::TopologyDescriptor mesh{.n_vertices = (n + 1) * (n + 1) * (n + 1)};
    mesh.hexes = hexes;
    auto refiner = Far::TopologyRefiner::Create(mesh, Sdc::Split::Polyhedral);
    refiner.RefineUniform({.max_level = max_level, .full_topology_in_last_level = true});
    return refiner;
}

/// Twice the mean of the parents' places.
template <class Vertices>
Place TwiceTheMean(const std::vector<Place>& places, const Vertices& vertices) {
    Place sum{};
    for (Index v : vertices) {
        for (std::size_t i = 0; i < 3; ++i) sum[i] += 2 * places[static_cast<std::size_t>(v)][i];
    }
    for (int& x : sum) x /= static_cast<int>(vertices.size());
    return sum;
}

std::vector<Place> PlacesOfChildren(const Vtr::PolyhedralLevel& level, const std::vector<Place>& places) {
    std::vector<Place> children;
    for (const Place& p : places) children.push_back({2 * p[0], 2 * p[1], 2 * p[2]});
    for (Index e = 0; e < level.n_edges; ++e) children.push_back(TwiceTheMean(places, level.EdgeVertices(e)));
    for (Index f = 0; f < level.n_faces; ++f) children.push_back(TwiceTheMean(places, level.FaceVertices(f)));
    for (Index c = 0; c < level.n_hexes; ++c) children.push_back(TwiceTheMean(places, level.CellVertices(c)));
    return children;
}

/// Weights over the integers of the cubic B-spline's coefficients after `level` knot insertions, at place / 2^level.
/// By the mask (1, 4, 6, 4, 1)/8, from the finest level up.
std::vector<double> CoefficientRow(int place, int level, int n) {
    std::vector<double> row(static_cast<std::size_t>((n << level) + 1), 0.0);
    row[static_cast<std::size_t>(place)] = 1;
    for (int l = level; l > 0; --l) {
        std::vector<double> coarser(static_cast<std::size_t>((n << (l - 1)) + 1), 0.0);
        const auto add = [&](int i, double w) {
            if (w != 0) coarser.at(static_cast<std::size_t>(i)) += w;
        };
        for (int i = 0; i < static_cast<int>(row.size()); ++i) {
            const double w = row[static_cast<std::size_t>(i)];
            if (w == 0) continue;
            if (i % 2 == 1) {
                add(i / 2, w / 2);
                add(i / 2 + 1, w / 2);
            } else {
                add(i / 2 - 1, w / 8);
                add(i / 2, w * 6 / 8);
                add(i / 2 + 1, w / 8);
            }
        }
        row = std::move(coarser);
    }
    return row;
}

/// The uniform cubic B-spline at x, its support [-2, 2].
double CubicSpline(double x) {
    const double t = std::abs(x);
    if (t >= 2) return 0;
    if (t >= 1) return (2 - t) * (2 - t) * (2 - t) / 6;
    return 2.0 / 3 - t * t + t * t * t / 2;
}

std::vector<double> SplineRow(int place, int level, int n) {
    std::vector<double> row;
    for (int i = 0; i <= n; ++i) row.push_back(CubicSpline(std::ldexp(place, -level) - i));
    return row;
}

/// Tensor product of three rows over the control values.
std::array<double, kWidth> Sum(const RefinedCubes& cubes, const std::array<std::vector<double>, 3>& rows) {
    std::array<double, kWidth> sum{};
    const std::size_t n = static_cast<std::size_t>(cubes.n) + 1;
    for (std::size_t z = 0; z < n; ++z) {
        for (std::size_t y = 0; y < n; ++y) {
            for (std::size_t x = 0; x < n; ++x) {
                const double w = rows[0][x] * rows[1][y] * rows[2][z];
                for (std::size_t c = 0; c < kWidth; ++c) {
                    sum[c] += w * cubes.control[kWidth * (x + n * (y + n * z)) + c];
                }
            }
        }
    }
    return sum;
}

template <class RowOf>
void Compare(const RefinedCubes& cubes, const std::vector<double>& ours, int level, bool with_neighbors,
             const RowOf& row_of, const char* what, Findings& findings) {
    const auto& places = cubes.places[static_cast<std::size_t>(level)];
    if (ours.size() != kWidth * places.size()) {
        findings.Fault("level " + std::to_string(level) + ": the table is of another mesh");
        return;
    }
    for (std::size_t v = 0; v < places.size(); ++v) {
        const Place& p = places[v];
        if (!cubes.IsInside(level, p, with_neighbors)) continue;
        const auto expected = Sum(cubes, {row_of(p[0]), row_of(p[1]), row_of(p[2])});
        for (std::size_t c = 0; c < kWidth; ++c) {
            findings.Error(std::abs(ours[kWidth * v + c] - expected[c]), [&] {
                return std::string(what) + " at (" + std::to_string(p[0]) + " " + std::to_string(p[1]) + " " +
                       std::to_string(p[2]) + ")/2^" + std::to_string(level);
            });
        }
    }
}

}  // namespace

RefinedCubes::RefinedCubes(int n_cubes, int max_level) : n(n_cubes), refiner(RefineCubes(n_cubes, max_level)) {
    Shaker shaker(5);
    std::vector<Place>& base = places.emplace_back();
    for (int z = 0; z <= n; ++z) {
        for (int y = 0; y <= n; ++y) {
            for (int x = 0; x <= n; ++x) {
                base.push_back({x, y, z});
                for (std::size_t c = 0; c < kWidth; ++c) control.push_back(shaker.Next());
            }
        }
    }
    for (int l = 0; l < max_level; ++l) {
        places.push_back(PlacesOfChildren(refiner.polyhedral_level(l), places[static_cast<std::size_t>(l)]));
    }
}

bool RefinedCubes::IsInside(int level, const Place& place, bool with_neighbors) const {
    // The boundary's rules reach one step inwards at each level: less than one cube in all.
    const int first = (1 << level) - 1 + with_neighbors;
    for (int x : place) {
        if (x < first || x > (n << level) - first) return false;
    }
    return true;
}

void CompareWithKnotInsertion(const RefinedCubes& cubes, const Far::StencilTable& table, Findings& findings) {
    std::vector<double> values = cubes.control;
    for (int l = 1; l <= table.n_levels(); ++l) {
        values = Apply(table.level(l), values);
        Compare(
            cubes, values, l, false, [&](int place) { return CoefficientRow(place, l, cubes.n); }, "value", findings);
    }
}

void CompareWithTricubic(const RefinedCubes& cubes, const Far::StencilTable& table,
                         const Far::StencilRows<double>& limits, int level, Findings& findings) {
    std::vector<double> values = cubes.control;
    for (int l = 1; l <= level; ++l) values = Apply(table.level(l), values);
    Compare(
        cubes, Apply(limits, values), level, true, [&](int place) { return SplineRow(place, level, cubes.n); }, "limit",
        findings);
}

Findings ValidateTricubicRegular(const Context&) {
    constexpr int kCubes = 4, kLevels = 3;
    const RefinedCubes cubes(kCubes, kLevels);
    Findings findings;
    for (const Sdc::Scheme& scheme : {Sdc::Scheme(Sdc::CatmullClarkSolid{}), Sdc::Scheme(Sdc::Mlca{})}) {
        Findings found;
        const auto table = Far::StencilTable::Create(cubes.refiner, scheme);
        CompareWithKnotInsertion(cubes, table, found);
        for (int l = 0; l <= kLevels; ++l) {
            const auto limits = Far::LimitStencilTable::Create(cubes.refiner, scheme, {.level = l});
            CompareWithTricubic(cubes, table, limits.rows(), l, found);
        }
        findings.Merge(found, std::string(Sdc::NameOf(scheme)));
    }
    findings.notes.push_back("a block of 4 x 4 x 4 cubes, levels 1-3; limits at vertices of levels 0-3");
    return findings;
}

}  // namespace SolidSubdiv::Validation
