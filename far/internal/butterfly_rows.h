// SPDX-License-Identifier: Apache-2.0
// Rows of new points on the edges of surfaces under the butterflies, which look further than an edge's own faces.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <tuple>

#include <solidsubdiv/far/internal/row_entries.h>
#include <solidsubdiv/far/internal/surface_rings.h>
#include <solidsubdiv/sdc/interpolating_masks.h>

namespace SolidSubdiv::Far::Internal {

/// Rows of edges that follow the surface rule and are no creases, under a butterfly. What neighbouring edges ask again
/// and again is found once a level. Source: rules.md section 6.
class ButterflyRows {
  public:
    ButterflyRows(const Level& level, const SharpRules& sharp, const Sdc::ButterflySurface& rule)
        : level_(level),
          walk_(level, sharp),
          rule_(rule),
          rings_(level, walk_),
          has_eight_points_(!rule.is_modified || rule.far_weight == 0) {
        for (std::size_t n = 3; rule.is_modified && n < kFew; ++n) {
            Sdc::ButterflySurface::ClosedRing(static_cast<int>(n), {closed_rings_[n].data(), n});
        }
        std::apply([&](auto&... weights) { (SetUsualWeights(weights), ...); }, usual_weights_);
    }

    std::size_t MaxLength(Index e) const {
        if (HasRegularEnds(e)) return kRegularLength;
        const auto ends = level_.EdgeVertices(e);  // both rings and the four wings
        return static_cast<std::size_t>(level_.vertex_edges.Count(ends[0]) + level_.vertex_edges.Count(ends[1]) + 10);
    }

    /// Calls add(vertex, weight) for the entries of a usual row; false, and no call, if the row must be filled.
    template <class Real, class Add>
    bool Visit(Index e, Add&& add) const {
        const auto ends = level_.EdgeVertices(e);
        const bool is_regular[2] = {rings_.IsRegular(ends[0]), rings_.IsRegular(ends[1])};
        if (is_regular[0] && is_regular[1]) return has_eight_points_ && VisitEightPoints<Real>(e, add);
        if (is_regular[0] == is_regular[1] || !rule_.is_modified) return false;
        return VisitOneRing<Real>(e, is_regular[0], add);
    }

    /// Fills the row and returns its length.
    template <class Real>
    int Fill(Index e, Index* indices, Real* weights) const {
        RowEntries<Real> row(indices, weights);
        for (Index end : level_.EdgeVertices(e)) row.Add(end, Straight());
        std::array<Room<Index>, 2> rooms;
        const Fans fans = rule_.is_modified ? FansAt(e, rooms) : Fans{};
        if (!FillFromFans(e, fans, row)) FillRegular(e, fans, row);
        return row.size();
    }

  private:
    static constexpr std::size_t kRegularLength = 10;
    static constexpr std::size_t kFew = 13;

    bool HasRegularEnds(Index e) const {
        const auto ends = level_.EdgeVertices(e);
        return rings_.IsRegular(ends[0]) && rings_.IsRegular(ends[1]);
    }
    /// The weight of an end in the middle of the edge.
    double Straight() const { return (1 - rule_.pull) / 2; }

    /// The eight points between regular vertices, if all are there and stand once; the same row as FillRegular's.
    template <class Real, class Add>
    bool VisitEightPoints(Index e, Add&& add) const {
        const auto ends = level_.EdgeVertices(e);
        const SurfaceWalk::Faces faces = walk_.FacesAt(e);
        std::array<Index, 2> opposite;
        std::array<Index, 4> wings;  // of the first face at either end, of the second
        for (int i = 0; i < 2; ++i) {
            const Index f = i == 0 ? faces.first : faces.second;
            const auto edges = level_.FaceEdges(f);
            const int mine = edges[0] == e ? 0 : edges[1] == e ? 1 : 2;
            opposite[i] = level_.FaceVertices(f)[mine];
            // Faces and edges list vertices ascending: the face's other edges lie opposite this one's ends in order.
            const std::uint32_t at_last = rings_.Sum(edges[mine == 0 ? 1 : 0]),
                                at_first = rings_.Sum(edges[mine == 2 ? 1 : 2]);
            if (at_first == SurfaceRings::kNothing || at_last == SurfaceRings::kNothing) return false;
            wings[2 * i] = static_cast<Index>(at_first - static_cast<std::uint32_t>(ends[1]));
            wings[2 * i + 1] = static_cast<Index>(at_last - static_cast<std::uint32_t>(ends[0]));
        }
        // Around each end six vertices are distinct: only wings of one can be wings of the other too.
        if (wings[0] == wings[1] || wings[0] == wings[3] || wings[2] == wings[1] || wings[2] == wings[3]) return false;
        const auto& w = std::get<UsualWeights<Real>>(usual_weights_);
        for (Index v : ends) add(v, w.end);
        for (Index v : opposite) add(v, w.opposite);
        for (Index v : wings) add(v, w.wing);
        return true;
    }

    /// The row of an edge of which one end, the first or the second, is not regular; the same as FillFromFans'.
    template <class Real, class Add>
    bool VisitOneRing(Index e, int end, Add&& add) const {
        const auto ends = level_.EdgeVertices(e);
        const auto ring = rings_.RingFrom(ends[end], ends[1 - end]);
        const std::size_t n = ring.size();
        if (n < 3 || n == 6 || n >= kFew) return false;
        const auto& w = std::get<UsualWeights<Real>>(usual_weights_);
        add(ends[0], end == 0 ? w.ring_self : w.rings[n][0]);
        add(ends[1], end == 0 ? w.rings[n][0] : w.ring_self);
        for (std::size_t i = 1; i < n; ++i) {
            if (w.rings[n][i] != 0) add(ring[i], w.rings[n][i]);
        }
        return true;
    }

    /// Weights of rows that are visited, as the rows' numbers.
    template <class Real>
    struct UsualWeights {
        Real end, opposite, wing, ring_self;
        std::array<std::array<Real, kFew>, kFew> rings{};  ///< by the number of triangles; of the other end first
    };
    template <class Real>
    void SetUsualWeights(UsualWeights<Real>& weights) const {
        const Sdc::ButterflyWeights w = rule_.Regular(false);
        const Real straight = static_cast<Real>(Straight());
        weights.end = straight + static_cast<Real>(rule_.pull * w.end);
        weights.opposite = static_cast<Real>(rule_.pull * w.opposite);
        weights.wing = static_cast<Real>(rule_.pull * w.wing);
        weights.ring_self = straight + static_cast<Real>(rule_.pull * Sdc::ButterflySurface::kClosedRingSelf);
        for (std::size_t n = 3; n < kFew; ++n) {
            for (std::size_t i = 0; i < n; ++i) {
                weights.rings[n][i] = static_cast<Real>(rule_.pull * closed_rings_[n][i]);
            }
            weights.rings[n][0] += straight;
        }
    }

    using Fans = std::array<Fan, 2>;

    /// The fans of the ends that are not plainly regular.
    Fans FansAt(Index e, std::array<Room<Index>, 2>& rooms) const {
        Fans fans;
        for (int i = 0; i < 2; ++i) {
            const Index v = level_.EdgeVertices(e)[i];
            if (!rings_.IsRegular(v)) fans[i] = rings_.FanAt(v, e, rooms[i]);
        }
        return fans;
    }
    /// Three triangles at a border are regular where the border runs through; at its end the regular rule would let
    /// slopes grow from level to level (docs/butterfly-boundaries.md).
    bool IsRegular(const Fan& fan, Index v) const {
        if (fan.ring.empty()) return true;
        if (fan.is_closed) return fan.n_triangles() == 6;
        return fan.n_triangles() == 3 && walk_.NextOnCurve(fan.border, v) != kNoIndex;
    }

    /// Fills from the rings of the ends that are not regular; false if both are.
    template <class Real>
    bool FillFromFans(Index e, const Fans& fans, RowEntries<Real>& row) const {
        const auto ends = level_.EdgeVertices(e);
        const std::array<bool, 2> has_own_ring{!IsRegular(fans[0], ends[0]), !IsRegular(fans[1], ends[1])};
        const int n_rings = has_own_ring[0] + has_own_ring[1];
        for (int i = 0; i < 2; ++i) {
            if (has_own_ring[i]) AddRing(ends[i], fans[i], rule_.pull / n_rings, row);
        }
        return n_rings > 0;
    }

    template <class Real>
    void AddRing(Index v, const Fan& fan, double share, RowEntries<Real>& row) const {
        Room<double> room;
        const double *ring, self = RingWeights(fan, room, ring);
        const bool is_first = row.size() == 2;  // with nothing but the edge's ends: here ring[0] and v
        row.Add(v, share * self);
        for (std::size_t i = 0; i < fan.ring.size(); ++i) {
            if (ring[i] == 0) continue;
            if (is_first && fan.is_closed && i > 0) {
                row.AddNew(fan.ring[i], share * ring[i]);
            } else {
                row.Add(fan.ring[i], share * ring[i]);
            }
        }
    }
    /// Weights of a ring, in the room or known before, and of the vertex inside.
    double RingWeights(const Fan& fan, Room<double>& room, const double*& ring) const {
        const int n = fan.n_triangles();
        if (fan.is_closed && fan.ring.size() < kFew) {
            ring = closed_rings_[n].data();
            return Sdc::ButterflySurface::kClosedRingSelf;
        }
        const std::span<double> weights(room.For(fan.ring.size()), fan.ring.size());
        ring = weights.data();
        return fan.is_closed ? Sdc::ButterflySurface::ClosedRing(n, weights)
                             : Sdc::ButterflySurface::OpenRing(n, fan.place, weights);
    }

    template <class Real>
    void FillRegular(Index e, const Fans& fans, RowEntries<Real>& row) const {
        const auto ends = level_.EdgeVertices(e);
        const SurfaceWalk::Faces faces = walk_.FacesAt(e);
        std::array<Index, 2> opposite;
        std::array<std::array<Index, 2>, 2> wing, wing_face;  // of face i, across the edge at end k
        bool has_far = rule_.is_modified && rule_.far_weight != 0;
        for (int i = 0; i < 2; ++i) {
            const Index f = i == 0 ? faces.first : faces.second;
            opposite[i] = level_.ThirdVertex(f, e);
            for (int k = 0; k < 2; ++k) {
                const Index side = walk_.EdgeOpposite(f, ends[1 - k]);
                const bool is_there = !walk_.EndsSurface(side);
                wing_face[i][k] = is_there ? walk_.Across(side, f) : kNoIndex;
                wing[i][k] = is_there ? level_.ThirdVertex(wing_face[i][k], side) : kNoIndex;
                has_far = has_far && is_there;
            }
        }
        std::array<Index, 2> far{kNoIndex, kNoIndex};
        for (int k = 0; k < 2 && has_far; ++k) {
            far[k] = FarPoint(fans[k], opposite[0], wing_face[0][k]);
            has_far = far[k] != kNoIndex;
        }

        const Sdc::ButterflyWeights w = rule_.Regular(has_far);
        for (Index end : ends) row.Add(end, rule_.pull * w.end);
        for (Index v : opposite) row.Add(v, rule_.pull * w.opposite);
        for (int i = 0; i < 2; ++i) {
            for (int k = 0; k < 2; ++k) {
                const double weight = rule_.pull * w.wing;
                if (wing[i][k] != kNoIndex) {
                    row.Add(wing[i][k], weight);
                } else {  // across a border: the parallelogram's corner
                    row.Add(ends[k], weight);
                    row.Add(opposite[i], weight);
                    row.Add(ends[1 - k], -weight);
                }
            }
        }
        for (int k = 0; k < 2 && has_far; ++k) row.Add(far[k], rule_.pull * w.far);
    }

    /// The vertex straight on beyond an end, or kNoIndex at a border.
    Index FarPoint(const Fan& fan, Index opposite, Index wing_face) const {
        if (!fan.ring.empty()) return fan.is_closed ? fan.ring[3] : kNoIndex;
        const Index to_wing = walk_.EdgeOpposite(wing_face, opposite);
        return level_.ThirdVertex(walk_.Across(to_wing, wing_face), to_wing);
    }

    const Level& level_;
    const SurfaceWalk walk_;
    const Sdc::ButterflySurface rule_;
    const SurfaceRings rings_;
    const bool has_eight_points_;                                // between regular vertices
    std::array<std::array<double, kFew>, kFew> closed_rings_{};  // weights, by the number of triangles
    std::tuple<UsualWeights<float>, UsualWeights<double>> usual_weights_;
};

}  // namespace SolidSubdiv::Far::Internal
