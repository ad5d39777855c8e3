// SPDX-License-Identifier: Apache-2.0
// What tests of places share: solids with their levels, random places in them, and the points of places.
#pragma once

#include <solidsubdiv/far/place.h>
#include <solidsubdiv/far/primvar_refiner.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "polyhedral_shapes.h"

namespace SolidSubdiv::Geometry {

/// A refiner with the positions of its last level.
struct TestSolid {
    std::string name;
    Far::TopologyRefiner refiner;
    int level = 0;
    std::vector<double> positions;

    TestSolid(std::string its_name, const Far::TopologyDescriptor& topology, Sdc::Split split, int n_levels,
              std::vector<double> control_positions)
        : name(its_name + ", level " + std::to_string(n_levels)),
          refiner(Far::TopologyRefiner::Create(topology, split)),
          level(n_levels),
          positions(std::move(control_positions)) {
        refiner.RefineUniform({.max_level = level});
        const Sdc::Scheme scheme =
            split == Sdc::Split::TetOct ? Sdc::Scheme(Sdc::BoxSpline{}) : Sdc::Scheme(Sdc::CatmullClarkSolid{});
        const Far::PrimvarRefiner primvars(refiner, scheme);
        for (int l = 1; l <= level; ++l) {
            std::vector<double> fine(3 * static_cast<std::size_t>(refiner.n_vertices(l)));
            primvars.Interpolate<double>(l, positions, fine, 3);
            positions = std::move(fine);
        }
    }
};

inline TestSolid TetSolid(const std::string& name, const TestShapes::Shape& s, int n_levels) {
    return {name,
            {.n_vertices = s.n_vertices, .tets = s.tets, .octs = s.octs, .triangles = s.triangles, .edges = s.edges},
            Sdc::Split::TetOct,
            n_levels,
            s.positions};
}
inline TestSolid PolyhedralSolid(const std::string& name, const TestShapes::PolyhedralShape& s, int n_levels) {
    return {name,
            {.n_vertices = s.n_vertices,
             .hexes = s.hexes,
             .polyhedron_offsets = s.cell_offsets,
             .polyhedron_face_offsets = s.face_offsets,
             .polyhedron_vertices = s.face_vertices,
             .polygon_offsets = s.polygon_offsets,
             .polygon_vertices = s.polygon_vertices,
             .edges = s.edges},
            Sdc::Split::Polyhedral,
            n_levels,
            s.positions};
}

/// Solids of every kind of cell, in control meshes and refined.
inline std::vector<TestSolid> TestSolids() {
    std::vector<TestSolid> solids;
    for (int level = 0; level <= 2; ++level) {
        for (const auto& [name, shape] : TestShapes::AllShapes()) {
            if (!shape.tets.empty() || !shape.octs.empty()) solids.push_back(TetSolid(name, shape, level));
        }
        for (const auto& [name, shape] : TestShapes::PolyhedralShapes()) {
            solids.push_back(PolyhedralSolid(name, shape, level));
        }
    }
    return solids;
}

enum class CellCoordinates { Tet, Oct, Hex, Parts };

inline CellCoordinates CoordinatesOf(const TestSolid& s, Index cell) {
    if (!s.refiner.is_polyhedral()) {
        return cell < s.refiner.level(s.level).n_tets ? CellCoordinates::Tet : CellCoordinates::Oct;
    }
    return s.refiner.polyhedral_level(s.level).IsHex(cell) ? CellCoordinates::Hex : CellCoordinates::Parts;
}

inline Index PartsOf(const TestSolid& s, Index cell) {
    if (CoordinatesOf(s, cell) != CellCoordinates::Parts) return 1;
    const auto& l = s.refiner.polyhedral_level(s.level);
    const auto& p = l.polyhedra;
    const Index i = cell - l.n_hexes;
    return static_cast<Index>(p.face_vertex_offsets[p.offsets[i + 1]] - p.face_vertex_offsets[p.offsets[i]]);
}

/// Whether coordinates are within their ranges; `margin` > 0: inside by so much.
inline bool IsWithin(CellCoordinates kind, const std::array<double, 3>& at, double margin = 0) {
    const auto [u, v, w] = at;
    if (kind == CellCoordinates::Hex) {
        return std::min({u, v, w}) >= margin && std::max({u, v, w}) <= 1 - margin;
    }
    if (kind == CellCoordinates::Oct) return std::abs(u) + std::abs(v) + std::abs(w) <= 1 - margin + 4e-16;
    return std::min({u, v, w}) >= margin && u + v + w <= 1 - margin + 4e-16;  // a sum rounds
}

/// A random place in a cell, anywhere within its ranges.
inline Far::Place RandomPlace(const TestSolid& s, Index cell, TestShapes::Random& random) {
    const auto uniform = [&] { return 0.5 + 0.5 * random.Uniform(); };
    Far::Place place{cell, random.Below(PartsOf(s, cell)), {uniform(), uniform(), uniform()}};
    const CellCoordinates kind = CoordinatesOf(s, cell);
    if (kind == CellCoordinates::Hex) return place;
    while (place.at[0] + place.at[1] + place.at[2] > 1) place.at = {uniform(), uniform(), uniform()};
    if (kind == CellCoordinates::Oct) {
        for (double& x : place.at) x = random.Below(2) == 0 ? x : -x;
    }
    return place;
}

inline std::vector<Far::Place> RandomPlaces(const TestSolid& s, int n, std::uint64_t seed) {
    TestShapes::Random random(seed);
    std::vector<Far::Place> places;
    for (int i = 0; i < n; ++i) {
        places.push_back(RandomPlace(s, random.Below(static_cast<int>(s.refiner.n_cells(s.level))), random));
    }
    return places;
}

/// The points of places, (n, 3).
inline std::vector<double> PointsOf(const TestSolid& s, std::span<const Far::Place> places) {
    const auto rows = Far::MakePlaceRows(s.refiner, s.level, places);
    std::vector<double> points(3 * places.size());
    for (std::size_t i = 0; i < places.size(); ++i) {
        const auto indices = rows.Indices(static_cast<Index>(i));
        const auto weights = rows.Weights(static_cast<Index>(i));
        for (std::size_t k = 0; k < indices.size(); ++k) {
            for (std::size_t c = 0; c < 3; ++c) {
                points[3 * i + c] += weights[k] * s.positions[3 * static_cast<std::size_t>(indices[k]) + c];
            }
        }
    }
    return points;
}

inline double DistanceOf(std::span<const double> a, std::span<const double> b, std::size_t i, std::size_t j) {
    return std::hypot(a[3 * i] - b[3 * j], a[3 * i + 1] - b[3 * j + 1], a[3 * i + 2] - b[3 * j + 2]);
}

}  // namespace SolidSubdiv::Geometry
