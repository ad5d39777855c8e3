// SPDX-License-Identifier: Apache-2.0
// Regular pockets of tets and octahedra, and of triangles: unfolded by reflections.
#include <solidsubdiv/far/internal/regular_patch.h>

#include <algorithm>
#include <map>

#include <solidsubdiv/far/internal/unfolding.h>
#include <solidsubdiv/sdc/simplex_patch.h>

namespace SolidSubdiv::Far::Internal {

namespace {

using Simplex = std::vector<Index>;

/// Groups of two simplices that share a side: side -> simplices.
std::map<Simplex, std::vector<std::size_t>> SidesOf(const std::vector<Simplex>& simplices) {
    std::map<Simplex, std::vector<std::size_t>> sides;
    for (std::size_t i = 0; i < simplices.size(); ++i) {
        for (std::size_t k = 0; k < simplices[i].size(); ++k) {
            Simplex side = simplices[i];
            side.erase(side.begin() + static_cast<std::ptrdiff_t>(k));
            std::sort(side.begin(), side.end());
            sides[side].push_back(i);
        }
    }
    return sides;
}

/// Unfolds simplices from the first, whose vertices have the given points. `mirror` says where the vertex beyond a side
/// lies: mirror(side, vertex). False where that contradicts itself or not all are reached.
template <class Mirror>
bool Unfold(const std::vector<Simplex>& simplices, std::size_t first, std::span<const Point> corners,
            Unfolding& unfolding, Mirror&& mirror) {
    const auto sides = SidesOf(simplices);
    std::vector<bool> is_reached(simplices.size(), false);
    std::vector<std::size_t> queue{first};
    is_reached[first] = true;
    for (std::size_t k = 0; k < corners.size(); ++k) {
        if (!unfolding.Put(simplices[first][k], corners[k])) return false;
    }
    for (std::size_t head = 0; head < queue.size(); ++head) {
        const Simplex& s = simplices[queue[head]];
        for (std::size_t k = 0; k < s.size(); ++k) {
            Simplex side = s;
            side.erase(side.begin() + static_cast<std::ptrdiff_t>(k));
            std::vector<Point> points;
            for (Index v : side) points.push_back(unfolding[v]);
            const Point beyond = mirror(points, unfolding[s[k]]);
            std::sort(side.begin(), side.end());
            const auto& both = sides.at(side);
            if (both.size() > 2) return false;
            for (std::size_t other : both) {
                if (other == queue[head]) continue;
                for (Index v : simplices[other]) {
                    if (std::find(side.begin(), side.end(), v) == side.end() && !unfolding.Put(v, beyond)) return false;
                }
                if (!is_reached[other]) queue.push_back(other);
                is_reached[other] = true;
            }
        }
    }
    return queue.size() == simplices.size();
}

bool HasThinPartsOrCreases(const Pocket& p) {
    return p.faces.size() > 0 || !p.edges.empty() || !p.crease_edges.empty() || !p.corner_vertices.empty();
}

std::size_t CountWith(const std::vector<Simplex>& simplices, std::span<const Index> vertices) {
    return static_cast<std::size_t>(std::count_if(simplices.begin(), simplices.end(), [&](const Simplex& s) {
        return std::all_of(vertices.begin(), vertices.end(),
                           [&](Index v) { return std::find(s.begin(), s.end(), v) != s.end(); });
    }));
}

/// Vertices at the points of a patch; empty if one is missing.
std::vector<Index> VerticesAt(const Sdc::SimplexPatch& patch, const Unfolding& unfolding) {
    std::vector<Index> vertices;
    for (const Point& p : patch.points()) {
        vertices.push_back(unfolding.VertexAt(p));
        if (vertices.back() == kNoIndex) return {};
    }
    return vertices;
}

/// With octahedra as four tets around the major diagonal: an end of it is in all, another vertex in two.
int CountTetsAt(const Pocket& pocket, Index v) {
    int n = static_cast<int>(std::count(pocket.tets.begin(), pocket.tets.end(), v));
    for (std::size_t i = 0; i < pocket.octs.size(); ++i) {
        if (pocket.octs[i] == v) n += i % 6 < 2 ? 4 : 2;
    }
    return n;
}

}  // namespace

std::optional<RegularPatch> RegularPatch::FindTets(const Pocket& pocket) {
    if (HasThinPartsOrCreases(pocket)) return std::nullopt;
    constexpr int kTetsAtVertex = 24;
    for (Index v = 0; v < pocket.n_root_vertices; ++v) {
        // Most pockets end here, before anything is built.
        if (CountTetsAt(pocket, v) != kTetsAtVertex) return std::nullopt;
    }
    // Octahedra as four tets around the major diagonal: pairs of B edges first.
    std::vector<Simplex> tets;
    for (std::size_t t = 0; t < pocket.tets.size(); t += 4) {
        tets.push_back({pocket.tets.begin() + static_cast<std::ptrdiff_t>(t),
                        pocket.tets.begin() + static_cast<std::ptrdiff_t>(t + 4)});
    }
    const std::size_t first_of_octs = tets.size();
    for (std::size_t o = 0; o < pocket.octs.size(); o += 6) {
        const Index* v = pocket.octs.data() + o;
        for (std::size_t q = 0; q < kQuarters; ++q) tets.push_back({v[0], v[1], v[2 + (q & 1)], v[4 + (q >> 1)]});
    }
    const auto mirror = [](const std::vector<Point>& side, const Point& vertex) {
        const Point normal = Cross(side[1] - side[0], side[2] - side[0]);
        const int twice = 2 * Dot(vertex - side[0], normal), length = Dot(normal, normal);
        return vertex - Point{twice * normal[0] / length, twice * normal[1] / length, twice * normal[2] / length};
    };
    RegularPatch patch;
    const bool is_oct = pocket.root == RootKind::Oct;
    patch.kind_ = is_oct ? Kind::Oct : Kind::Tet;
    const Sdc::SimplexPatch& spline = Sdc::QuinticTet();
    for (std::size_t q = 0; q < (is_oct ? kQuarters : 1); ++q) {
        Unfolding unfolding(pocket.n_vertices());
        if (!Unfold(tets, is_oct ? first_of_octs + q : 0, spline.corners(), unfolding, mirror)) return std::nullopt;
        const auto is_b_edge = [&](Index a, Index b) {
            const Point d = unfolding[a] - unfolding[b];
            return Dot(d, d) == 4;
        };
        if (!std::all_of(tets.begin(), tets.end(),
                         [&](const Simplex& t) { return is_b_edge(t[0], t[1]) && is_b_edge(t[2], t[3]); })) {
            return std::nullopt;
        }
        for (std::size_t e = 0; e < pocket.complete_edges.size(); e += 2) {
            const std::span<const Index> ends(pocket.complete_edges.data() + e, 2);
            if (CountWith(tets, ends) != (is_b_edge(ends[0], ends[1]) ? 4u : 6u)) return std::nullopt;
        }
        const std::vector<Index> vertices = VerticesAt(spline, unfolding);
        if (vertices.empty()) return std::nullopt;
        patch.points_.insert(patch.points_.end(), vertices.begin(), vertices.end());
    }
    return patch;
}

std::optional<RegularPatch> RegularPatch::FindTriangles(const Pocket& pocket) {
    constexpr std::size_t kTrianglesAtVertex = 6;
    if (!pocket.edges.empty() || !pocket.crease_edges.empty() || !pocket.corner_vertices.empty()) return std::nullopt;
    std::vector<Simplex> triangles;
    for (Index f = 0; f < pocket.faces.size(); ++f) {
        triangles.emplace_back(pocket.faces[f].begin(), pocket.faces[f].end());
    }
    for (Index v = 0; v < pocket.n_root_vertices; ++v) {
        if (CountWith(triangles, {&v, 1}) != kTrianglesAtVertex) return std::nullopt;
    }
    const Sdc::SimplexPatch& spline = Sdc::QuarticTriangle();
    Unfolding unfolding(pocket.n_vertices());
    if (!Unfold(triangles, 0, spline.corners(), unfolding,
                [](const std::vector<Point>& side, const Point& vertex) { return side[0] + side[1] - vertex; })) {
        return std::nullopt;
    }
    RegularPatch patch;
    patch.kind_ = Kind::Triangle;
    patch.dimension_ = 2;
    patch.points_ = VerticesAt(spline, unfolding);
    if (patch.points_.empty()) return std::nullopt;
    return patch;
}

}  // namespace SolidSubdiv::Far::Internal
