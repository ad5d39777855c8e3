// SPDX-License-Identifier: Apache-2.0
// Places are vectors that a handful of free numbers span; numbers modulo a prime stand for them.
#include <solidsubdiv/kit/analysis/internal/neighborhood.h>

#include <algorithm>
#include <span>

namespace SolidSubdiv::Analysis::Internal {

namespace {

/// A linear combination of random numbers modulo a prime, where halves and thirds are exact. Equal sums are equal
/// places, but for one chance in about 2^40 for a million points.
using Place = std::uint64_t;
constexpr Place kPrime = (Place{1} << 61) - 1;
__extension__ using Wide = unsigned __int128;

Place Add(Place a, Place b) { return (a + b) % kPrime; }
Place Subtract(Place a, Place b) { return (a + kPrime - b) % kPrime; }
Place Times(Place a, Place b) { return static_cast<Place>(static_cast<Wide>(a) * b % kPrime); }
Place Half(Place a) { return a % 2 == 0 ? a / 2 : (a + kPrime) / 2; }

/// 1/n, by Fermat.
Place Inverse(Place n) {
    Place inverse = 1;
    for (Place e = kPrime - 2; e > 0; e /= 2, n = Times(n, n)) {
        if (e % 2 == 1) inverse = Times(inverse, n);
    }
    return inverse;
}

/// SplitMix64.
Place Random(Index v) {
    Place z = (static_cast<Place>(v) + 1) * 0x9E3779B97F4A7C15u;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return (z ^ (z >> 31)) % kPrime;
}

Place Mean(const std::vector<Place>& places, std::span<const Index> vertices) {
    Place sum = 0;
    for (Index v : vertices) sum = Add(sum, places[v]);
    const std::size_t n = vertices.size();
    if (n == 4) return Half(Half(sum));
    if (n == 8) return Half(Half(Half(sum)));
    return Times(sum, Inverse(n));
}

/// Of the children, in their order.
std::vector<Place> PlacesOfChildren(const Far::TopologyRefiner& refiner, int l, std::vector<Place> places) {
    const auto add_edges = [&](const auto& level) {
        for (Index e = 0; e < level.n_edges; ++e) {
            const auto ends = level.EdgeVertices(e);
            places.push_back(Half(Add(places[ends[0]], places[ends[1]])));
        }
    };
    places.reserve(static_cast<std::size_t>(refiner.n_vertices(l + 1)));
    if (!refiner.is_polyhedral()) {
        const Far::Level& level = refiner.level(l);
        add_edges(level);
        for (Index o = 0; o < level.n_octs; ++o) {
            const auto v = level.OctVertices(o);
            places.push_back(Half(Add(places[v[0]], places[v[1]])));
        }
        return places;
    }
    const Vtr::PolyhedralLevel& level = refiner.polyhedral_level(l);
    add_edges(level);
    for (Index f = 0; f < level.n_faces; ++f) places.push_back(Mean(places, level.FaceVertices(f)));
    for (Index c = 0; c < static_cast<Index>(level.n_cells()); ++c) {
        places.push_back(Mean(places, level.CellVertices(c)));
    }
    return places;
}

bool Contains(std::span<const Index> list, Index v) { return std::find(list.begin(), list.end(), v) != list.end(); }

/// Octahedra at the vertex are affine ones, so that their centres lie half-way to the opposite vertices.
void PlaceOctahedra(const Far::Level& level, Index vertex, std::vector<Place>& places) {
    for (Index o : level.vertex_octs[vertex]) {
        const auto v = level.OctVertices(o);
        for (std::size_t k = 0; k < 6; ++k) {
            const std::size_t other = k < 2 ? 2 : 0;  // a pair, if possible the major diagonal
            if (v[k] == vertex) places[v[k ^ 1]] = Add(places[v[other]], places[v[other + 1]]);
        }
    }
}

/// Faces of four vertices are parallelograms, and a cell at whose corner n edges meet has its far corner where its
/// centroid lies half-way: at 3/n of the sum of the edges.
void PlacePolyhedra(const Vtr::PolyhedralLevel& level, Index vertex, std::vector<Place>& places) {
    std::vector<Index> near_ones{vertex}, edge_ends, far_corners;
    for (Index e : level.vertex_edges[vertex]) {
        edge_ends.push_back(level.OtherEnd(e, vertex));
        for (Index f : level.edge_faces[e]) {
            const auto v = level.FaceVertices(f);
            if (v.size() != 4) continue;
            const std::size_t k = static_cast<std::size_t>(std::find(v.begin(), v.end(), vertex) - v.begin());
            places[v[(k + 2) % 4]] = Add(places[v[(k + 1) % 4]], places[v[(k + 3) % 4]]);
            far_corners.push_back(v[(k + 2) % 4]);
        }
    }
    near_ones.insert(near_ones.end(), edge_ends.begin(), edge_ends.end());
    near_ones.insert(near_ones.end(), far_corners.begin(), far_corners.end());
    for (Index c : level.vertex_cells[vertex]) {
        Place sum = 0;
        std::size_t n = 0;
        std::vector<Index> far_ones;
        for (Index v : level.CellVertices(c)) {
            if (Contains(edge_ends, v)) sum = Add(sum, places[v]), ++n;
            if (!Contains(near_ones, v)) far_ones.push_back(v);
        }
        if (far_ones.size() == 1) places[far_ones[0]] = n == 3 ? sum : Times(sum, Times(3, Inverse(n)));
    }
}

/// Vertices 1 and 2 lie opposite each other, and what is next to 2 one step above what it joins next to 1.
void PlaceAlong(const Vtr::EdgeGraph& graph, std::vector<Place>& places) {
    places[1] = Subtract(0, places[2]);
    for (Index e : graph.vertex_edges[1]) {
        const auto ends = graph.EdgeVertices(e);
        const Index below = ends[0] + ends[1] - 1;
        if (below == 0) continue;
        for (Index f : graph.vertex_edges[below]) {
            const Index above = graph.EdgeVertices(f)[0] + graph.EdgeVertices(f)[1] - below;
            if (above > 2 && graph.FindEdge(above, 2) != kNoIndex) places[above] = Add(places[below], places[2]);
        }
    }
}

}  // namespace

Neighborhood::Neighborhood(const Far::TopologyRefiner& refiner, int level, Index vertex, int ring_level,
                           bool is_on_edge) {
    const Index n = refiner.n_vertices(level);
    places_.resize(static_cast<std::size_t>(n));
    for (Index v = 0; v < n; ++v) places_[v] = Random(v);
    const Place origin = places_[vertex];
    for (Place& p : places_) p = Subtract(p, origin);
    if (is_on_edge) PlaceAlong(refiner.graph(level), places_);
    step_ = places_[2];
    if (refiner.is_polyhedral()) {
        PlacePolyhedra(refiner.polyhedral_level(level), vertex, places_);
    } else {
        PlaceOctahedra(refiner.level(level), vertex, places_);
    }
    for (int l = level; l < ring_level; ++l) {
        places_ = PlacesOfChildren(refiner, l, std::move(places_));
        step_ = Half(step_);
    }
    const std::vector<Place> next = PlacesOfChildren(refiner, ring_level, places_);
    point_at_.reserve(next.size());
    for (std::size_t v = 0; v < next.size(); ++v) point_at_.emplace(next[v], static_cast<Index>(v));
}

Index Neighborhood::Successor(Index v) const {
    const auto found = point_at_.find(Half(places_[v]));
    return found == point_at_.end() ? kNoIndex : found->second;
}

std::optional<Far::LocalMatrix> Neighborhood::Close(std::vector<Index> start,
                                                    const Far::StencilRows<double>& rows) const {
    Far::LocalMatrix m;
    m.ring = std::move(start);
    std::unordered_map<Index, std::size_t> column;
    for (Index v : m.ring) column.emplace(v, column.size());
    std::vector<Index> successors;
    for (std::size_t i = 0; i < m.ring.size(); ++i) {
        const Index next = Successor(m.ring[i]);
        if (next == kNoIndex) return std::nullopt;
        successors.push_back(next);
        for (Index source : rows.Indices(next)) {
            if (column.emplace(source, m.ring.size()).second) m.ring.push_back(source);
        }
    }
    const std::size_t n = m.ring.size();
    m.weights.assign(n * n, 0.0);
    for (std::size_t i = 0; i < n; ++i) {
        const auto indices = rows.Indices(successors[i]);
        const auto weights = rows.Weights(successors[i]);
        for (std::size_t k = 0; k < indices.size(); ++k) m.weights[i * n + column.at(indices[k])] += weights[k];
    }
    return m;
}

std::vector<std::pair<std::size_t, std::size_t>> Neighborhood::StepsAlong(const std::vector<Index>& points) const {
    std::unordered_map<Place, std::size_t> at;
    for (std::size_t i = 0; i < points.size(); ++i) at.emplace(places_[points[i]], i);
    std::vector<std::pair<std::size_t, std::size_t>> steps;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto next = at.find(Add(places_[points[i]], step_));
        if (next != at.end()) steps.emplace_back(i, next->second);
    }
    return steps;
}

std::vector<Index> RingOf(const Far::TopologyRefiner& refiner, int level, Index vertex) {
    std::vector<Index> ring{vertex};
    const auto add = [&](Index v) {
        if (!Contains(ring, v)) ring.push_back(v);
    };
    const Vtr::EdgeGraph graph = refiner.graph(level);
    for (Index e : graph.vertex_edges[vertex]) {
        const auto ends = graph.EdgeVertices(e);
        add(ends[0] + ends[1] - vertex);
    }
    if (!refiner.is_polyhedral()) return ring;
    const Vtr::PolyhedralLevel& l = refiner.polyhedral_level(level);
    for (Index e : l.vertex_edges[vertex]) {
        for (Index f : l.edge_faces[e]) {
            if (!Contains(l.FaceVertices(f), vertex)) continue;
            for (Index v : l.FaceVertices(f)) add(v);
        }
    }
    for (Index c : l.vertex_cells[vertex]) {
        for (Index v : l.CellVertices(c)) add(v);
    }
    return ring;
}

}  // namespace SolidSubdiv::Analysis::Internal
