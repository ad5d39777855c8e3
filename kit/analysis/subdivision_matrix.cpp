// SPDX-License-Identifier: Apache-2.0
// Points of two levels that correspond are found by their places in the star, which piecewise linear refinement halves.
#include <solidsubdiv/kit/analysis/subdivision_matrix.h>

#include <algorithm>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include <solidsubdiv/far/stencil_table.h>

namespace SolidSubdiv::Analysis {

namespace {

/// A place in the star, in units of its level: a sum of numbers that stand for the star's vertices, modulo 2^64. Random
/// numbers make equal sums equal places, but for one chance in about 2^50.
using Place = std::uint64_t;

/// SplitMix64.
Place PlaceOfVertex(Index v) {
    Place z = (static_cast<Place>(v) + 1) * 0x9E3779B97F4A7C15u;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return z ^ (z >> 31);
}

/// Places of the children, in units half as long: an edge's point lies between its ends, an octahedron's centre between
/// the ends of its major diagonal.
std::vector<Place> PlacesOfChildren(const Far::Level& level, const std::vector<Place>& places) {
    std::vector<Place> children;
    children.reserve(places.size() + static_cast<std::size_t>(level.n_edges) + static_cast<std::size_t>(level.n_octs));
    for (Place p : places) children.push_back(2 * p);
    for (Index e = 0; e < level.n_edges; ++e) {
        const auto ends = level.EdgeVertices(e);
        children.push_back(places[ends[0]] + places[ends[1]]);
    }
    for (Index o = 0; o < level.n_octs; ++o) {
        const auto v = level.OctVertices(o);
        children.push_back(places[v[0]] + places[v[1]]);
    }
    return children;
}

}  // namespace

std::optional<Far::LocalMatrix> MatrixAround(const Far::TopologyRefiner& refiner, int level, Index vertex,
                                             const Sdc::Scheme& scheme) {
    const int last = refiner.max_level();
    if (level < 0 || level >= last || vertex < 0 || vertex >= refiner.level(level).n_vertices) {
        throw InvalidInput("vertex " + std::to_string(vertex) + " of level " + std::to_string(level) +
                           " is asked for; the refiner must have that vertex and a level after it");
    }
    std::vector<Place> places(static_cast<std::size_t>(refiner.level(level).n_vertices));
    for (Index v = 0; v < refiner.level(level).n_vertices; ++v) places[v] = v == vertex ? 0 : PlaceOfVertex(v);
    for (int l = level; l + 1 < last; ++l) places = PlacesOfChildren(refiner.level(l), places);
    std::unordered_map<Place, Index> child_at;
    const std::vector<Place> child_places = PlacesOfChildren(refiner.level(last - 1), places);
    for (std::size_t c = child_places.size(); c-- > 0;) child_at[child_places[c]] = static_cast<Index>(c);

    const Far::StencilTable table = Far::StencilTable::Create(refiner, scheme);
    const auto& rows = table.level(last);
    Far::LocalMatrix m;
    std::unordered_map<Index, std::size_t> column;
    const auto add = [&](Index v) {
        if (column.emplace(v, m.ring.size()).second) m.ring.push_back(v);
    };
    add(vertex);  // keeps its number through the levels
    const Far::Level& parent = refiner.level(last - 1);
    for (Index e : parent.vertex_edges[vertex]) {
        const auto ends = parent.EdgeVertices(e);
        add(ends[0] + ends[1] - vertex);
    }
    std::vector<Index> children;
    for (std::size_t i = 0; i < m.ring.size(); ++i) {
        const auto child = child_at.find(places[m.ring[i]]);
        if (child == child_at.end()) return std::nullopt;  // outside the star
        children.push_back(child->second);
        for (Index source : rows.Indices(child->second)) add(source);
    }

    const std::size_t n = m.ring.size();
    m.weights.assign(n * n, 0.0);
    for (std::size_t i = 0; i < n; ++i) {
        const auto indices = rows.Indices(children[i]);
        const auto weights = rows.Weights(children[i]);
        for (std::size_t k = 0; k < indices.size(); ++k) m.weights[i * n + column.at(indices[k])] += weights[k];
    }
    return m;
}

}  // namespace SolidSubdiv::Analysis
