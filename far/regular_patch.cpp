// SPDX-License-Identifier: Apache-2.0
// Regular pockets are recognized by unfolding them into the lattice, and evaluated there.
#include <solidsubdiv/far/internal/regular_patch.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>

#include <solidsubdiv/sdc/creases.h>
#include <solidsubdiv/sdc/simplex_patch.h>

namespace SolidSubdiv::Far::Internal {

namespace {

using At = std::array<double, 3>;
using Point = std::array<int, 3>;

/// Where vertices lie in the lattice; refuses what contradicts itself.
class Unfolding {
  public:
    explicit Unfolding(Index n_vertices) : points_(static_cast<std::size_t>(n_vertices)) {}

    bool Has(Index v) const { return points_[static_cast<std::size_t>(v)].has_value(); }
    const Point& operator[](Index v) const { return *points_[static_cast<std::size_t>(v)]; }
    /// False if the vertex is elsewhere, or the place taken.
    bool Put(Index v, const Point& p) {
        auto& point = points_[static_cast<std::size_t>(v)];
        if (point) return *point == p;
        point = p;
        return vertices_.emplace(p, v).second;
    }
    Index VertexAt(const Point& p) const {
        const auto found = vertices_.find(p);
        return found == vertices_.end() ? kNoIndex : found->second;
    }

  private:
    std::vector<std::optional<Point>> points_;
    std::map<Point, Index> vertices_;
};

Point operator+(const Point& a, const Point& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
Point operator-(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
int Dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Point Cross(const Point& a, const Point& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

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

/// Adds a patch's weights to the block's rows.
void Scatter(const double* weights, std::span<const Index> vertices, LimitBlock& block) {
    const std::size_t n = vertices.size();
    for (std::size_t p = 0; p < n; ++p) {
        double* row = block.Row(vertices[p]);
        for (std::size_t c = 0; c < static_cast<std::size_t>(block.n_columns); ++c) row[c] += weights[c * n + p];
    }
}

}  // namespace

void ChangeCoordinates(const std::array<std::array<double, 3>, 3>& by, int dimension, int order, std::size_t n,
                       double* weights) {
    const std::size_t d = static_cast<std::size_t>(dimension);
    const auto second = [&](std::size_t a, std::size_t b) {  // column of the derivative by a and b
        if (a > b) std::swap(a, b);
        return 1 + d + (a == 0 ? b : a == 1 ? d + b - 1 : 2 * d - 1);
    };
    for (std::size_t p = 0; order >= 1 && p < n; ++p) {
        std::array<double, 10> old{}, fresh{};
        const std::size_t n_columns = static_cast<std::size_t>(1 + Sdc::SimplexPatch::NDerivatives(dimension, order));
        for (std::size_t c = 0; c < n_columns; ++c) old[c] = weights[c * n + p];
        fresh[0] = old[0];
        for (std::size_t a = 0; a < d; ++a) {
            for (std::size_t i = 0; i < d; ++i) fresh[1 + a] += by[i][a] * old[1 + i];
            for (std::size_t b = a; order >= 2 && b < d; ++b) {
                for (std::size_t i = 0; i < d; ++i) {
                    for (std::size_t k = 0; k < d; ++k) {
                        fresh[second(a, b)] += by[i][a] * by[k][b] * old[second(i, k)];
                    }
                }
            }
        }
        for (std::size_t c = 0; c < n_columns; ++c) weights[c * n + p] = fresh[c];
    }
}

namespace {

/// The four tets of an octahedron around its major diagonal: which of (v2, v3) and (v4, v5) they have.
constexpr std::size_t kQuarters = 4;
std::size_t QuarterOf(const At& at) { return (at[1] < 0 ? 1u : 0u) + (at[2] < 0 ? 2u : 0u); }

}  // namespace

RegularRule RegularRuleOf(const Sdc::Scheme& scheme, Elements elements) {
    return std::visit(
        [&]<class S>(const S& s) {
            if constexpr (std::is_same_v<S, Sdc::LinearSolid> || std::is_same_v<S, Sdc::LinearSurface>) {
                return RegularRule::Linear;
            } else if constexpr (requires { s.polyhedral(); }) {
                return RegularRule::Cubic;
            } else if constexpr (std::is_same_v<decltype(s.surface()), Sdc::LoopSurface>) {
                if (elements == Elements::BoundaryFaces) return RegularRule::BoxSpline;
                if constexpr (std::is_same_v<S, Sdc::BoxSpline>) {
                    const bool is_box_spline =
                        s.edge_rule == Sdc::EdgeRule::BoxSpline && s.diagonals == Sdc::Diagonals::Directional;
                    return is_box_spline ? RegularRule::BoxSpline : RegularRule::None;
                }
                return RegularRule::None;
            } else {
                return RegularRule::None;
            }
        },
        scheme);
}

int NDerivatives(Elements elements, int order) {
    return Sdc::SimplexPatch::NDerivatives(elements == Elements::Cells ? 3 : 2, order);
}

std::optional<RegularPatch> RegularPatch::Find(const Pocket& pocket, RegularRule rule) {
    const bool has_cells =
        !pocket.tets.empty() || !pocket.octs.empty() || !pocket.hexes.empty() || pocket.cell_offsets.size() > 1;
    if (pocket.root == RootKind::Face && has_cells) return std::nullopt;
    switch (rule) {
        case RegularRule::BoxSpline:
            return pocket.root == RootKind::Face ? FindTriangles(pocket) : FindTets(pocket);
        case RegularRule::Cubic:
            return FindGrid(pocket);
        case RegularRule::Linear:
            return FindLinear(pocket);
        default:
            return std::nullopt;
    }
}

std::optional<RegularPatch> RegularPatch::FindTets(const Pocket& pocket) {
    if (HasThinPartsOrCreases(pocket)) return std::nullopt;
    constexpr std::size_t kTetsAtVertex = 24;
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
    for (Index v = 0; v < pocket.n_root_vertices; ++v) {
        if (CountWith(tets, {&v, 1}) != kTetsAtVertex) return std::nullopt;
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

namespace {

/// Squares and cubes around the root, unfolded; they stop at creases for ever.
struct Grid {
    int dimension;
    std::size_t n_corners;
    std::vector<std::vector<Index>> cells;  ///< corners in the order of axes: bit a is coordinate a
    std::vector<Point> cell_points;         ///< least corners
    Unfolding unfolding;
};

/// Corners in the order of axes.
std::vector<Index> InAxes(std::span<const Index> corners) {
    if (corners.size() == 4) return {corners[0], corners[1], corners[3], corners[2]};
    return {corners[0], corners[1], corners[3], corners[2], corners[4], corners[5], corners[7], corners[6]};
}

bool IsInfiniteCrease(const Pocket& pocket, Index a, Index b) {
    for (std::size_t i = 0; i < pocket.crease_sharpness.size(); ++i) {
        const Index c = pocket.crease_edges[2 * i], d = pocket.crease_edges[2 * i + 1];
        if ((c == a && d == b) || (c == b && d == a)) return Sdc::IsInfinitelySharp(pocket.crease_sharpness[i]);
    }
    return false;
}

/// Puts the root's neighbours next to it, side by side. False where that contradicts itself.
bool UnfoldGrid(const Pocket& pocket, Grid& grid) {
    const std::size_t d = static_cast<std::size_t>(grid.dimension);
    std::map<Simplex, std::vector<std::size_t>> sides;
    const auto side_of = [&](const std::vector<Index>& cell, std::size_t axis, std::size_t end) {
        Simplex side;
        for (std::size_t i = 0; i < grid.n_corners; ++i) {
            if ((i >> axis & 1) == end) side.push_back(cell[i]);
        }
        return side;
    };
    const auto sorted = [](Simplex side) {
        std::sort(side.begin(), side.end());
        return side;
    };
    for (std::size_t c = 0; c < grid.cells.size(); ++c) {
        for (std::size_t a = 0; a < d; ++a) {
            for (std::size_t end : {0u, 1u}) sides[sorted(side_of(grid.cells[c], a, end))].push_back(c);
        }
    }
    for (std::size_t i = 0; i < grid.n_corners; ++i) {
        const Point p{static_cast<int>(i & 1), static_cast<int>(i >> 1 & 1), static_cast<int>(i >> 2)};
        if (!grid.unfolding.Put(grid.cells[0][i], p)) return false;
    }
    std::vector<bool> is_reached(grid.cells.size(), false);
    std::vector<std::size_t> queue{0};
    is_reached[0] = true;
    for (std::size_t head = 0; head < queue.size(); ++head) {
        const std::vector<Index>& cell = grid.cells[queue[head]];
        // Far corners of a neighbour are those of this cell, reflected; its own order of corners does not count.
        for (std::size_t a = 0; a < d; ++a) {
            for (std::size_t end : {0u, 1u}) {
                const Simplex side = side_of(cell, a, end), inner = side_of(cell, a, 1 - end);
                if (d == 2 && IsInfiniteCrease(pocket, side[0], side[1])) continue;
                const auto& both = sides.at(sorted(side));
                if (both.size() > 2) return false;
                for (std::size_t other : both) {
                    if (other == queue[head]) continue;
                    for (std::size_t i = 0; i < side.size(); ++i) {
                        // The corner of the neighbour that an edge joins to side[i] and is not on the side.
                        const auto& corners = grid.cells[other];
                        const std::size_t at = static_cast<std::size_t>(
                            std::find(corners.begin(), corners.end(), side[i]) - corners.begin());
                        for (std::size_t b = 0; b < d; ++b) {
                            const Index beyond = corners[at ^ (std::size_t{1} << b)];
                            if (std::find(side.begin(), side.end(), beyond) != side.end()) continue;
                            const Point p =
                                grid.unfolding[side[i]] + grid.unfolding[side[i]] - grid.unfolding[inner[i]];
                            if (!grid.unfolding.Put(beyond, p)) return false;
                        }
                    }
                    if (!is_reached[other]) queue.push_back(other);
                    is_reached[other] = true;
                }
            }
        }
    }
    for (std::size_t c : queue) {
        Point least = grid.unfolding[grid.cells[c][0]];
        for (Index v : grid.cells[c]) {
            for (std::size_t a = 0; a < 3; ++a) least[a] = std::min(least[a], grid.unfolding[v][a]);
        }
        grid.cell_points.push_back(least);
    }
    return d == 2 || queue.size() == grid.cells.size();
}

/// Whether creases and corners at one of the root's vertices are those of a tensor product of curves that end, each
/// with its last point: no crease inside and on smooth sides, a crease where the mesh ends on both sides of it, a
/// corner where it ends along all axes.
bool HasTensorRule(const Pocket& pocket, const Grid& grid, const std::array<std::array<bool, 2>, 3>& ends, Index v) {
    const std::size_t d = static_cast<std::size_t>(grid.dimension);
    const Point p = grid.unfolding[v];
    std::size_t n_ends = 0, free_axis = 0;
    for (std::size_t a = 0; a < d; ++a) {
        if (ends[a][static_cast<std::size_t>(p[a])])
            ++n_ends;
        else
            free_axis = a;
    }
    // The edges at v that are creases for ever, or end a surface.
    std::vector<Index> others;
    for (std::size_t i = 0; i < pocket.crease_sharpness.size(); ++i) {
        const Index a = pocket.crease_edges[2 * i], b = pocket.crease_edges[2 * i + 1];
        if (a != v && b != v) continue;
        if (!Sdc::IsInfinitelySharp(pocket.crease_sharpness[i])) return false;
        others.push_back(a == v ? b : a);
    }
    if (d == 2) {
        std::map<Index, int> n_faces;  // of the edge to each neighbour
        for (Index f = 0; f < pocket.faces.size(); ++f) {
            const auto corners = pocket.faces[f];
            const std::size_t n = corners.size();
            for (std::size_t i = 0; i < n; ++i) {
                if (corners[i] == v) ++n_faces[corners[(i + 1) % n]], ++n_faces[corners[(i + n - 1) % n]];
            }
        }
        for (const auto& [other, n] : n_faces) {
            if (n > 2) return false;
            if (n == 1) others.push_back(other);
        }
    }
    const auto corner = std::find(pocket.corner_vertices.begin(), pocket.corner_vertices.end(), v);
    const bool is_sharp = corner != pocket.corner_vertices.end();
    if (is_sharp) {
        const auto i = static_cast<std::size_t>(corner - pocket.corner_vertices.begin());
        if (!Sdc::IsInfinitelySharp(pocket.corner_sharpness[i])) return false;
    }
    if (n_ends == d) return is_sharp || others.size() > 2;
    if (is_sharp) return false;
    if (n_ends + 1 < d) return others.empty();
    return others.size() == 2 && std::all_of(others.begin(), others.end(), [&](Index other) {
               if (!grid.unfolding.Has(other)) return false;
               const Point step = grid.unfolding[other] - p;
               return std::abs(step[free_axis]) == 1 && Dot(step, step) == 1;
           });
}

/// Uniform cubic B-splines at x in [0, 1] and their two derivatives: weights of the points -1, 0, 1, 2. At an end the
/// point beyond is the last but one, reflected.
std::array<std::array<double, 4>, 3> CubicBasis(double x, const std::array<bool, 2>& ends) {
    const double y = 1 - x;
    std::array<std::array<double, 4>, 3> basis{
        {{y * y * y / 6, (4 - 3 * x * x * (2 - x)) / 6, (4 - 3 * y * y * (2 - y)) / 6, x * x * x / 6},
         {-y * y / 2, x * (3 * x - 4) / 2, y * (4 - 3 * y) / 2, x * x / 2},
         {y, 3 * x - 2, 3 * y - 2, x}}};
    for (auto& b : basis) {
        if (ends[0]) {
            b[1] += 2 * b[0];
            b[2] -= b[0];
            b[0] = 0;
        }
        if (ends[1]) {
            b[2] += 2 * b[3];
            b[1] -= b[3];
            b[3] = 0;
        }
    }
    return basis;
}

}  // namespace

std::optional<RegularPatch> RegularPatch::FindGrid(const Pocket& pocket) {
    const bool is_face = pocket.root == RootKind::Face;
    if (!pocket.edges.empty() || (!is_face && pocket.root != RootKind::Hex)) return std::nullopt;
    const std::size_t n_corners = is_face ? 4 : 8, d = is_face ? 2 : 3;
    Grid grid{static_cast<int>(d), n_corners, {}, {}, Unfolding(pocket.n_vertices())};
    if (is_face) {
        for (Index f = 0; f < pocket.faces.size(); ++f) {
            if (pocket.faces[f].size() != n_corners) return std::nullopt;
            grid.cells.push_back(InAxes(pocket.faces[f]));
        }
    } else {
        if (pocket.faces.size() > 0 || pocket.cell_offsets.size() > 1) return std::nullopt;
        for (std::size_t h = 0; h < pocket.hexes.size(); h += 8) {
            grid.cells.push_back(InAxes({pocket.hexes.data() + h, n_corners}));
        }
    }
    if (!UnfoldGrid(pocket, grid)) return std::nullopt;

    // The cells reached must fill a box around the root, one cell wide on the sides where the mesh goes on.
    RegularPatch patch;
    patch.kind_ = Kind::Grid;
    patch.dimension_ = static_cast<int>(d);
    Point low{}, high{};
    for (const Point& p : grid.cell_points) {
        for (std::size_t a = 0; a < d; ++a) {
            low[a] = std::min(low[a], p[a]);
            high[a] = std::max(high[a], p[a]);
        }
    }
    std::size_t n_cells = 1;
    for (std::size_t a = 0; a < d; ++a) {
        if (low[a] < -1 || high[a] > 1) return std::nullopt;
        patch.ends_[a] = {low[a] == 0, high[a] == 0};
        n_cells *= static_cast<std::size_t>(high[a] - low[a] + 1);
    }
    std::vector<Point> unique = grid.cell_points;
    std::sort(unique.begin(), unique.end());
    unique.erase(std::unique(unique.begin(), unique.end()), unique.end());
    if (unique.size() != n_cells || grid.cell_points.size() != n_cells) return std::nullopt;

    for (Index v = 0; v < pocket.n_root_vertices; ++v) {
        if (!HasTensorRule(pocket, grid, patch.ends_, v)) return std::nullopt;
    }
    const int depth = is_face ? 1 : 4;
    for (int k = 0; k < depth; ++k) {
        for (int j = 0; j < 4; ++j) {
            for (int i = 0; i < 4; ++i) {
                patch.points_.push_back(grid.unfolding.VertexAt({i - 1, j - 1, is_face ? 0 : k - 1}));
            }
        }
    }
    return patch;
}

std::optional<RegularPatch> RegularPatch::FindLinear(const Pocket& pocket) {
    RegularPatch patch;
    const auto take = [&](std::span<const Index> corners) {
        patch.points_.assign(corners.begin(), corners.end());
        const bool is_simplex = pocket.root == RootKind::Tet || corners.size() == 3;
        patch.kind_ = is_simplex ? Kind::LinearSimplex : Kind::LinearGrid;
        if (!is_simplex) patch.points_ = InAxes(corners);
    };
    if (pocket.root == RootKind::Tet) {
        take({pocket.tets.data(), 4});
    } else if (pocket.root == RootKind::Hex) {
        take({pocket.hexes.data(), 8});
    } else if (pocket.root == RootKind::Face && (pocket.n_root_vertices == 4 || pocket.is_tet_oct)) {
        take(pocket.faces[0]);
        patch.dimension_ = 2;
    } else {
        return std::nullopt;
    }
    return patch;
}

void RegularPatch::Evaluate(const At& at, int order, LimitBlock& block) const {
    const std::size_t n_columns = static_cast<std::size_t>(block.n_columns);
    switch (kind_) {
        case Kind::Tet:
        case Kind::Triangle: {
            std::array<double, 10 * 32> weights;
            (kind_ == Kind::Tet ? Sdc::QuinticTet() : Sdc::QuarticTriangle()).Evaluate(at, order, weights.data());
            return Scatter(weights.data(), points_, block);
        }
        case Kind::Oct:
            return EvaluateOct(at, order, block);
        case Kind::Grid:
        case Kind::LinearGrid:
            return EvaluateGrid(at, order, block);
        case Kind::LinearSimplex: {
            double rest = 1;
            for (std::size_t i = 1; i < points_.size(); ++i) {
                double* row = block.Row(points_[i]);
                row[0] += at[i - 1];
                rest -= at[i - 1];
                if (n_columns > 1) {
                    row[i] += 1;
                    block.Row(points_[0])[i] -= 1;
                }
            }
            block.Row(points_[0])[0] += rest;
        }
    }
}

/// In the quarter of the point the major diagonal's ends weigh (rest + u) / 2 and (rest - u) / 2, the others |v|, |w|.
void RegularPatch::EvaluateOct(const At& at, int order, LimitBlock& block) const {
    constexpr std::size_t kPoints = 32;
    const std::size_t q = QuarterOf(at);
    const double v = std::abs(at[1]), w = std::abs(at[2]);
    const double dv = at[1] < 0 ? -1 : 1, dw = at[2] < 0 ? -1 : 1;
    std::array<double, 10 * kPoints> weights;
    Sdc::QuinticTet().Evaluate({(1 - v - w - at[0]) / 2, v, w}, order, weights.data());
    // The tet's coordinates by the octahedron's.
    const std::array<std::array<double, 3>, 3> by{{{-0.5, -0.5 * dv, -0.5 * dw}, {0, dv, 0}, {0, 0, dw}}};
    ChangeCoordinates(by, 3, order, kPoints, weights.data());
    Scatter(weights.data(), {points_.data() + q * kPoints, kPoints}, block);
}

void RegularPatch::EvaluateGrid(const At& at, int order, LimitBlock& block) const {
    const std::size_t d = static_cast<std::size_t>(dimension_);
    const bool is_linear = kind_ == Kind::LinearGrid;
    const int n = is_linear ? 2 : 4;
    std::array<std::array<std::array<double, 4>, 3>, 3> basis{};  // of each axis and order
    for (std::size_t a = 0; a < 3; ++a) {
        if (a >= d) {
            basis[a][0][0] = 1;
        } else if (is_linear) {
            basis[a][0] = {1 - at[a], at[a], 0, 0};
            basis[a][1] = {-1, 1, 0, 0};
        } else {
            basis[a] = CubicBasis(at[a], ends_[a]);
        }
    }
    std::array<std::array<std::size_t, 3>, 10> columns{};  // orders along the axes
    std::size_t n_columns = 1;
    for (std::size_t a = 0; order >= 1 && a < d; ++a) ++columns[n_columns++][a];
    for (std::size_t a = 0; order >= 2 && a < d; ++a) {
        for (std::size_t b = a; b < d; ++b) ++columns[n_columns][a], ++columns[n_columns++][b];
    }
    std::size_t point = 0;
    const int depth = d == 3 ? n : 1;
    for (int k = 0; k < depth; ++k) {
        for (int j = 0; j < n; ++j) {
            for (int i = 0; i < n; ++i, ++point) {
                if (points_[point] == kNoIndex) continue;
                double* row = block.Row(points_[point]);
                for (std::size_t c = 0; c < n_columns; ++c) {
                    row[c] += basis[0][columns[c][0]][i] * basis[1][columns[c][1]][j] * basis[2][columns[c][2]][k];
                }
            }
        }
    }
}

}  // namespace SolidSubdiv::Far::Internal
