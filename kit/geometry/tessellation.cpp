// SPDX-License-Identifier: Apache-2.0
// Tessellations of boundaries at a rate; what both kinds share: numbering, places, rows, normals, errors.
#include <solidsubdiv/kit/geometry/tessellation.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include <solidsubdiv/kit/geometry/internal/boundary_pieces.h>
#include <solidsubdiv/sdc/parallel.h>

namespace SolidSubdiv::Geometry {

using Internal::At;
using Internal::Facet;
using Internal::Vec3;

namespace {

/// Cuts pieces into lattices. Vertices are numbered: nodes, then those on sides from their lower node to the higher,
/// then those inside pieces.
class Lattices {
  public:
    Lattices(const Internal::BoundaryPieces& boundary, const TessellationOptions& options)
        : boundary_(boundary), n_(options.rate), keep_quads_(options.quads) {
        for (const Facet& piece : boundary.pieces) {
            for (int s = 0; s < piece.n_corners; ++s) sides_.push_back(Side(piece, s));
        }
        std::sort(sides_.begin(), sides_.end());
        sides_.erase(std::unique(sides_.begin(), sides_.end()), sides_.end());
        n_vertices_ = boundary.n_nodes + static_cast<Index>(sides_.size()) * (n_ - 1);
        for (const Facet& piece : boundary.pieces) Cut(piece);
    }
    std::vector<Facet> TakeFacets() { return std::move(facets_); }
    Index n_vertices() const { return n_vertices_; }

  private:
    using Nodes = std::pair<Index, Index>;

    static Nodes Side(const Facet& piece, int s) {
        const Index a = piece.vertices[static_cast<std::size_t>(s)];
        const Index b = piece.vertices[static_cast<std::size_t>((s + 1) % piece.n_corners)];
        return std::minmax(a, b);
    }

    /// The vertex k steps after corner s, on the way to the next corner.
    Index OnSide(const Facet& piece, int s, int k) const {
        if (k == 0) return piece.vertices[static_cast<std::size_t>(s)];
        if (k == n_) return piece.vertices[static_cast<std::size_t>((s + 1) % piece.n_corners)];
        const Nodes side = Side(piece, s);
        const auto at = std::lower_bound(sides_.begin(), sides_.end(), side) - sides_.begin();
        const int steps = side.first == piece.vertices[static_cast<std::size_t>(s)] ? k : n_ - k;
        return boundary_.n_nodes + static_cast<Index>(at) * (n_ - 1) + steps - 1;
    }

    void Cut(const Facet& piece) {
        const bool is_quad = piece.n_corners == 4;
        const auto width = static_cast<std::size_t>(n_) + 1;
        lattice_.assign(width * width, kNoIndex);
        const auto vertex = [&](int i, int j) -> Index& {
            return lattice_[static_cast<std::size_t>(j) * width + static_cast<std::size_t>(i)];
        };
        for (int k = 0; k <= n_; ++k) {
            vertex(k, 0) = OnSide(piece, 0, k);
            if (is_quad) {
                vertex(n_, k) = OnSide(piece, 1, k);
                vertex(n_ - k, n_) = OnSide(piece, 2, k);
                vertex(0, n_ - k) = OnSide(piece, 3, k);
            } else {
                vertex(n_ - k, k) = OnSide(piece, 1, k);
                vertex(0, n_ - k) = OnSide(piece, 2, k);
            }
        }
        for (int j = 1; j < n_; ++j) {
            for (int i = 1; i < (is_quad ? n_ : n_ - j); ++i) vertex(i, j) = n_vertices_++;
        }
        const auto add = [&](std::initializer_list<std::pair<int, int>> corners) {
            Facet facet{piece.domain, static_cast<int>(corners.size())};
            std::size_t c = 0;
            for (const auto& corner : corners) {
                facet.vertices[c] = vertex(corner.first, corner.second);
                facet.domain.corners[c++] = {static_cast<double>(corner.first) / n_,
                                             static_cast<double>(corner.second) / n_};
            }
            facets_.push_back(facet);
        };
        for (int j = 0; j < n_; ++j) {
            for (int i = 0; i < (is_quad ? n_ : n_ - j); ++i) {
                if (is_quad && keep_quads_) {
                    add({{i, j}, {i + 1, j}, {i + 1, j + 1}, {i, j + 1}});
                } else if (is_quad && IsLow(i) == IsLow(j)) {
                    add({{i, j}, {i + 1, j}, {i + 1, j + 1}});
                    add({{i, j}, {i + 1, j + 1}, {i, j + 1}});
                } else if (is_quad) {
                    add({{i, j}, {i + 1, j}, {i, j + 1}});
                    add({{i + 1, j}, {i + 1, j + 1}, {i, j + 1}});
                } else {
                    add({{i, j}, {i + 1, j}, {i, j + 1}});
                    if (i + j + 1 < n_) add({{i + 1, j}, {i + 1, j + 1}, {i, j + 1}});
                }
            }
        }
    }

    /// Diagonals go from the quad's corners inwards: no facet has its three corners on sides, so that two quads with
    /// two common sides have no diagonal in common.
    bool IsLow(int i) const { return 2 * i + 1 < n_; }

    const Internal::BoundaryPieces& boundary_;
    const int n_;
    const bool keep_quads_;
    std::vector<Nodes> sides_;
    std::vector<Facet> facets_;
    std::vector<Index> lattice_;
    Index n_vertices_ = 0;
};

/// Gives the vertices in use new numbers, in their order. @returns how many they are
Index Renumber(std::vector<Facet>& facets, Index n_vertices) {
    std::vector<Index> number(static_cast<std::size_t>(n_vertices), kNoIndex);
    for (const Facet& f : facets) {
        for (int c = 0; c < f.n_corners; ++c)
            number[static_cast<std::size_t>(f.vertices[static_cast<std::size_t>(c)])] = 0;
    }
    Index n = 0;
    for (Index& v : number) {
        if (v != kNoIndex) v = n++;
    }
    for (Facet& f : facets) {
        for (int c = 0; c < f.n_corners; ++c) {
            Index& v = f.vertices[static_cast<std::size_t>(c)];
            v = number[static_cast<std::size_t>(v)];
        }
    }
    return n;
}

/// @param facets by face
Tessellation Finish(const Far::TopologyRefiner& refiner, const Sdc::Scheme& scheme, std::vector<Facet> facets,
                    Index n_vertices, const TessellationOptions& options) {
    Tessellation t;
    const auto n = static_cast<std::size_t>(Renumber(facets, n_vertices));
    std::stable_partition(facets.begin(), facets.end(), [](const Facet& f) { return f.n_corners == 3; });
    t.places.resize(n);
    std::vector<Index> last_face(n, kNoIndex);
    std::vector<Far::Place> others;  // of the same vertices in other faces
    std::vector<Index> vertices_of_others;
    t.domains.reserve(facets.size());
    for (const Facet& f : facets) {
        std::vector<Index>& corners = f.n_corners == 3 ? t.triangles : t.quads;
        for (std::size_t c = 0; c < static_cast<std::size_t>(f.n_corners); ++c) {
            const Index v = f.vertices[c];
            corners.push_back(v);
            Index& last = last_face[static_cast<std::size_t>(v)];
            if (last == f.domain.face) continue;
            const At& at = f.domain.corners[c];
            const Far::Place place{f.domain.face, f.domain.part, {at[0], at[1], 0}};
            if (last == kNoIndex) {
                t.places[static_cast<std::size_t>(v)] = place;
            } else {
                others.push_back(place);
                vertices_of_others.push_back(v);
            }
            last = f.domain.face;
        }
        t.domains.push_back(f.domain);
    }
    if (!options.normals) {
        t.rows = Internal::MakeLimitRows(refiner, scheme, t.places, false, options.progress).rows;
        return t;
    }
    std::vector<Far::Place> all = t.places;
    all.insert(all.end(), others.begin(), others.end());
    Internal::LimitRows made = Internal::MakeLimitRows(refiner, scheme, all, true, options.progress);
    t.rows = std::move(made.rows);
    t.rows.offsets.resize(n + 1);
    t.rows.indices.resize(static_cast<std::size_t>(t.rows.n_weights()));
    t.rows.weights.resize(static_cast<std::size_t>(t.rows.n_weights()));
    t.tangents = std::move(made.tangents);
    for (std::size_t v = 0; v < n; ++v) t.tangent_vertices.push_back(static_cast<Index>(v));
    t.tangent_vertices.insert(t.tangent_vertices.end(), vertices_of_others.begin(), vertices_of_others.end());
    return t;
}

Tessellation AtRate(const Far::TopologyRefiner& refiner, const Sdc::Scheme& scheme,
                    const TessellationOptions& options) {
    const Internal::BoundaryPieces boundary = Internal::FindPieces(refiner, options.is_left_out, false);
    double n_facets = 0;
    for (const Facet& piece : boundary.pieces) {
        n_facets += (piece.n_corners == 4 && !options.quads ? 2.0 : 1.0) * options.rate * options.rate;
    }
    if (n_facets > static_cast<double>(options.max_facets)) {
        throw InvalidInput("a rate of " + std::to_string(options.rate) + " makes " +
                           std::to_string(static_cast<Offset>(n_facets)) + " facets, more than the " +
                           std::to_string(options.max_facets) + " allowed");
    }
    Lattices lattices(boundary, options);
    return Finish(refiner, scheme, lattices.TakeFacets(), lattices.n_vertices(), options);
}

/// Adds unit vectors, or nothing where there is no direction.
void AddUnit(std::vector<double>& sums, Index v, const Vec3& n, double length) {
    if (!(length > 0)) return;
    double* sum = sums.data() + 3 * static_cast<std::size_t>(v);
    sum[0] += n.x / length;
    sum[1] += n.y / length;
    sum[2] += n.z / length;
}

}  // namespace

void TessellationOptions::Validate() const {
    if (rate < 1 || rate > 4096) throw InvalidInput("rate is " + std::to_string(rate) + "; it must be 1 to 4096");
    if (!(tolerance >= 0) || !std::isfinite(tolerance)) {
        throw InvalidInput("tolerance is " + std::to_string(tolerance) + "; it must be a length, or 0 for none");
    }
    if (max_halvings < 0 || max_halvings > 30) {
        throw InvalidInput("max_halvings is " + std::to_string(max_halvings) + "; it must be 0 to 30");
    }
    if (max_facets < 1 || max_facets > 500'000'000) {
        throw InvalidInput("max_facets is " + std::to_string(max_facets) + "; it must be 1 to 500000000");
    }
    if (tolerance > 0 && quads) throw InvalidInput("a tolerance makes triangles, not quads; give a rate");
}

Far::Place FacetDomain::At(std::array<double, 4> weights) const {
    Far::Place place{face, part, {}};
    for (std::size_t c = 0; c < 4; ++c) {
        for (std::size_t k = 0; k < 2; ++k) place.at[k] += weights[c] * corners[c][k];
    }
    return place;
}

std::vector<double> Tessellation::Values(std::span<const double> control, int width) const {
    return Internal::Apply(rows, control, width);
}

std::vector<double> Tessellation::Normals(std::span<const double> control) const {
    std::vector<double> sums(3 * static_cast<std::size_t>(n_vertices()), 0.0);
    if (!tangent_vertices.empty()) {
        const std::vector<double> along_u = Internal::Apply(tangents[0], control, 3);
        const std::vector<double> along_v = Internal::Apply(tangents[1], control, 3);
        for (std::size_t i = 0; i < tangent_vertices.size(); ++i) {
            const Vec3 u = Internal::PointAt(along_u, static_cast<Index>(i));
            const Vec3 v = Internal::PointAt(along_v, static_cast<Index>(i));
            const Vec3 n = Cross(u, v);
            // Nearer to parallel than sums of some tens of products tell.
            const double length = Length(n), round_off = 1e-12 * Length(u) * Length(v);
            AddUnit(sums, tangent_vertices[i], n, length > round_off ? length : 0);
        }
    }
    const auto has_none = [&](Index v) {
        const Vec3 n = Internal::PointAt(sums, v);
        return !(Length(n) > 1e-6);  // those of several faces may cancel
    };
    std::vector<bool> lacks(static_cast<std::size_t>(n_vertices()));
    for (Index v = 0; v < n_vertices(); ++v) {
        if (!has_none(v)) continue;
        lacks[static_cast<std::size_t>(v)] = true;
        std::fill_n(sums.begin() + Offset{3} * v, 3, 0.0);
    }
    if (std::find(lacks.begin(), lacks.end(), true) != lacks.end()) {
        const std::vector<double> positions = Positions(control);
        const auto add_facets = [&](const std::vector<Index>& corners, std::size_t arity) {
            for (std::size_t i = 0; i < corners.size(); i += arity) {
                const auto p = [&](std::size_t c) { return Internal::PointAt(positions, corners[i + c]); };
                const Vec3 n = arity == 3 ? Cross(p(1) - p(0), p(2) - p(0)) : Cross(p(2) - p(0), p(3) - p(1));
                for (std::size_t c = 0; c < arity; ++c) {
                    if (lacks[static_cast<std::size_t>(corners[i + c])]) AddUnit(sums, corners[i + c], n, 1);
                }
            }
        };
        add_facets(triangles, 3);
        add_facets(quads, 4);
    }
    for (Index v = 0; v < n_vertices(); ++v) {
        const Vec3 n = Internal::PointAt(sums, v);
        std::fill_n(sums.begin() + Offset{3} * v, 3, 0.0);
        AddUnit(sums, v, n, Length(n));
    }
    return sums;
}

Tessellation TessellateBoundary(const Far::TopologyRefiner& refiner, const Sdc::Scheme& scheme,
                                const TessellationOptions& options) {
    options.Validate();
    if (options.tolerance > 0) throw InvalidInput("a tolerance needs the positions of the control points");
    return AtRate(refiner, scheme, options);
}

Tessellation TessellateBoundary(const Far::TopologyRefiner& refiner, const Sdc::Scheme& scheme,
                                std::span<const double> positions, const TessellationOptions& options) {
    options.Validate();
    if (positions.size() != 3 * static_cast<std::size_t>(refiner.n_vertices(0))) {
        throw InvalidInput("there are " + std::to_string(positions.size()) + " coordinates for " +
                           std::to_string(refiner.n_vertices(0)) + " control points");
    }
    if (options.tolerance == 0) return AtRate(refiner, scheme, options);
    Internal::CloseFacets close = Internal::BisectToTolerance(refiner, scheme, positions, options,
                                                              Internal::FindPieces(refiner, options.is_left_out, true));
    Tessellation t = Finish(refiner, scheme, std::move(close.facets), close.n_vertices, options);
    t.error = close.error;
    t.n_tests = close.n_tests;
    return t;
}

TessellationError MeasureError(const Far::TopologyRefiner& refiner, const Sdc::Scheme& scheme,
                               const Tessellation& tessellation, std::span<const double> positions,
                               const Progress& progress) {
    struct Triangle {
        std::array<Index, 3> vertices;
        const FacetDomain* domain;
        std::array<std::size_t, 3> corners;  // of the facet

        Far::Place At(const std::array<double, 3>& weights) const {
            std::array<double, 4> all{};
            for (std::size_t k = 0; k < 3; ++k) all[corners[k]] = weights[k];
            return domain->At(all);
        }
    };
    std::vector<Triangle> triangles;
    const auto add = [&](const Index* v, const FacetDomain& domain, std::array<std::size_t, 3> corners) {
        triangles.push_back({{v[corners[0]], v[corners[1]], v[corners[2]]}, &domain, corners});
    };
    const std::size_t n_triangles = tessellation.triangles.size() / 3;
    for (std::size_t i = 0; i < n_triangles; ++i) {
        add(&tessellation.triangles[3 * i], tessellation.domains[i], {0, 1, 2});
    }
    for (std::size_t i = 0; i < tessellation.quads.size() / 4; ++i) {
        add(&tessellation.quads[4 * i], tessellation.domains[n_triangles + i], {0, 1, 2});
        add(&tessellation.quads[4 * i], tessellation.domains[n_triangles + i], {0, 2, 3});
    }

    struct Side {
        Index low, high, triangle;
        std::size_t k;
    };
    std::vector<Side> sides;
    std::vector<Far::Place> places;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        const Triangle& t = triangles[i];
        for (const auto& weights : Internal::kTestsInside) places.push_back(t.At(weights));
        for (std::size_t k = 0; k < 3; ++k) {
            const auto [low, high] = std::minmax(t.vertices[k], t.vertices[(k + 1) % 3]);
            sides.push_back({low, high, static_cast<Index>(i), k});
        }
    }
    const auto is_same_edge = [](const Side& a, const Side& b) { return a.low == b.low && a.high == b.high; };
    std::stable_sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
        return std::make_pair(a.low, a.high) < std::make_pair(b.low, b.high);
    });
    for (std::size_t s = 0; s < sides.size(); ++s) {
        if (s > 0 && is_same_edge(sides[s - 1], sides[s])) continue;
        for (const double part : {.25, .5, .75}) {
            std::array<double, 3> weights{};
            weights[sides[s].k] = 1 - part;
            weights[(sides[s].k + 1) % 3] = part;
            places.push_back(triangles[static_cast<std::size_t>(sides[s].triangle)].At(weights));
        }
    }

    const std::vector<double> vertices = tessellation.Positions(positions);
    const std::vector<Vec3> points = Internal::LimitPoints(refiner, scheme, progress).At(places, positions);
    const auto distance = [&](const Vec3& p, std::size_t triangle) {
        const auto& v = triangles[triangle].vertices;
        return Internal::DistanceTo(p, Internal::PointAt(vertices, v[0]), Internal::PointAt(vertices, v[1]),
                                    Internal::PointAt(vertices, v[2]));
    };
    TessellationError error{0, static_cast<Offset>(points.size())};
    std::size_t next = 0;
    for (; next < Internal::kTestsInside.size() * triangles.size(); ++next) {
        error.largest = std::max(error.largest, distance(points[next], next / Internal::kTestsInside.size()));
    }
    for (std::size_t s = 0; s < sides.size(); next += 3) {
        std::array<double, 3> nearest;
        nearest.fill(std::numeric_limits<double>::infinity());
        const std::size_t first = s;
        for (; s < sides.size() && is_same_edge(sides[first], sides[s]); ++s) {
            for (std::size_t k = 0; k < 3; ++k) {
                nearest[k] =
                    std::min(nearest[k], distance(points[next + k], static_cast<std::size_t>(sides[s].triangle)));
            }
        }
        error.largest = std::max(error.largest, *std::max_element(nearest.begin(), nearest.end()));
    }
    return error;
}

}  // namespace SolidSubdiv::Geometry
