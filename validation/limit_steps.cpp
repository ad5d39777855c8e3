// SPDX-License-Identifier: Apache-2.0
// Steps in tets, octahedra and triangles by affine frames, among polyhedra along paths of edges.
#include "limit_steps.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <stdexcept>

namespace SolidSubdiv::Validation {

namespace {

Vector3 Mean(const Vector3& a, const Vector3& b) { return {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2}; }
Vector3 Minus(const Vector3& a, const Vector3& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

Matrix3 Product(const Matrix3& a, const Matrix3& b) {
    Matrix3 p{};
    for (std::size_t r = 0; r < 3; ++r) {
        for (std::size_t c = 0; c < 3; ++c) {
            for (std::size_t k = 0; k < 3; ++k) p[r][c] += a[r][k] * b[k][c];
        }
    }
    return p;
}

Matrix3 InverseOfColumns(const Vector3& a, const Vector3& b, const Vector3& c) {
    const auto cross = [](const Vector3& x, const Vector3& y) {
        return Vector3{x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]};
    };
    Matrix3 rows = {cross(b, c), cross(c, a), cross(a, b)};
    const double det = a[0] * rows[0][0] + a[1] * rows[0][1] + a[2] * rows[0][2];
    for (Vector3& row : rows) {
        for (double& x : row) x /= det;
    }
    return rows;
}

bool HasAll(std::span<const Index> all, std::span<const Index> some) {
    return std::all_of(some.begin(), some.end(),
                       [&](Index v) { return std::find(all.begin(), all.end(), v) != all.end(); });
}

// Tets, octahedra and triangles.

std::vector<Vector3> CornersOf(std::size_t n_vertices) {
    if (n_vertices == 6) return {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    std::vector<Vector3> corners = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    corners.resize(n_vertices);
    return corners;
}

/// How far inside, by the element's own coordinates.
double Depth(std::size_t n_vertices, const Vector3& at) {
    const auto [u, v, w] = at;
    if (n_vertices == 6) return 1 - std::abs(u) - std::abs(v) - std::abs(w);
    if (n_vertices == 3) return std::min({u, v, 1 - u - v});
    return std::min({u, v, w, 1 - u - v - w});
}

class SimplexStep {
  public:
    SimplexStep(const Far::TopologyRefiner& refiner, const PlaceByVertices& parent, std::vector<SplitPoint>& points)
        : parent_(parent), points_(points) {
        FindPoints(refiner.level(0));
        const Vtr::Level& next = refiner.level(1);
        if (parent.d == 2) {
            for (Index b = 0; b < next.n_boundary_faces; ++b) Try(next.BoundaryVertices(b));
        } else {
            for (Index t = 0; t < next.n_tets; ++t) Try(next.TetVertices(t));
            for (Index o = 0; o < next.n_octs; ++o) Try(next.OctVertices(o));
        }
        if (best_.vertices.empty()) throw std::logic_error("limit walk: no child of the element");
    }
    const PlaceByVertices& child() const { return best_; }

  private:
    void FindPoints(const Vtr::Level& level) {
        const std::vector<Index>& v = parent_.vertices;
        const std::vector<Vector3> corners = CornersOf(v.size());
        for (std::size_t i = 0; i < v.size(); ++i) points_.push_back({v[i], corners[i]});
        for (std::size_t i = 0; i < v.size(); ++i) {
            for (std::size_t j = i + 1; j < v.size(); ++j) {
                const bool is_diagonal = v.size() == 6 && i / 2 == j / 2;
                if (is_diagonal) continue;
                points_.push_back({level.n_vertices + level.FindEdge(v[i], v[j]), Mean(corners[i], corners[j])});
            }
        }
        if (v.size() != 6) return;
        Index o = 0;
        while (!HasAll(level.OctVertices(o), v)) ++o;
        points_.push_back({level.n_vertices + level.n_edges + o, {}});
    }

    /// Takes an element of the next level, if it is a child and has the place deepest inside.
    void Try(std::span<const Index> vertices) {
        std::array<Vector3, 6> p;
        for (std::size_t i = 0; i < vertices.size(); ++i) {
            const auto found = std::find_if(points_.begin(), points_.end(),
                                            [&](const SplitPoint& s) { return s.vertex == vertices[i]; });
            if (found == points_.end()) return;
            p[i] = found->at;
        }
        const bool is_oct = vertices.size() == 6;
        const Vector3 origin = is_oct ? Mean(p[0], p[1]) : p[0];
        const Vector3 third = is_oct ? Minus(p[4], origin) : parent_.d == 2 ? Vector3{0, 0, 1} : Minus(p[3], origin);
        const Matrix3 to_child = is_oct ? InverseOfColumns(Minus(p[0], origin), Minus(p[2], origin), third)
                                        : InverseOfColumns(Minus(p[1], origin), Minus(p[2], origin), third);
        const Vector3 from_origin = Minus(parent_.at, origin);
        Vector3 at{};
        for (std::size_t r = 0; r < 3; ++r) {
            for (std::size_t c = 0; c < 3; ++c) at[r] += to_child[r][c] * from_origin[c];
        }
        const double depth = Depth(vertices.size(), at);
        if (depth <= depth_) return;
        depth_ = depth;
        best_ = {{vertices.begin(), vertices.end()}, parent_.d, at, Product(to_child, parent_.by_control)};
    }

    const PlaceByVertices& parent_;
    std::vector<SplitPoint>& points_;
    double depth_ = -1e-9;  // places on faces are there by round-off
    PlaceByVertices best_;
};

// Polyhedra and polygons.

Index FindCell(const Vtr::PolyhedralLevel& level, std::span<const Index> vertices) {
    for (Index c = 0; c < static_cast<Index>(level.n_cells()); ++c) {
        if (HasAll(level.CellVertices(c), vertices)) return c;
    }
    throw std::logic_error("limit walk: no cell has the path");
}

Index FindFace(const Vtr::PolyhedralLevel& level, std::span<const Index> vertices, std::span<const Index> faces) {
    for (Index f : faces) {
        if (HasAll(level.FaceVertices(f), vertices)) return f;
    }
    throw std::logic_error("limit walk: no face has the path");
}

/// Vertices of the next level by the part of a path that they come from: its vertices `first` to `last`.
class PathPoints {
  public:
    PathPoints(const Vtr::PolyhedralLevel& level, const std::vector<Index>& path) : level_(level), path_(path) {
        if (path.size() == 4) cell_ = FindCell(level, path);
    }
    Index operator()(std::size_t first, std::size_t last) const {
        const std::span<const Index> part(path_.data() + first, last - first + 1);
        switch (part.size()) {
            case 1:
                return part[0];
            case 2:
                return level_.n_vertices + level_.FindEdge(part[0], part[1]);
            case 3:
                return level_.n_vertices + level_.n_edges +
                       FindFace(
                           level_, part,
                           cell_ == kNoIndex ? std::span<const Index>(level_.boundary_faces) : level_.CellFaces(cell_));
            default:
                return level_.n_vertices + level_.n_edges + level_.n_faces + cell_;
        }
    }

  private:
    const Vtr::PolyhedralLevel& level_;
    const std::vector<Index>& path_;
    Index cell_ = kNoIndex;
};

PlaceByVertices StepOnPath(const Vtr::PolyhedralLevel& level, const PlaceByVertices& parent,
                           std::vector<SplitPoint>& points) {
    const std::size_t d = static_cast<std::size_t>(parent.d);
    const PathPoints point(level, parent.vertices);
    for (std::size_t first = 0; first <= d; ++first) {
        for (std::size_t last = first; last <= d; ++last) {
            Vector3 at{};
            for (std::size_t i = 0; i < last; ++i) at[i] = i < first ? 1 : 0.5;
            points.push_back({point(first, last), at});
        }
    }
    // The child is half a cell wide along each axis; its path goes along the axes in the order of its coordinates.
    Vector3 low{}, rest{};
    for (std::size_t i = 0; i < d; ++i) {
        low[i] = parent.at[i] >= 0.5 ? 0.5 : 0;
        rest[i] = 2 * (parent.at[i] - low[i]);
    }
    std::array<std::size_t, 3> order{0, 1, 2};
    std::stable_sort(order.begin(), order.begin() + parent.d,
                     [&](std::size_t a, std::size_t b) { return rest[a] > rest[b]; });
    PlaceByVertices child{{}, parent.d, {}, {}};
    Vector3 corner = low;
    for (std::size_t k = 0; k <= d; ++k) {
        const auto n_above = [&](double x) {
            return static_cast<std::size_t>(
                std::count_if(corner.begin(), corner.end(), [x](double c) { return c > x; }));
        };
        child.vertices.push_back(point(n_above(0.75), n_above(0.25)));
        if (k == d) break;
        corner[order[k]] += 0.5;
        child.at[k] = rest[order[k]];
        for (std::size_t c = 0; c < 3; ++c) child.by_control[k][c] = 2 * parent.by_control[order[k]][c];
    }
    return child;
}

/// Hexahedra and quads: coordinates sorted.
PlaceByVertices SortedPath(std::span<const Index> corners, int d, const Vector3& at) {
    std::array<std::size_t, 3> order{0, 1, 2};
    std::stable_sort(order.begin(), order.begin() + d, [&](std::size_t a, std::size_t b) { return at[a] > at[b]; });
    constexpr std::array<std::size_t, 8> kCornerAt{0, 1, 3, 2, 4, 5, 7, 6};  // by bits of its coordinates
    PlaceByVertices place{{corners[0]}, d, {}, {}};
    std::size_t bits = 0;
    for (std::size_t k = 0; k < static_cast<std::size_t>(d); ++k) {
        bits |= std::size_t{1} << order[k];
        place.vertices.push_back(corners[kCornerAt[bits]]);
        place.at[k] = at[order[k]];
        place.by_control[k][order[k]] = 1;
    }
    return place;
}

/// The place in the child at the nearer of two corners of a part; ends of the part's edge by their weights.
struct PartEdge {
    Index near, far;
    double near_weight, far_weight;
    std::size_t near_axis, far_axis;  ///< coordinates that are the weights
};
PartEdge MakePartEdge(Index a, Index b, double a_weight, double b_weight, std::size_t a_axis) {
    if (a_weight >= b_weight) return {a, b, a_weight, b_weight, a_axis, a_axis + 1};
    return {b, a, b_weight, a_weight, a_axis + 1, a_axis};
}

PlaceByVertices StepIntoPolygon(const Vtr::PolyhedralLevel& level, Index face, Index n_parents,
                                std::span<const Index> corners, const Far::Place& place) {
    const auto [u, v, unused] = place.at;
    const std::size_t k = static_cast<std::size_t>(place.part);
    const PartEdge e = MakePartEdge(corners[k], corners[(k + 1) % corners.size()], u, v, 0);
    PlaceByVertices child{{e.near, level.n_vertices + level.FindEdge(e.near, e.far), n_parents + face}, 2, {}, {}};
    child.at = {1 - e.near_weight + e.far_weight, 1 - u - v, 0};
    child.by_control[0][e.near_axis] = -1;
    child.by_control[0][e.far_axis] = 1;
    child.by_control[1] = {-1, -1, 0};
    return child;
}

PlaceByVertices StepIntoPolyhedron(const Vtr::PolyhedralLevel& level, const Far::Place& place) {
    const Vtr::Polyhedra& p = level.polyhedra;
    const Index c = place.element - level.n_hexes;
    Offset face = p.offsets[c];
    const Offset corner = p.face_vertex_offsets[face] + place.part;
    while (p.face_vertex_offsets[face + 1] <= corner) ++face;
    const Offset begin = p.face_vertex_offsets[face], n = p.face_vertex_offsets[face + 1] - begin;
    const std::span<const Index> corners(p.face_vertices.data() + begin, static_cast<std::size_t>(n));
    const auto [u, v, w] = place.at;
    const std::size_t k = static_cast<std::size_t>(corner - begin);
    const PartEdge e = MakePartEdge(corners[k], corners[(k + 1) % corners.size()], v, w, 1);
    const Index f = FindFace(level, corners, level.CellFaces(place.element));
    const Index n_parents = level.n_vertices + level.n_edges;
    PlaceByVertices child{{e.near, level.n_vertices + level.FindEdge(e.near, e.far), n_parents + f,
                           n_parents + level.n_faces + place.element},
                          3,
                          {},
                          {}};
    child.at = {1 - e.near_weight + e.far_weight, 1 - v - w, 1 - u - v - w};
    child.by_control[0][e.near_axis] = -1;
    child.by_control[0][e.far_axis] = 1;
    child.by_control[1] = {0, -1, -1};
    child.by_control[2] = {-1, -1, -1};
    return child;
}

constexpr Matrix3 kIdentity{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

}  // namespace

PlaceByVertices StepDown(const Far::TopologyRefiner& refiner, const PlaceByVertices& place,
                         std::vector<SplitPoint>& points) {
    if (refiner.is_polyhedral()) return StepOnPath(refiner.polyhedral_level(0), place, points);
    return SimplexStep(refiner, place, points).child();
}

PlaceByVertices FirstStep(const Far::TopologyRefiner& refiner, const Far::Place& place, Far::Elements elements,
                          std::vector<SplitPoint>& points) {
    const bool is_cell = elements == Far::Elements::Cells;
    if (!refiner.is_polyhedral()) {
        const Vtr::Level& level = refiner.level(0);
        PlaceByVertices start{{}, is_cell ? 3 : 2, place.at, kIdentity};
        const auto take = [&](auto vertices) { start.vertices.assign(vertices.begin(), vertices.end()); };
        if (!is_cell) {
            take(level.BoundaryVertices(place.element));
            start.at[2] = 0;
        } else if (place.element < level.n_tets) {
            take(level.TetVertices(place.element));
        } else {
            take(level.OctVertices(place.element - level.n_tets));
        }
        return StepDown(refiner, start, points);
    }
    const Vtr::PolyhedralLevel& level = refiner.polyhedral_level(0);
    if (is_cell && !level.IsHex(place.element)) return StepIntoPolyhedron(level, place);
    const auto corners = is_cell ? level.CellVertices(place.element) : level.BoundaryVertices(place.element);
    if (!is_cell && corners.size() != 4) {
        return StepIntoPolygon(level, level.boundary_faces[place.element], level.n_vertices + level.n_edges, corners,
                               place);
    }
    return StepOnPath(level, SortedPath(corners, is_cell ? 3 : 2, place.at), points);
}

}  // namespace SolidSubdiv::Validation
