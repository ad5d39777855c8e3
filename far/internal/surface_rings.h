// SPDX-License-Identifier: Apache-2.0
// Which vertices of a surface are regular, and the rings of those inside that are not, found once a level.
#pragma once

#include <algorithm>

#include <solidsubdiv/far/internal/surface_walk.h>
#include <solidsubdiv/sdc/parallel.h>

namespace SolidSubdiv::Far::Internal {

class SurfaceRings {
  public:
    /// @param walk outlives this
    SurfaceRings(const Level& level, const SurfaceWalk& walk) : level_(level), walk_(walk) {
        is_regular_.resize(static_cast<std::size_t>(level.n_vertices));
        FindRings();
    }

    /// Inside a surface, among six triangles.
    bool IsRegular(Index v) const { return is_regular_[v] != 0; }

    /// As SurfaceWalk::FanAt, from the rings found before where there is one.
    Fan FanAt(Index v, Index e, Room<Index>& room) const {
        const Offset start = ring_offsets_[v];
        const std::size_t n = static_cast<std::size_t>(ring_offsets_[v + 1] - start);
        const Index* const known = rings_.data() + start;
        if (n == 0 || known[0] == kNoIndex) return walk_.FanAt(v, e, room);
        Index* const ring = room.For(n);
        const auto ends = level_.EdgeVertices(e);
        std::size_t at = 0;
        while (known[at] != ends[0] + ends[1] - v) ++at;
        const bool is_forward = known[at + 1 < n ? at + 1 : 0] == level_.ThirdVertex(walk_.FacesAt(e).first, e);
        for (std::size_t i = 0; i < n; ++i) {
            ring[i] = known[at];
            at = is_forward ? (at + 1 < n ? at + 1 : 0) : (at > 0 ? at - 1 : n - 1);
        }
        return {true, {ring, n}};
    }

  private:
    static constexpr Offset kGrain = 4096;

    /// Finds the rings of vertices inside surfaces that are not regular: all their edges ask for them.
    void FindRings() {
        ring_offsets_.resize(static_cast<std::size_t>(level_.n_vertices) + 1);
        const auto for_vertices = [&](auto&& body) {
            Sdc::ParallelFor(level_.n_vertices, kGrain, [&](Offset begin, Offset end) {
                for (Offset v = begin; v < end; ++v) body(static_cast<Index>(v));
            });
        };
        for_vertices([&](Index v) {
            is_regular_[v] = walk_.IsRegularInside(v);
            ring_offsets_[v] = 0;
            if (is_regular_[v] || !walk_.IsInside(v)) return;
            for (Index e : level_.vertex_edges[v]) ring_offsets_[v] += !walk_.EndsSurface(e);
        });
        rings_.resize(static_cast<std::size_t>(Sdc::ScanLengths(ring_offsets_)));
        for_vertices([&](Index v) {
            if (ring_offsets_[v] == ring_offsets_[v + 1]) return;
            const auto edges = level_.vertex_edges[v];
            const Index e = *std::find_if(edges.begin(), edges.end(), [&](Index i) { return !walk_.EndsSurface(i); });
            Room<Index> room;
            const Fan fan = walk_.FanAt(v, e, room);
            const auto ring = rings_.begin() + ring_offsets_[v];
            if (fan.is_closed && static_cast<Offset>(fan.ring.size()) == ring_offsets_[v + 1] - ring_offsets_[v]) {
                std::copy(fan.ring.begin(), fan.ring.end(), ring);
            } else {
                *ring = kNoIndex;  // a curve ends here
            }
        });
    }

    const Level& level_;
    const SurfaceWalk& walk_;
    Array<std::uint8_t> is_regular_;  // of each vertex
    Array<Offset> ring_offsets_;      // of each vertex: its ring in rings_, if it is inside a surface and not regular
    Array<Index> rings_;
};

}  // namespace SolidSubdiv::Far::Internal
