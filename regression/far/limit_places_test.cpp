// SPDX-License-Identifier: Apache-2.0
// Limits at places: those of vertices of later levels, laws of rows, derivatives against differences.
#include <cmath>
#include <random>
#include <unordered_map>

#include <solidsubdiv/far/place.h>

#include "far_testing.h"

namespace SolidSubdiv::TestFar {
namespace {

using Far::Elements;
using Far::LimitStencilTable;
using Far::Place;

/// Names of places: sums of numbers of the control vertices, in units of 8^-levels, modulo 2^64.
using PlaceName = std::uint64_t;

std::vector<PlaceName> NamesOfControlVertices(Index n) {
    std::mt19937_64 random(7);
    std::vector<PlaceName> names(static_cast<std::size_t>(n));
    for (PlaceName& name : names) name = random();
    return names;
}

/// Names of a level's vertices from those of the level before.
std::vector<PlaceName> NamesOfChildren(const Far::TopologyRefiner& refiner, int level,
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

PlacesOfVertices FindPlaces(const Far::TopologyRefiner& refiner, int levels, Elements elements, int n_tries) {
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

std::vector<double> RandomValues(Index n) {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> uniform(-1, 1);
    std::vector<double> values(3 * static_cast<std::size_t>(n));
    for (double& x : values) x = uniform(random);
    return values;
}

/// Limits at places are those of the vertices there.
void ExpectLimitsOfVertices(const Far::TopologyRefiner& refiner, const Sdc::Scheme& scheme, Elements elements,
                            int levels) {
    const PlacesOfVertices found = FindPlaces(refiner, levels, elements, 150);
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

TEST(LimitPlaces, Limits_AreThoseOfVerticesOfLaterLevels) {
    for (const auto& [name, shape] : TestShapes::AllShapes()) {
        constexpr int kLevels = 2;
        const auto refiner = Refined(shape, kLevels, true);
        for (const auto& [scheme_name, scheme] : AllSchemes()) {
            if (!IsSolid(scheme) && refiner.n_cells(0) > 0) continue;
            SCOPED_TRACE(std::string(name) + ", " + scheme_name);
            if (IsSolid(scheme)) ExpectLimitsOfVertices(refiner, scheme, Elements::Cells, kLevels);
            ExpectLimitsOfVertices(refiner, scheme, Elements::BoundaryFaces, kLevels);
        }
    }
}

TEST(LimitPlaces, LimitsAmongPolyhedra_AreThoseOfVerticesOfLaterLevels) {
    for (const auto& [name, shape] : TestShapes::PolyhedralShapes()) {
        constexpr int kLevels = 2;
        auto refiner = Far::TopologyRefiner::Create(Describe(shape), Sdc::Split::Polyhedral);
        refiner.RefineUniform({.max_level = kLevels, .full_topology_in_last_level = true});
        for (const auto& [scheme_name, scheme] : AllSchemes(Sdc::Split::Polyhedral)) {
            if (!IsSolid(scheme) && refiner.n_cells(0) > 0) continue;
            SCOPED_TRACE(name + ", " + scheme_name);
            if (IsSolid(scheme)) ExpectLimitsOfVertices(refiner, scheme, Elements::Cells, kLevels);
            ExpectLimitsOfVertices(refiner, scheme, Elements::BoundaryFaces, kLevels);
        }
    }
}

}  // namespace
}  // namespace SolidSubdiv::TestFar
