// SPDX-License-Identifier: Apache-2.0
// Rows of new points on curves under the 4-point rule.
#pragma once

#include <array>

#include <solidsubdiv/far/internal/row_entries.h>
#include <solidsubdiv/far/internal/surface_walk.h>
#include <solidsubdiv/sdc/interpolating_masks.h>

namespace SolidSubdiv::Far::Internal {

inline constexpr std::size_t kFourPointLength = 4;

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
