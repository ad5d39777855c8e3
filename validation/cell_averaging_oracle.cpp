// SPDX-License-Identifier: Apache-2.0
// New cells as lists of points, sums of their masks.
#include "cell_averaging_oracle.h"

#include <algorithm>
#include <set>

namespace SolidSubdiv::Validation {

namespace {

Parent Sorted(Parent p) {
    std::sort(p.begin(), p.end());
    return p;
}

Point MeanOf(const Parent& vertices, const std::vector<double>& positions) {
    Point mean{};
    for (int v : vertices) {
        for (std::size_t i = 0; i < 3; ++i) mean[i] += positions[3 * static_cast<std::size_t>(v) + i];
    }
    for (double& x : mean) x /= static_cast<double>(vertices.size());
    return mean;
}

/// A mean while it is summed.
struct Sum {
    Point point{};
    double weight = 0;

    void Add(const Point& p, double w) {
        for (std::size_t i = 0; i < 3; ++i) point[i] += w * p[i];
    }
    Point Mean() const { return {point[0] / weight, point[1] / weight, point[2] / weight}; }
};

Point MeanOf(const std::vector<Point>& points) {
    Sum sum;
    for (const Point& p : points) sum.Add(p, 1);
    sum.weight = static_cast<double>(points.size());
    return sum.Mean();
}

/// Tets and octahedra whose corners are means of the old complex's vertices.
class SplitComplex {
  public:
    SplitComplex(const Complex& complex, const std::vector<double>& positions) : positions_(positions) {
        for (const auto& [a, b, c, d] : complex.tets) {
            for (const auto& [v, x, y, z] : {std::array{a, b, c, d}, {b, a, c, d}, {c, a, b, d}, {d, a, b, c}}) {
                AddTet({Parent{v}, {v, x}, {v, y}, {v, z}});
            }
            AddOct({Parent{a, b}, {c, d}, {a, c}, {b, d}, {a, d}, {b, c}});
        }
        for (const auto& o : complex.octs) {
            const Parent centre(o.begin(), o.end());
            const std::array<std::array<int, 2>, 3> pairs{{{o[0], o[1]}, {o[2], o[3]}, {o[4], o[5]}}};
            for (std::size_t p = 0; p < 3; ++p) {
                const auto &q = pairs[(p + 1) % 3], &r = pairs[(p + 2) % 3];
                for (int v : pairs[p]) AddOct({Parent{v}, centre, {v, q[0]}, {v, q[1]}, {v, r[0]}, {v, r[1]}});
            }
            for (int a : pairs[0]) {
                for (int b : pairs[1]) {
                    for (int c : pairs[2]) AddTet({centre, {a, b}, {b, c}, {a, c}});
                }
            }
        }
    }

    /// Means of the cells' masks, away from the boundary.
    NewPoints Inside() const {
        std::set<Parent> boundary;
        for (const auto& [face, n_cells] : faces_) {
            if (n_cells == 1) boundary.insert(face.begin(), face.end());
        }
        NewPoints points;
        for (const auto& [parent, sum] : sums_) {
            if (boundary.count(parent) > 0) continue;
            (parent.size() <= 2 ? points.of_vertices_and_edges : points.of_cells)[parent] = sum.Mean();
        }
        return points;
    }

  private:
    void AddTet(std::vector<Parent> corners) {
        for (Parent& c : corners) c = Sorted(c);
        for (std::size_t i = 0; i < 4; ++i) {
            for (std::size_t j = 0; j < 4; ++j) Add(corners[i], corners[j], i == j ? -1.0 / 16 : 17.0 / 48);
            std::set<Parent> face(corners.begin(), corners.end());
            face.erase(corners[i]);
            ++faces_[face];
        }
    }
    /// Corners 2i and 2i + 1 are opposite.
    void AddOct(std::vector<Parent> corners) {
        for (Parent& c : corners) c = Sorted(c);
        for (std::size_t i = 0; i < 6; ++i) {
            for (std::size_t j = 0; j < 6; ++j) {
                Add(corners[i], corners[j], i == j ? 3.0 / 8 : i / 2 == j / 2 ? 7.0 / 24 : 1.0 / 12);
            }
        }
        for (std::size_t f = 0; f < 8; ++f) {
            ++faces_[{corners[f / 4], corners[2 + f / 2 % 2], corners[4 + f % 2]}];
        }
    }
    void Add(const Parent& to, const Parent& from, double weight) {
        Sum& sum = sums_[to];
        sum.Add(MeanOf(from, positions_), weight);
        sum.weight += weight;  // a mask's weights sum to 1: this counts cells
    }

    const std::vector<double>& positions_;
    std::map<Parent, Sum> sums_;
    std::map<std::set<Parent>, int> faces_;
};

/// What the boundary of cells looks like, by sets.
struct Boundary {
    std::map<Parent, int> cells_of_face, cells_of_edge, cells_of_vertex;
    std::map<Parent, Polygon> faces;  ///< those of one cell

    explicit Boundary(const std::vector<std::vector<Polygon>>& cells) {
        for (const auto& cell : cells) {
            std::set<Parent> edges, vertices;
            for (const Polygon& face : cell) {
                ++cells_of_face[Sorted(face)];
                for (std::size_t k = 0; k < face.size(); ++k) {
                    vertices.insert({face[k]});
                    edges.insert(Sorted({face[k], face[(k + 1) % face.size()]}));
                }
            }
            for (const Parent& e : edges) ++cells_of_edge[e];
            for (const Parent& v : vertices) ++cells_of_vertex[v];
        }
        for (const auto& cell : cells) {
            for (const Polygon& face : cell) {
                if (cells_of_face[Sorted(face)] == 1) faces[Sorted(face)] = face;
            }
        }
    }
};

/// Whether faces, each by its two edges at a vertex, go once around it.
bool IsDisc(std::vector<std::array<Parent, 2>> faces) {
    Parent at = faces.front()[0];
    const Parent first = at;
    while (!faces.empty()) {
        const auto next =
            std::find_if(faces.begin(), faces.end(), [&](const auto& f) { return f[0] == at || f[1] == at; });
        if (next == faces.end()) return false;
        at = (*next)[0] == at ? (*next)[1] : (*next)[0];
        faces.erase(next);
        if (at == first) return faces.empty();
    }
    return false;
}

}  // namespace

NewPoints AverageTetOct(const Complex& complex, const std::vector<double>& positions) {
    return SplitComplex(complex, positions).Inside();
}

NewPoints AveragePolyhedra(const std::vector<std::vector<Polygon>>& cells, const std::vector<double>& positions,
                           bool sharp) {
    const Boundary boundary(cells);
    std::map<Parent, Sum> low, faces, of_cells, low_on_boundary;  // low: of vertices and edges
    const auto add = [](Sum& sum, const Point& p) {
        sum.Add(p, 1);
        sum.weight += 1;
    };
    for (const auto& cell : cells) {
        std::map<int, std::set<Parent>> edges_at, faces_at;
        Parent whole;
        for (const Polygon& face : cell) {
            for (std::size_t k = 0; k < face.size(); ++k) {
                const int a = face[k], b = face[(k + 1) % face.size()];
                faces_at[a].insert(Sorted(face));
                edges_at[a].insert(Sorted({a, b}));
                edges_at[b].insert(Sorted({a, b}));
            }
        }
        for (const auto& entry : faces_at) whole.push_back(entry.first);
        for (const auto& [v, my_faces] : faces_at) {
            std::vector<Point> corners = {MeanOf(Parent{v}, positions), MeanOf(whole, positions)};
            for (const Parent& p : edges_at[v]) corners.push_back(MeanOf(p, positions));
            for (const Parent& p : my_faces) corners.push_back(MeanOf(p, positions));
            const Point centroid = MeanOf(corners);
            add(low[{v}], centroid);
            for (const Parent& p : edges_at[v]) add(low[p], centroid);
            for (const Parent& p : my_faces) add(faces[p], centroid);
            add(of_cells[whole], centroid);
        }
    }

    std::map<Parent, std::vector<std::array<Parent, 2>>> around;  // boundary vertices
    std::map<Parent, int> n_faces;                                // at boundary edges
    for (const auto& [key, face] : boundary.faces) {
        const std::size_t n = face.size();
        faces[key] = {};
        for (std::size_t k = 0; k < n; ++k) {
            const Parent v{face[k]}, after = Sorted({face[k], face[(k + 1) % n]}),
                                     before = Sorted({face[k], face[(k + n - 1) % n]});
            const Point centroid = MeanOf(
                {MeanOf(v, positions), MeanOf(after, positions), MeanOf(before, positions), MeanOf(key, positions)});
            for (const Parent& p : {v, after, before}) add(low_on_boundary[p], centroid);
            add(faces[key], centroid);
            around[v].push_back({after, before});
            ++n_faces[after];
        }
    }

    NewPoints points;
    for (const auto& [p, sum] : faces) points.of_faces[p] = sum.Mean();
    for (const auto& [p, sum] : of_cells) points.of_cells[p] = sum.Mean();
    for (const auto& [p, sum] : low) {
        const auto on_boundary = low_on_boundary.find(p);
        if (on_boundary == low_on_boundary.end()) {
            points.of_vertices_and_edges[p] = sum.Mean();
            continue;
        }
        const auto is_sharp = [&](const Parent& edge) { return sharp && boundary.cells_of_edge.at(edge) == 1; };
        std::vector<Parent> sharp_edges;  // at a vertex
        if (p.size() == 2) {
            if (n_faces[p] != 2) continue;
            if (is_sharp(p)) sharp_edges = {p};
        } else {
            if (!IsDisc(around[p])) continue;
            for (const auto& face : around[p]) {
                if (is_sharp(face[0])) sharp_edges.push_back(face[0]);  // each edge is the first of one face
            }
        }
        Point& point = points.of_vertices_and_edges[p] = on_boundary->second.Mean();
        if (p.size() == 2) {
            if (!sharp_edges.empty()) point = MeanOf(p, positions);
        } else if (sharp_edges.size() > 2 || (sharp && boundary.cells_of_vertex.at(p) == 1)) {
            point = MeanOf(p, positions);
        } else if (sharp_edges.size() == 2) {
            // Two means with a neighbour: 6/8, 1/8, 1/8.
            Sum crease;
            crease.Add(MeanOf(p, positions), 2);
            for (const Parent& e : sharp_edges) crease.Add(MeanOf(e, positions), 1);
            crease.weight = 4;
            point = crease.Mean();
        }
    }
    return points;
}

}  // namespace SolidSubdiv::Validation
