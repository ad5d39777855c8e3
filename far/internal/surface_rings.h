// SPDX-License-Identifier: Apache-2.0
// What lies around the edges and vertices of a surface, found once a level, since many edges ask.
#pragma once

#include <cstdint>

#include <solidsubdiv/far/internal/surface_walk.h>
#include <solidsubdiv/sdc/parallel.h>

namespace SolidSubdiv::Far::Internal {

class SurfaceRings {
  public:
    static constexpr std::uint32_t kNothing = ~std::uint32_t{0};  // no sum of two indices

    /// @param walk outlives this
    SurfaceRings(const Level& level, const SurfaceWalk& walk) : level_(level), walk_(walk) {
        sums_.resize(static_cast<std::size_t>(level.n_edges));
        Sdc::ParallelFor(level.n_edges, kGrain, [&](Offset begin, Offset end) {
            for (Offset e = begin; e < end; ++e) sums_[e] = SumOfThirds(static_cast<Index>(e));
        });
        FindRings();
    }

    /// The third vertices of the two faces at an edge, summed, or kNothing where the surface ends: less the one, it is
    /// the other.
    std::uint32_t Sum(Index e) const { return sums_[e]; }

    /// Inside a surface, among six triangles.
    bool IsRegular(Index v) const { return is_regular_[v] != 0; }

    /// The vertices around v in order, starting at any neighbour; empty if v is regular, not inside a surface, or if
    /// a curve ends there.
    std::span<const Index> RingFrom(Index v, Index neighbor) const {
        const std::size_t n = static_cast<std::size_t>(ring_offsets_[v + 1] - ring_offsets_[v]) / 2;
        const Index* known = rings_.data() + ring_offsets_[v];
        if (n == 0 || *known == kNoIndex) return {};
        while (*known != neighbor) ++known;
        return {known, n};
    }

    /// As SurfaceWalk::FanAt, from the rings found before where there is one, and then in either direction.
    Fan FanAt(Index v, Index e, Room<Index>& room) const {
        const auto ends = level_.EdgeVertices(e);
        const auto known = RingFrom(v, ends[0] + ends[1] - v);
        return known.empty() ? walk_.FanAt(v, e, room) : Fan{true, known};
    }

  private:
    static constexpr Offset kGrain = 4096;

    std::uint32_t SumOfThirds(Index e) const {
        if (walk_.EndsSurface(e)) return kNothing;
        const SurfaceWalk::Faces faces = walk_.FacesAt(e);
        return static_cast<std::uint32_t>(level_.ThirdVertex(faces.first, e)) +
               static_cast<std::uint32_t>(level_.ThirdVertex(faces.second, e));
    }

    /// Finds the rings of vertices inside surfaces that are not regular.
    void FindRings() {
        is_regular_.resize(static_cast<std::size_t>(level_.n_vertices));
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
            for (Index e : level_.vertex_edges[v]) ring_offsets_[v] += 2 * (sums_[e] != kNothing);
        });
        rings_.resize(static_cast<std::size_t>(Sdc::ScanLengths(ring_offsets_)));
        for_vertices([&](Index v) {
            const std::size_t twice = static_cast<std::size_t>(ring_offsets_[v + 1] - ring_offsets_[v]);
            if (twice == 0) return;
            const std::span<Index> ring(rings_.data() + ring_offsets_[v], twice / 2);
            if (!FindRing(v, ring)) ring[0] = kNoIndex;
            std::copy(ring.begin(), ring.end(), ring.data() + ring.size());  // so that it can be read from any vertex
        });
    }

    /// Orders the neighbours of v: of the two that lie across the edge to one, the next is the one that was not the
    /// last. False if they are no single ring.
    bool FindRing(Index v, std::span<Index> ring) const {
        Room<Index> neighbor_room;
        Room<std::uint32_t> sum_room;
        Index* const neighbors = neighbor_room.For(ring.size());
        std::uint32_t* const sums = sum_room.For(ring.size());
        Index next = kNoIndex;
        std::size_t n = 0;
        for (Index e : level_.vertex_edges[v]) {
            if (sums_[e] == kNothing) continue;
            if (n == 0) next = level_.ThirdVertex(walk_.FacesAt(e).first, e);
            const auto ends = level_.EdgeVertices(e);
            neighbors[n] = ends[0] + ends[1] - v;
            sums[n++] = sums_[e];
        }
        ring[0] = neighbors[0];
        for (std::size_t i = 1; i < n; ++i) {
            std::size_t at = 1;
            while (at < n && neighbors[at] != next) ++at;
            if (at == n) return false;
            ring[i] = next;
            next = static_cast<Index>(sums[at] - static_cast<std::uint32_t>(ring[i - 1]));
        }
        return next == ring[0];
    }

    const Level& level_;
    const SurfaceWalk& walk_;
    Array<std::uint32_t> sums_;
    Array<std::uint8_t> is_regular_;  // of each vertex
    Array<Offset> ring_offsets_;      // of each vertex: its ring in rings_, twice, if it is inside and not regular
    Array<Index> rings_;
};

}  // namespace SolidSubdiv::Far::Internal
