// SPDX-License-Identifier: Apache-2.0
// Walks around the ends of an edge and weights what it meets.
#include "butterfly_stencils_oracle.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace SolidSubdiv::Validation {

namespace {

/// The vertices around one end of an edge, as far as no crease is crossed.
struct Fan {
    int center = 0;
    std::vector<int> vertices;  ///< in order; closed: n, else k + 1 from crease to crease
    bool is_closed = false;
    std::size_t at = 0;  ///< place of the edge's other end

    int n_triangles() const { return static_cast<int>(vertices.size()) - (is_closed ? 0 : 1); }
};

class EdgeStencil {
  public:
    EdgeStencil(const TaggedLevel& level, const ButterflyRule& rule, int edge)
        : level_(level),
          rule_(rule),
          edge_(edge),
          a_(level.topology.GetEdgeVertices(edge)[0]),
          b_(level.topology.GetEdgeVertices(edge)[1]) {}

    Stencil Make() {
        if (level_.is_crease[edge_]) {
            AddCurve();
        } else if (rule_.kind == ButterflyRule::Kind::Plain) {
            AddPoints(1.0 / 2, 2 * rule_.tension, -rule_.tension);
        } else {
            AddModified();
        }
        return std::move(stencil_);
    }

  private:
    int OtherEnd(int edge, int v) const {
        const auto ends = level_.topology.GetEdgeVertices(edge);
        return ends[0] == v ? ends[1] : ends[0];
    }
    int OtherFace(int edge, int face) const {
        const auto faces = level_.topology.GetEdgeFaces(edge);
        return faces[0] == face ? faces[1] : faces[0];
    }
    /// The third vertex of a face of the edge.
    int Opposite(int face, int edge) const {
        const auto ends = level_.topology.GetEdgeVertices(edge);
        for (const int v : level_.topology.GetFaceVertices(face)) {
            if (v != ends[0] && v != ends[1]) return v;
        }
        throw std::runtime_error("butterfly oracle: a triangle with a vertex twice");
    }
    /// The edge of the face that meets `edge` in v.
    int NextEdge(int face, int edge, int v) const {
        for (const int e : level_.topology.GetFaceEdges(face)) {
            const auto ends = level_.topology.GetEdgeVertices(e);
            if (e != edge && (ends[0] == v || ends[1] == v)) return e;
        }
        throw std::runtime_error("butterfly oracle: a triangle without the edges of its vertices");
    }

    void AddCurve() {
        const double w = rule_.curve_tension;
        const int before = Continuation(a_, edge_), after = Continuation(b_, edge_);
        stencil_[a_] += 1.0 / 2;
        stencil_[b_] += 1.0 / 2;
        if (before < 0 && after < 0) return;
        // The second difference at each end that the curve runs through, and that of the other end in its place.
        const auto bend = [&](int beyond, int near, int far, double weight) {
            stencil_[beyond] -= weight;
            stencil_[near] += 2 * weight;
            stencil_[far] -= weight;
        };
        const bool one_end = before < 0 || after < 0;
        if (before >= 0) bend(before, a_, b_, one_end ? 2 * w : w);
        if (after >= 0) bend(after, b_, a_, one_end ? 2 * w : w);
    }
    bool IsRegular(const Fan& fan) const {
        if (fan.is_closed) return fan.n_triangles() == 6;
        return fan.n_triangles() == 3 && (rule_.has_regular_corners || !IsEnd(fan.center));
    }
    /// Whether curves end in v. Where the surface is no manifold a curve of its own seams goes through alone
    /// (docs/decisions/0010).
    bool IsEnd(int v) const {
        int n_creases = 0, n_seams = 0;
        for (const int e : level_.topology.GetVertexEdges(v)) {
            n_creases += level_.is_crease[e];
            n_seams += level_.topology.GetEdgeFaces(e).size() != 2;
        }
        const bool is_pinched = level_.topology.IsVertexNonManifold(v) && n_seams != 2;
        return level_.is_corner[v] || n_creases != 2 || is_pinched;
    }
    /// The vertex before `v` on the curve that leaves it by `edge`, or -1 if the curve ends there.
    int Continuation(int v, int edge) const {
        if (IsEnd(v)) return -1;
        for (const int e : level_.topology.GetVertexEdges(v)) {
            if (level_.is_crease[e] && e != edge) return OtherEnd(e, v);
        }
        return -1;
    }

    void AddModified() {
        const Fan fans[] = {FanAround(a_), FanAround(b_)};
        const int n_extraordinary = !IsRegular(fans[0]) + !IsRegular(fans[1]);
        if (n_extraordinary > 0) {
            for (const Fan& fan : fans) {
                if (!IsRegular(fan)) AddMask(fan, 1.0 / n_extraordinary);
            }
            return;
        }
        // A sector of three triangles has no vertex straight ahead.
        const bool all_there = fans[0].is_closed && fans[1].is_closed && HasAllWings();
        const double w = all_there ? rule_.tension : 0;
        AddPoints(1.0 / 2 - w, 1.0 / 8 + 2 * w, -1.0 / 16 - w);
        if (w != 0) {
            for (const Fan& fan : fans) stencil_[fan.vertices[(fan.at + 3) % 6]] += w;
        }
    }

    /// Ends, opposite vertices, wings.
    void AddPoints(double ends, double opposite, double wings) {
        for (const int v : {a_, b_}) stencil_[v] += ends;
        for (const int face : level_.topology.GetEdgeFaces(edge_)) {
            const int c = Opposite(face, edge_);
            stencil_[c] += opposite;
            for (const int v : {a_, b_}) {
                const int side = NextEdge(face, edge_, v);
                if (!level_.is_crease[side]) {
                    stencil_[Opposite(OtherFace(side, face), side)] += wings;
                    continue;
                }
                stencil_[v] += wings;
                stencil_[c] += wings;
                stencil_[v == a_ ? b_ : a_] -= wings;
            }
        }
    }
    bool HasAllWings() const {
        for (const int face : level_.topology.GetEdgeFaces(edge_)) {
            for (const int v : {a_, b_}) {
                if (level_.is_crease[NextEdge(face, edge_, v)]) return false;
            }
        }
        return true;
    }

    Fan FanAround(int center) const {
        struct Way {
            std::vector<int> vertices;
            int last_edge = 0;
        };
        const auto walk = [&](int face) {
            Way way{{}, edge_};
            do {
                way.last_edge = NextEdge(face, way.last_edge, center);
                way.vertices.push_back(OtherEnd(way.last_edge, center));
                if (way.last_edge == edge_ || level_.is_crease[way.last_edge]) break;
                face = OtherFace(way.last_edge, face);
            } while (true);
            return way;
        };
        const auto faces = level_.topology.GetEdgeFaces(edge_);
        const Way one = walk(faces[0]);
        Fan fan{center, one.vertices, true, one.vertices.size() - 1};
        if (one.last_edge == edge_) return fan;
        const Way other = walk(faces[1]);
        std::reverse(fan.vertices.begin(), fan.vertices.end());
        fan.at = fan.vertices.size();
        fan.vertices.push_back(OtherEnd(edge_, center));
        fan.vertices.insert(fan.vertices.end(), other.vertices.begin(), other.vertices.end());
        fan.is_closed = one.last_edge == other.last_edge;
        if (fan.is_closed) fan.vertices.pop_back();
        return fan;
    }

    void AddMask(const Fan& fan, double factor) {
        const std::size_t n = fan.vertices.size();
        std::vector<double> mask(n);
        double center = 0.75;
        if (fan.is_closed) {
            for (std::size_t j = 0; j < n; ++j) mask[(fan.at + j) % n] = RingWeight(n, j);
        } else {
            center = FillSectorMask(fan.at, mask);
        }
        stencil_[fan.center] += factor * center;
        for (std::size_t j = 0; j < n; ++j) stencil_[fan.vertices[j]] += factor * mask[j];
    }
    static double RingWeight(std::size_t n, std::size_t j) {
        if (n == 3) return j == 0 ? 5.0 / 12 : -1.0 / 12;
        if (n == 4) return j == 0 ? 3.0 / 8 : j == 2 ? -1.0 / 8 : 0;
        const double angle = 2 * std::numbers::pi * static_cast<double>(j) / static_cast<double>(n);
        return (1.0 / 4 + std::cos(angle) + std::cos(2 * angle) / 2) / static_cast<double>(n);
    }
    /// Weights of r0 to rk for the new point on the edge to r_at. Returns the center's.
    static double FillSectorMask(std::size_t at, std::vector<double>& mask) {
        const std::size_t k = mask.size() - 1;
        const double n = static_cast<double>(k), theta = std::numbers::pi / n, phi = theta * static_cast<double>(at);
        for (std::size_t j = 0; j <= k; ++j) {
            const double psi = theta * static_cast<double>(j);
            mask[j] = (std::sin(phi) * std::sin(psi) + std::sin(2 * phi) * std::sin(2 * psi) / 2) / n;
        }
        const double c = std::cos(phi) / 4 -
                         std::sin(2 * theta) * std::sin(2 * phi) / (4 * n * (std::cos(theta) - std::cos(2 * theta)));
        mask.front() += c;
        mask.back() -= c;
        return 1 - std::sin(theta) * std::sin(phi) / (n * (1 - std::cos(theta)));
    }

    const TaggedLevel& level_;
    const ButterflyRule& rule_;
    int edge_, a_, b_;
    Stencil stencil_;
};

}  // namespace

Stencil ButterflyStencil(const TaggedLevel& level, const ButterflyRule& rule, int edge) {
    return EdgeStencil(level, rule, edge).Make();
}

}  // namespace SolidSubdiv::Validation
