// SPDX-License-Identifier: Apache-2.0
// Newest vertex bisection of boundary faces until the limit is close: of mitchell1991adaptive, with marked edges.
//
// A triangle is cut from the middle of its first edge to the vertex opposite, which keeps its shapes (in the face's
// coordinates) few and round. Edges are marked, not triangles: those that the limit is too far from, the first edges of
// triangles that it is too far from, and the first edges of triangles that have another marked edge, until there are no
// more. Then every triangle is cut along its marked edges, and no vertex is left hanging.
#include <algorithm>
#include <string>
#include <unordered_map>
#include <utility>

#include <solidsubdiv/kit/geometry/internal/boundary_pieces.h>

namespace SolidSubdiv::Geometry::Internal {

namespace {

/// The limit's distance to an edge is that to its ends' chord on edges of the control mesh, where borders and creases
/// are. Inside faces it is that to the nearer of its two triangles: the limit of a straight line in a face's
/// coordinates may be a curve that leaves the chord but not the surface.
struct Edge {
    std::array<Index, 2> ends;
    Index piece;  // in whose coordinates it was met first
    std::array<At, 2> at;
    bool is_of_control_mesh;
    std::array<Vec3, 3> limits{};  // at its quarters
    std::array<double, 3> distances{};
    bool is_marked = false;
    Index vertex = kNoIndex;  // in its middle, once it is cut

    double Error() const { return *std::max_element(distances.begin(), distances.end()); }
};

struct Triangle {
    Index piece;
    std::array<Index, 3> vertices;
    std::array<At, 3> at;
    std::array<Index, 3> edges;  // from vertex k to the next; the first is cut first
    double error = 0;
    bool is_tested = false;
};

class Bisection {
  public:
    Bisection(const Far::TopologyRefiner& refiner, const Sdc::Scheme& scheme, std::span<const double> positions,
              const TessellationOptions& options, const BoundaryPieces& triangles)
        : refiner_(refiner),
          limits_(refiner, scheme, options.progress),
          positions_(positions),
          options_(options),
          pieces_(triangles.pieces) {
        PlaceNodes(triangles.n_nodes);
        for (std::size_t p = 0; p < pieces_.size(); ++p) AddPiece(static_cast<Index>(p));
        for (int halvings = 0;; ++halvings) {
            Test();
            if (halvings == options.max_halvings || !Mark()) break;
            Cut();
        }
    }

    CloseFacets Take() {
        CloseFacets close{{}, static_cast<Index>(points_.size()), 0, n_tests_};
        std::stable_sort(triangles_.begin(), triangles_.end(),
                         [](const Triangle& a, const Triangle& b) { return a.piece < b.piece; });
        for (const Triangle& t : triangles_) {
            Facet facet = pieces_[static_cast<std::size_t>(t.piece)];
            for (std::size_t c = 0; c < 3; ++c) {
                facet.domain.corners[c] = t.at[c];
                facet.vertices[c] = t.vertices[c];
                close.error = std::max(close.error, EdgeAt(t.edges[c]).Error());
            }
            close.error = std::max(close.error, t.error);
            close.facets.push_back(facet);
        }
        return close;
    }

  private:
    Edge& EdgeAt(Index e) { return edges_[static_cast<std::size_t>(e)]; }
    const Vec3& Point(Index v) const { return points_[static_cast<std::size_t>(v)]; }

    Far::Place PlaceIn(Index piece, const At& at) const {
        const FacetDomain& domain = pieces_[static_cast<std::size_t>(piece)].domain;
        return {domain.face, domain.part, {at[0], at[1], 0}};
    }
    std::vector<Vec3> Limits(const std::vector<Far::Place>& places) { return limits_.At(places, positions_); }

    void PlaceNodes(Index n_nodes) {
        points_.resize(static_cast<std::size_t>(n_nodes));
        std::vector<bool> is_placed(points_.size());
        std::vector<Index> nodes;
        std::vector<Far::Place> places;
        for (const Facet& piece : pieces_) {
            for (std::size_t c = 0; c < 3; ++c) {
                const Index v = piece.vertices[c];
                if (is_placed[static_cast<std::size_t>(v)]) continue;
                is_placed[static_cast<std::size_t>(v)] = true;
                nodes.push_back(v);
                const At& at = piece.domain.corners[c];
                places.push_back({piece.domain.face, piece.domain.part, {at[0], at[1], 0}});
            }
        }
        const std::vector<Vec3> limits = Limits(places);
        for (std::size_t i = 0; i < nodes.size(); ++i) points_[static_cast<std::size_t>(nodes[i])] = limits[i];
    }

    /// Its longest edge comes first; of equal ones that of the lowest vertices, so that neighbours often agree.
    void AddPiece(Index p) {
        const Facet& piece = pieces_[static_cast<std::size_t>(p)];
        const auto rank = [&](std::size_t k) {
            const auto [low, high] = std::minmax(piece.vertices[k], piece.vertices[(k + 1) % 3]);
            return std::make_pair(-Length(Point(high) - Point(low)), std::make_pair(low, high));
        };
        std::size_t first = 0;
        for (std::size_t k = 1; k < 3; ++k) {
            if (rank(k) < rank(first)) first = k;
        }
        std::array<Index, 3> v{};
        std::array<At, 3> at{};
        for (std::size_t k = 0; k < 3; ++k) {
            v[k] = piece.vertices[(first + k) % 3];
            at[k] = piece.domain.corners[(first + k) % 3];
        }
        std::array<bool, 3> is_of_control_mesh{};
        for (std::size_t k = 0; k < 3; ++k) {
            is_of_control_mesh[k] = std::max(v[k], v[(k + 1) % 3]) < refiner_.n_vertices(0);
        }
        AddTriangle(p, v, at, is_of_control_mesh);
    }

    /// @param is_of_control_mesh of those of its edges that are new
    void AddTriangle(Index piece, const std::array<Index, 3>& v, const std::array<At, 3>& at,
                     const std::array<bool, 3>& is_of_control_mesh) {
        Triangle t{piece, v, at, {}};
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t next = (k + 1) % 3;
            t.edges[k] = FindEdge({{v[k], v[next]}, piece, {at[k], at[next]}, is_of_control_mesh[k]});
        }
        triangles_.push_back(t);
    }

    Index FindEdge(const Edge& edge) {
        const auto [low, high] = std::minmax(edge.ends[0], edge.ends[1]);
        const std::uint64_t key = (static_cast<std::uint64_t>(low) << 32) | static_cast<std::uint64_t>(high);
        const auto [found, is_new] = edge_of_.try_emplace(key, static_cast<Index>(edges_.size()));
        if (is_new) edges_.push_back(edge);
        return found->second;
    }

    /// Measures edges and triangles that are new.
    void Test() {
        std::vector<Far::Place> places;
        for (std::size_t e = n_tested_edges_; e < edges_.size(); ++e) {
            const Edge& edge = edges_[e];
            const At middle = Middle(edge.at[0], edge.at[1]);
            for (const At& at : {Middle(edge.at[0], middle), middle, Middle(middle, edge.at[1])}) {
                places.push_back(PlaceIn(edge.piece, at));
            }
        }
        std::vector<std::size_t> fresh;
        for (std::size_t i = 0; i < triangles_.size(); ++i) {
            const Triangle& t = triangles_[i];
            if (t.is_tested) continue;
            fresh.push_back(i);
            for (const auto& w : kTestsInside) {
                At at{};
                for (std::size_t k = 0; k < 2; ++k) at[k] = w[0] * t.at[0][k] + w[1] * t.at[1][k] + w[2] * t.at[2][k];
                places.push_back(PlaceIn(t.piece, at));
            }
        }
        const std::vector<Vec3> limits = Limits(places);
        n_tests_ += static_cast<Offset>(limits.size());
        auto limit = limits.begin();
        for (std::size_t e = n_tested_edges_; e < edges_.size(); ++e, limit += 3) {
            std::copy_n(limit, 3, edges_[e].limits.begin());
            MeasureToChord(edges_[e]);
        }
        for (std::size_t i : fresh) {
            Triangle& t = triangles_[i];
            t.is_tested = true;
            for (std::size_t k = 0; k < kTestsInside.size(); ++k, ++limit) {
                t.error = std::max(t.error, Distance(*limit, t));
            }
        }
        n_tested_edges_ = edges_.size();
        MeasureToTriangles();
    }

    void MeasureToChord(Edge& edge) const {
        for (std::size_t k = 0; k < 3; ++k) {
            edge.distances[k] = DistanceTo(edge.limits[k], Point(edge.ends[0]), Point(edge.ends[1]));
        }
    }

    /// Edges inside faces whose chord is too far, against the triangles that they have by now.
    void MeasureToTriangles() {
        std::vector<bool> is_measured(edges_.size());
        for (std::size_t e = 0; e < edges_.size(); ++e) {
            Edge& edge = edges_[e];
            if (edge.is_of_control_mesh || edge.vertex != kNoIndex) continue;
            MeasureToChord(edge);
            is_measured[e] = edge.Error() > MostError();
        }
        for (const Triangle& t : triangles_) {
            for (Index e : t.edges) {
                if (!is_measured[static_cast<std::size_t>(e)]) continue;
                Edge& edge = EdgeAt(e);
                for (std::size_t k = 0; k < 3; ++k) {
                    edge.distances[k] = std::min(edge.distances[k], Distance(edge.limits[k], t));
                }
            }
        }
    }

    double MostError() const { return 0.8 * options_.tolerance; }
    double Distance(const Vec3& p, const Triangle& t) const {
        return DistanceTo(p, Point(t.vertices[0]), Point(t.vertices[1]), Point(t.vertices[2]));
    }

    /// @returns whether any edge is marked
    bool Mark() {
        const double most = MostError();
        bool is_any = false;
        const auto mark = [&](Index e) {
            const bool is_new = !EdgeAt(e).is_marked;
            EdgeAt(e).is_marked = true;
            is_any = is_any || is_new;
            return is_new;
        };
        for (const Triangle& t : triangles_) {
            for (Index e : t.edges) {
                if (EdgeAt(e).Error() > most) mark(e);
            }
            if (t.error > most) mark(t.edges[0]);
        }
        for (bool is_done = !is_any; !is_done;) {
            is_done = true;
            for (const Triangle& t : triangles_) {
                if ((EdgeAt(t.edges[1]).is_marked || EdgeAt(t.edges[2]).is_marked) && mark(t.edges[0])) is_done = false;
            }
        }
        return is_any;
    }

    void Cut() {
        for (Edge& edge : edges_) {
            if (!edge.is_marked || edge.vertex != kNoIndex) continue;
            edge.vertex = static_cast<Index>(points_.size());
            points_.push_back(edge.limits[1]);
        }
        const std::vector<Triangle> before = std::move(triangles_);
        triangles_.clear();
        for (const Triangle& t : before) CutTriangle(t);
        if (static_cast<Offset>(triangles_.size()) > options_.max_facets) {
            throw InvalidInput("a tolerance of " + std::to_string(options_.tolerance) + " takes more than the " +
                               std::to_string(options_.max_facets) + " facets allowed; give a larger one");
        }
    }

    void CutTriangle(const Triangle& t) {
        const Index m = EdgeAt(t.edges[0]).vertex;
        if (m == kNoIndex) {
            triangles_.push_back(t);
            return;
        }
        const auto& [a, b, c] = t.vertices;
        const At at_m = Middle(t.at[0], t.at[1]);
        const bool is_of_control_mesh = EdgeAt(t.edges[0]).is_of_control_mesh;
        CutChild(t.piece, {c, a, m}, {t.at[2], t.at[0], at_m}, {false, is_of_control_mesh, false});
        CutChild(t.piece, {b, c, m}, {t.at[1], t.at[2], at_m}, {false, false, is_of_control_mesh});
    }
    void CutChild(Index piece, const std::array<Index, 3>& v, const std::array<At, 3>& at,
                  const std::array<bool, 3>& is_of_control_mesh) {
        AddTriangle(piece, v, at, is_of_control_mesh);
        if (EdgeAt(triangles_.back().edges[0]).vertex == kNoIndex) return;
        const Triangle child = triangles_.back();
        triangles_.pop_back();
        CutTriangle(child);
    }

    const Far::TopologyRefiner& refiner_;
    LimitPoints limits_;
    const std::span<const double> positions_;
    const TessellationOptions& options_;
    const std::vector<Facet>& pieces_;
    std::vector<Vec3> points_;  // of nodes, then of vertices in the middles of edges
    std::vector<Edge> edges_;
    std::unordered_map<std::uint64_t, Index> edge_of_;
    std::size_t n_tested_edges_ = 0;
    std::vector<Triangle> triangles_;
    Offset n_tests_ = 0;
};

}  // namespace

CloseFacets BisectToTolerance(const Far::TopologyRefiner& refiner, const Sdc::Scheme& scheme,
                              std::span<const double> positions, const TessellationOptions& options,
                              const BoundaryPieces& triangles) {
    return Bisection(refiner, scheme, positions, options, triangles).Take();
}

}  // namespace SolidSubdiv::Geometry::Internal
