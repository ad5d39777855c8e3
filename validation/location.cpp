// SPDX-License-Identifier: Apache-2.0
// Validator location: evaluate, locate, compare on a million random points of real lattices, with none lost.
#include "location.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include <solidsubdiv/far/primvar_refiner.h>
#include <solidsubdiv/kit/io/formats.h>

#include "validators.h"

namespace SolidSubdiv::Validation {

namespace {

using Point = std::array<double, 3>;

constexpr int kPointsOfLattice = 200000;
constexpr int kLevel = 2;

/// What a cell is to its coordinates: its faces as lists of vertices where it has parts, otherwise its vertices alone.
struct Cell {
    enum class Kind { Tet, Oct, Hex, Parts } kind;
    std::span<const Index> vertices;
    std::vector<std::vector<Index>> faces{};

    int n_parts() const {
        std::size_t n = 0;
        for (const auto& face : faces) n += face.size();
        return kind == Kind::Parts ? static_cast<int>(n) : 1;
    }
};

/// @pre the cell is there
Cell CellOf(const LocationShape& shape, Index cell) {
    if (!shape.refiner.is_polyhedral()) {
        const auto& level = shape.refiner.level(shape.level);
        if (cell < level.n_tets) return {Cell::Kind::Tet, level.TetVertices(cell)};
        return {Cell::Kind::Oct, level.OctVertices(cell - level.n_tets)};
    }
    const auto& level = shape.refiner.polyhedral_level(shape.level);
    if (cell < level.n_hexes) {
        return {Cell::Kind::Hex, {level.hex_vertices.data() + 8 * static_cast<std::size_t>(cell), 8}};
    }
    const auto& p = level.polyhedra;
    Cell result{Cell::Kind::Parts, {}};
    for (Offset f = p.offsets[cell - level.n_hexes]; f < p.offsets[cell - level.n_hexes + 1]; ++f) {
        result.faces.emplace_back(p.face_vertices.begin() + p.face_vertex_offsets[f],
                                  p.face_vertices.begin() + p.face_vertex_offsets[f + 1]);
    }
    return result;
}

Point PointOf(const LocationShape& shape, Index v) {
    const double* p = shape.positions.data() + 3 * static_cast<std::size_t>(v);
    return {p[0], p[1], p[2]};
}

Point Sum(std::initializer_list<std::pair<double, Point>> terms) {
    Point sum{};
    for (const auto& [weight, point] : terms) {
        for (std::size_t c = 0; c < 3; ++c) sum[c] += weight * point[c];
    }
    return sum;
}

Point MeanOf(const LocationShape& shape, const std::vector<Index>& vertices) {
    Point sum{};
    for (Index v : vertices) sum = Sum({{1, sum}, {1.0 / static_cast<double>(vertices.size()), PointOf(shape, v)}});
    return sum;
}

Point EvaluateParts(const LocationShape& shape, const Cell& cell, const Far::Place& place) {
    const auto [u, v, w] = place.at;
    std::vector<Index> all;
    for (const auto& face : cell.faces) {
        for (Index vertex : face) {
            if (std::find(all.begin(), all.end(), vertex) == all.end()) all.push_back(vertex);
        }
    }
    auto k = static_cast<std::size_t>(place.part);
    for (const auto& face : cell.faces) {
        if (k < face.size()) {
            return Sum({{1 - u - v - w, MeanOf(shape, all)},
                        {u, MeanOf(shape, face)},
                        {v, PointOf(shape, face[k])},
                        {w, PointOf(shape, face[(k + 1) % face.size()])}});
        }
        k -= face.size();
    }
    return {};
}

Point Evaluate(const LocationShape& shape, const Far::Place& place) {
    const Cell cell = CellOf(shape, place.element);
    const auto p = [&](std::size_t i) { return PointOf(shape, cell.vertices[i]); };
    const auto [u, v, w] = place.at;
    switch (cell.kind) {
        case Cell::Kind::Tet:
            return Sum({{1 - u - v - w, p(0)}, {u, p(1)}, {v, p(2)}, {w, p(3)}});
        case Cell::Kind::Oct: {
            const double b = std::abs(v), c = std::abs(w), middle = (1 - b - c) / 2;
            return Sum({{middle + u / 2, p(0)}, {middle - u / 2, p(1)}, {b, p(v < 0 ? 3 : 2)}, {c, p(w < 0 ? 5 : 4)}});
        }
        case Cell::Kind::Hex:
            return Sum({{(1 - u) * (1 - v) * (1 - w), p(0)},
                        {u * (1 - v) * (1 - w), p(1)},
                        {u * v * (1 - w), p(2)},
                        {(1 - u) * v * (1 - w), p(3)},
                        {(1 - u) * (1 - v) * w, p(4)},
                        {u * (1 - v) * w, p(5)},
                        {u * v * w, p(6)},
                        {(1 - u) * v * w, p(7)}});
        case Cell::Kind::Parts:
            return EvaluateParts(shape, cell, place);
    }
    return {};
}

bool IsWithin(Cell::Kind kind, const Point& at) {
    constexpr double kSumRounds = 4e-16;
    const auto [u, v, w] = at;
    if (kind == Cell::Kind::Hex) return std::min({u, v, w}) >= 0 && std::max({u, v, w}) <= 1;
    if (kind == Cell::Kind::Oct) return std::abs(u) + std::abs(v) + std::abs(w) <= 1 + kSumRounds;
    return std::min({u, v, w}) >= 0 && u + v + w <= 1 + kSumRounds;
}

double LargestOf(std::span<const double> values) {
    double largest = 0;
    for (double x : values) largest = std::max(largest, std::abs(x));
    return largest;
}

void CheckLattice(const std::filesystem::path& path, int n_points, std::uint32_t seed, Findings& findings) {
    const std::string name = path.filename().string();
    if (!std::filesystem::exists(path)) {
        findings.skipped.push_back(name + ": there is no " + path.string());
        return;
    }
    const Io::Mesh mesh = Io::ReadSolid(path);
    const bool is_tet_oct = mesh.topology.n_cells() == mesh.topology.n_tets() + mesh.topology.n_octs();
    auto refiner =
        Far::TopologyRefiner::Create(mesh.topology, is_tet_oct ? Sdc::Split::TetOct : Sdc::Split::Polyhedral);
    refiner.RefineUniform({.max_level = kLevel});
    const Sdc::Scheme scheme = is_tet_oct ? Sdc::Scheme(Sdc::BoxSpline{}) : Sdc::Scheme(Sdc::CatmullClarkSolid{});
    const Far::PrimvarRefiner primvars(refiner, scheme);
    std::vector<double> positions = mesh.positions;
    for (int l = 1; l <= kLevel; ++l) {
        std::vector<double> fine(3 * static_cast<std::size_t>(refiner.n_vertices(l)));
        primvars.Interpolate<double>(l, positions, fine, 3);
        positions = std::move(fine);
    }
    const LocationShape shape{refiner, kLevel, positions};
    const auto drawn = DrawPlaces(shape, n_points, seed);
    const auto points = EvaluatePlainly(shape, drawn);
    const Geometry::Locator locator(refiner, kLevel, positions);
    Findings of_lattice;
    CompareLocation(shape, drawn, points, locator.Locate(points), of_lattice);
    of_lattice.notes.push_back(std::to_string(drawn.size()) + " points in " + std::to_string(refiner.n_cells(kLevel)) +
                               " cells");
    findings.Merge(of_lattice, name);
}

}  // namespace

std::vector<Far::Place> DrawPlaces(const LocationShape& shape, int n, std::uint32_t seed) {
    std::mt19937 engine(seed);
    const auto below = [&](Offset m) { return static_cast<Index>(engine() % static_cast<std::uint32_t>(m)); };
    const auto uniform = [&] { return static_cast<double>(engine()) / 4294967296.0; };
    std::vector<Far::Place> places(static_cast<std::size_t>(n));
    for (Far::Place& place : places) {
        place.element = below(shape.refiner.n_cells(shape.level));
        const Cell cell = CellOf(shape, place.element);
        place.part = below(cell.n_parts());
        do {
            place.at = {uniform(), uniform(), uniform()};
        } while (cell.kind != Cell::Kind::Hex && place.at[0] + place.at[1] + place.at[2] > 1);
        for (double& x : place.at) {
            if (cell.kind == Cell::Kind::Oct && below(2) == 0) x = -x;
        }
    }
    return places;
}

std::vector<double> EvaluatePlainly(const LocationShape& shape, std::span<const Far::Place> places) {
    std::vector<double> points;
    points.reserve(3 * places.size());
    for (const Far::Place& place : places) {
        for (double x : Evaluate(shape, place)) points.push_back(x);
    }
    return points;
}

void CompareLocation(const LocationShape& shape, std::span<const Far::Place> drawn, std::span<const double> points,
                     const Geometry::Location& found, Findings& findings) {
    if (found.places.size() != drawn.size()) findings.Fault("another number of places");
    if (!found.outside.empty()) {
        findings.Fault(std::to_string(found.outside.size()) + " points lost, the first " +
                       std::to_string(found.outside[0].point));
    }
    const double largest = LargestOf(shape.positions);
    for (std::size_t i = 0; i < std::min(drawn.size(), found.places.size()); ++i) {
        const Far::Place& place = found.places[i];
        const auto name = [&] { return "point " + std::to_string(i); };
        if (place.element < 0 || place.element > drawn[i].element) {
            findings.Fault(name() + ": in cell " + std::to_string(place.element) + ", not in " +
                           std::to_string(drawn[i].element) + " or a lower one");
            continue;
        }
        const Cell cell = CellOf(shape, place.element);
        if (place.part < 0 || place.part >= cell.n_parts()) {
            findings.Fault(name() + ": there is no part " + std::to_string(place.part));
            continue;
        }
        if (!IsWithin(cell.kind, place.at)) findings.Fault(name() + ": coordinates out of their ranges");
        const Point there = Evaluate(shape, place);
        double error = 0;
        for (std::size_t c = 0; c < 3; ++c) error = std::max(error, std::abs(there[c] - points[3 * i + c]));
        findings.Error(error / largest, name);
    }
}

Findings ValidateLocation(const Context& context) {
    Findings findings;
    const std::filesystem::path hexes = context.tets.parent_path() / "hexes";
    std::uint32_t seed = 1;
    for (const std::filesystem::path& path :
         {context.shapes / "demo" / "bunny_lattice.vtu", context.tets / "sofa_liver.msh",
          context.tets / "poly_bunny.msh", hexes / "cino_ellipsoid.mesh", hexes / "cino_rockerarm.mesh"}) {
        CheckLattice(path, context.is_quick ? kPointsOfLattice / 100 : kPointsOfLattice, seed++, findings);
    }
    return findings;
}

}  // namespace SolidSubdiv::Validation
