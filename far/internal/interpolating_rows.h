// SPDX-License-Identifier: Apache-2.0
// Rows of new points on edges under the rules that look further than an edge's own faces: butterflies and 4-point
// curves.
#pragma once

#include <array>
#include <vector>

#include <solidsubdiv/far/internal/row_entries.h>
#include <solidsubdiv/far/internal/surface_walk.h>
#include <solidsubdiv/sdc/interpolating_masks.h>

namespace SolidSubdiv::Far::Internal {

/// Entries that a row of these rules may need: both rings and the four wings.
inline std::size_t MaxInterpolatingLength(const Level& level, Index e) {
    const auto ends = level.EdgeVertices(e);
    return static_cast<std::size_t>(level.vertex_edges.Count(ends[0]) + level.vertex_edges.Count(ends[1]) + 10);
}

/// Source: rules.md section 6. @pre e follows the surface rule and is no crease
template <class Real>
class ButterflyRow {
  public:
    ButterflyRow(const Level& level, const SharpRules& sharp, const Sdc::ButterflySurface& rule, Index e,
                 RowEntries<Real>& row)
        : level_(level), walk_(level, sharp), rule_(rule), row_(row), e_(e) {
        const auto ends = level.EdgeVertices(e);
        ends_ = {ends[0], ends[1]};
    }

    void Fill() {
        const double straight = (1 - rule_.pull) / 2;
        row_.Add(ends_[0], straight);
        row_.Add(ends_[1], straight);
        if (rule_.is_modified && FillFromFans()) return;
        FillRegular();
    }

  private:
    /// Fills from the rings of the ends that are not regular; false if both are.
    bool FillFromFans() {
        std::array<bool, 2> has_own_ring{false, false};
        for (int i = 0; i < 2; ++i) {
            if (walk_.IsRegularInside(ends_[i])) continue;
            fans_[i] = walk_.FanAt(ends_[i], e_);
            has_own_ring[i] = !IsRegular(fans_[i], ends_[i]);
        }
        const int n_rings = has_own_ring[0] + has_own_ring[1];
        for (int i = 0; i < 2; ++i) {
            if (has_own_ring[i]) AddRing(ends_[i], fans_[i], rule_.pull / n_rings);
        }
        return n_rings > 0;
    }

    /// Three triangles at a border are regular where the border runs through; at its end the regular rule would let
    /// slopes grow from level to level (docs/butterfly-boundaries.md).
    bool IsRegular(const Fan& fan, Index v) const {
        if (fan.is_closed) return fan.n_triangles() == 6;
        return fan.n_triangles() == 3 && walk_.NextOnCurve(fan.border, v) != kNoIndex;
    }

    void AddRing(Index v, const Fan& fan, double share) {
        std::vector<double> ring(fan.ring.size());
        const double self = fan.is_closed ? Sdc::ButterflySurface::ClosedRing(fan.n_triangles(), ring)
                                          : Sdc::ButterflySurface::OpenRing(fan.n_triangles(), fan.place, ring);
        row_.Add(v, share * self);
        for (std::size_t i = 0; i < ring.size(); ++i) {
            if (ring[i] != 0) row_.Add(fan.ring[i], share * ring[i]);
        }
    }

    void FillRegular() {
        const SurfaceWalk::Faces faces = walk_.FacesAt(e_);
        std::array<Index, 2> opposite;
        std::array<std::array<Index, 2>, 2> wing, wing_face;  // of face i, across the edge at end k
        bool has_far = rule_.is_modified && rule_.far_weight != 0;
        for (int i = 0; i < 2; ++i) {
            const Index f = i == 0 ? faces.first : faces.second;
            opposite[i] = level_.ThirdVertex(f, e_);
            for (int k = 0; k < 2; ++k) {
                const Index side = walk_.EdgeOpposite(f, ends_[1 - k]);
                const bool is_there = !walk_.EndsSurface(side);
                wing_face[i][k] = is_there ? walk_.Across(side, f) : kNoIndex;
                wing[i][k] = is_there ? level_.ThirdVertex(wing_face[i][k], side) : kNoIndex;
                has_far = has_far && is_there;
            }
        }
        std::array<Index, 2> far{kNoIndex, kNoIndex};
        for (int k = 0; k < 2 && has_far; ++k) {
            far[k] = FarPoint(k, opposite[0], wing_face[0][k]);
            has_far = far[k] != kNoIndex;
        }

        const Sdc::ButterflyWeights w = rule_.Regular(has_far);
        for (Index end : ends_) row_.Add(end, rule_.pull * w.end);
        for (Index v : opposite) row_.Add(v, rule_.pull * w.opposite);
        for (int i = 0; i < 2; ++i) {
            for (int k = 0; k < 2; ++k) {
                const double weight = rule_.pull * w.wing;
                if (wing[i][k] != kNoIndex) {
                    row_.Add(wing[i][k], weight);
                } else {  // across a border: the parallelogram's corner
                    row_.Add(ends_[k], weight);
                    row_.Add(opposite[i], weight);
                    row_.Add(ends_[1 - k], -weight);
                }
            }
        }
        for (int k = 0; k < 2 && has_far; ++k) row_.Add(far[k], rule_.pull * w.far);
    }

    /// The vertex straight on beyond end k, or kNoIndex at a border.
    Index FarPoint(int k, Index opposite, Index wing_face) const {
        if (!fans_[k].ring.empty()) return fans_[k].is_closed ? fans_[k].ring[3] : kNoIndex;
        const Index to_wing = walk_.EdgeOpposite(wing_face, opposite);
        return level_.ThirdVertex(walk_.Across(to_wing, wing_face), to_wing);
    }

    const Level& level_;
    const SurfaceWalk walk_;
    const Sdc::ButterflySurface& rule_;
    RowEntries<Real>& row_;
    Index e_;
    std::array<Index, 2> ends_;
    std::array<Fan, 2> fans_;  // modified: of ends that are not plainly regular
};

/// The 4-point rule; at a curve's end the three points nearest. @pre e follows the curve rule or is a crease
template <class Real>
void FillFourPointRow(const Level& level, const SharpRules& sharp, const Sdc::FourPointCurve& rule, Index e,
                      RowEntries<Real>& row) {
    const SurfaceWalk walk(level, sharp);
    const auto ends = level.EdgeVertices(e);
    const std::array<Index, 2> next{walk.NextOnCurve(e, ends[0]), walk.NextOnCurve(e, ends[1])};
    const bool goes_on[2] = {next[0] != kNoIndex, next[1] != kNoIndex};
    if (goes_on[0] && goes_on[1]) {
        const auto w = rule.Edge();
        for (Index v : ends) row.Add(v, w.end);
        for (Index v : next) row.Add(v, w.next);
    } else if (goes_on[0] || goes_on[1]) {
        const int last = goes_on[0] ? 1 : 0;
        const auto w = rule.LastEdge();
        row.Add(ends[last], w.last);
        row.Add(ends[1 - last], w.end);
        row.Add(next[1 - last], w.next);
    } else {
        for (Index v : ends) row.Add(v, 0.5);
    }
}

}  // namespace SolidSubdiv::Far::Internal
