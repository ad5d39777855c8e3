// SPDX-License-Identifier: Apache-2.0
// What tests of limits at places share: places that are vertices of later levels, random ones, points of rows.
#pragma once

#include <cmath>
#include <random>
#include <unordered_map>

#include <solidsubdiv/far/place.h>
#include <solidsubdiv/sdc/parallel.h>

#include "far_testing.h"
#include "sanitized.h"

namespace SolidSubdiv::TestFar {

using Far::Elements;
using Far::LimitPlacesOptions;
using Far::LimitStencilTable;
using Far::Place;

/// Names of places: sums of numbers of the control vertices, in units of 8^-levels, modulo 2^64.
using PlaceName = std::uint64_t;

inline std::vector<PlaceName> NamesOfControlVertices(Index n) {
    std::mt19937_64 random(7);
    std::vector<PlaceName> names(static_cast<std::size_t>(n));
    for (PlaceName& name : names) name = random();
    return names;
}

/// Names of a level's vertices from those of the level before.
inline std::vector<PlaceName> NamesOfChildren(const Far::TopologyRefiner& refiner, int level,
                                              const std::vector<PlaceName>& parents) {
    std::vector<PlaceName> names;
    for (PlaceName p : parents) names.push_back(8 * p);
    const auto sum = [&](auto&& vertices) {
        PlaceName s = 0;
        for (Index v : vertices) s += parents[static_cast<std::size_t>(v)];
        return s;
    };
    const Vtr::EdgeGraph graph = refiner.graph(level - 1);
    for (Index e = 0; e < graph.n_edges; ++e) names.push_back(4 * sum(graph.EdgeVertices(e)));
    if (refiner.is_polyhedral()) {
        const auto& l = refiner.polyhedral_level(level - 1);
        for (Index f = 0; f < l.n_faces; ++f) names.push_back(2 * sum(l.FaceVertices(f)));
        for (Index c = 0; c < static_cast<Index>(l.n_cells()); ++c) names.push_back(sum(l.CellVertices(c)));
    } else {
        const auto& l = refiner.level(level - 1);
        for (Index o = 0; o < l.n_octs; ++o) names.push_back(4 * sum(l.OctVertices(o).first(2)));
    }
    return names;
}

/// Random places that are vertices of level `levels`, each with the vertex.
struct PlacesOfVertices {
    std::vector<Place> places;
    std::vector<Index> vertices;
};

inline PlacesOfVertices FindPlaces(const Far::TopologyRefiner& refiner, int levels, Elements elements, int n_tries) {
    std::vector<PlaceName> control = NamesOfControlVertices(refiner.n_vertices(0)), names = control;
    for (int l = 1; l <= levels; ++l) names = NamesOfChildren(refiner, l, names);
    std::unordered_map<PlaceName, Index> vertex_of;
    for (std::size_t v = 0; v < names.size(); ++v) vertex_of[names[v]] = static_cast<Index>(v);

    const Index n = elements == Elements::Cells ? static_cast<Index>(refiner.n_cells(0))
                    : refiner.is_polyhedral()   ? refiner.polyhedral_level(0).n_boundary_faces
                                                : refiner.level(0).n_boundary_faces;
    std::mt19937 random(3);
    const int side = 1 << levels;
    PlacesOfVertices found;
    for (int i = 0; i < n_tries && n > 0; ++i) {
        Place place{.element = static_cast<Index>(random() % static_cast<unsigned>(n))};
        if (refiner.is_polyhedral()) {
            const auto& l = refiner.polyhedral_level(0);
            const bool has_parts =
                elements == Elements::Cells ? !l.IsHex(place.element) : l.BoundaryVertices(place.element).size() != 4;
            if (has_parts) continue;
        }
        const bool is_oct =
            elements == Elements::Cells && !refiner.is_polyhedral() && place.element >= refiner.level(0).n_tets;
        for (double& x : place.at) {
            x = static_cast<double>(static_cast<int>(random() % static_cast<unsigned>(side + 1))) / side;
            if (is_oct && random() % 2 == 0) x = -x;
        }
        const auto [u, v, w] = place.at;
        const double sum = std::abs(u) + std::abs(v) + (elements == Elements::Cells ? std::abs(w) : 0.0);
        if (!refiner.is_polyhedral() && sum > 1) continue;
        const auto rows = Far::MakePlaceRows(refiner, 0, {&place, 1}, elements);
        PlaceName name = 0;
        for (std::size_t k = 0; k < rows.Indices(0).size(); ++k) {
            const double units = rows.Weights(0)[k] * std::pow(8.0, levels);
            name += static_cast<PlaceName>(std::llround(units)) * control[static_cast<std::size_t>(rows.Indices(0)[k])];
        }
        const auto vertex = vertex_of.find(name);
        if (vertex == vertex_of.end()) continue;
        found.places.push_back(place);
        found.vertices.push_back(vertex->second);
    }
    return found;
}

inline std::vector<double> RandomValues(Index n) {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> uniform(-1, 1);
    std::vector<double> values(3 * static_cast<std::size_t>(n));
    for (double& x : values) x = uniform(random);
    return values;
}

/// Limits at places are those of the vertices there.
inline void ExpectLimitsOfVertices(const Far::TopologyRefiner& refiner, const Sdc::Scheme& scheme, Elements elements,
                                   int levels) {
    const PlacesOfVertices found = FindPlaces(refiner, levels, elements, FewerIfSanitized(60));
    if (found.places.empty()) return;
    const auto values = RandomValues(refiner.n_vertices(0));
    const auto at_vertices = LimitStencilTable::Create(refiner, scheme, {.level = levels});
    const auto refined = Apply(Far::StencilTable::Create(refiner, scheme, {.max_level = levels}), values);
    const auto limits = Limits(at_vertices, refined);
    const auto table =
        LimitStencilTable::Create(refiner, scheme, found.places, {.level = 0, .elements = elements, .order = 0});
    const auto points = Limits(table, values);
    double largest = 0;
    std::size_t worst = 0;
    for (std::size_t i = 0; i < found.places.size(); ++i) {
        const auto& missing = at_vertices.without_limit();
        const bool has_limit = !std::binary_search(missing.begin(), missing.end(), found.vertices[i]);
        const auto& without = table.without_limit();
        EXPECT_EQ(std::binary_search(without.begin(), without.end(), static_cast<Index>(i)), !has_limit);
        if (!has_limit) continue;
        for (std::size_t c = 0; c < 3; ++c) {
            const double d = std::abs(points[3 * i + c] - limits[3 * static_cast<std::size_t>(found.vertices[i]) + c]);
            if (d > largest) worst = i;
            largest = std::max(largest, d);
        }
    }
    // Sums of tens of products, and of eigenvectors to 1e-14.
    EXPECT_LE(largest, 2e-13) << "place " << worst << ": element " << found.places[worst].element << " at "
                              << found.places[worst].at[0] << " " << found.places[worst].at[1] << " "
                              << found.places[worst].at[2];
}

inline std::vector<Sdc::Scheme> SolidSchemes(Sdc::Split split) {
    std::vector<Sdc::Scheme> schemes;
    Sdc::ForEachScheme([&](auto scheme) {
        if (scheme.kSolids && Sdc::Takes(scheme, split)) schemes.push_back(scheme);
    });
    return schemes;
}

inline std::array<double, 3> PointOf(const Far::StencilRows<double>& rows, Index row,
                                     const std::vector<double>& values) {
    std::array<double, 3> point{};
    for (std::size_t k = 0; k < rows.Indices(row).size(); ++k) {
        for (std::size_t c = 0; c < 3; ++c) {
            point[c] += rows.Weights(row)[k] * values[3 * static_cast<std::size_t>(rows.Indices(row)[k]) + c];
        }
    }
    return point;
}

inline double Distance(const std::array<double, 3>& a, const std::array<double, 3>& b) {
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/// Random places strictly inside elements.
inline std::vector<Place> RandomPlaces(const Far::TopologyRefiner& refiner, Elements elements, int n) {
    std::mt19937 random(17);
    std::uniform_real_distribution<double> uniform(0.01, 0.99);
    const Index n_elements = elements == Elements::Cells ? static_cast<Index>(refiner.n_cells(0))
                             : refiner.is_polyhedral()   ? refiner.polyhedral_level(0).n_boundary_faces
                                                         : refiner.level(0).n_boundary_faces;
    std::vector<Place> places;
    while (n_elements > 0 && static_cast<int>(places.size()) < n) {
        Place place{.element = static_cast<Index>(random() % static_cast<unsigned>(n_elements))};
        for (double& x : place.at) x = uniform(random);
        const bool is_cell = elements == Elements::Cells;
        double sum = place.at[0] + place.at[1] + (is_cell ? place.at[2] : 0.0);
        bool is_simplex = !refiner.is_polyhedral();
        if (refiner.is_polyhedral()) {
            const auto& level = refiner.polyhedral_level(0);
            is_simplex = is_cell ? !level.IsHex(place.element) : level.BoundaryVertices(place.element).size() != 4;
        } else if (is_cell && place.element >= refiner.level(0).n_tets) {
            for (double& x : place.at) x = 2 * x - 1;
            sum = std::abs(place.at[0]) + std::abs(place.at[1]) + std::abs(place.at[2]);
        }
        if (is_simplex && sum > 0.99) continue;
        places.push_back(place);
    }
    return places;
}

}  // namespace SolidSubdiv::TestFar
