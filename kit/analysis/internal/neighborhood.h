// SPDX-License-Identifier: Apache-2.0
// Which point of the next level corresponds to which of this one, around a vertex where levels look alike.
//
// Piecewise (multi)linear refinement halves the star of a vertex. So every point gets a place, as linear refinement
// would put it, and the successor of a point is the one at half its place.
#pragma once

#include <cstdint>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include <solidsubdiv/far/local_matrix.h>
#include <solidsubdiv/far/stencil_table.h>

namespace SolidSubdiv::Analysis::Internal {

class Neighborhood {
  public:
    /// Around `vertex` of `level`, between ring_level >= level and the level after it, which the refiner must have.
    /// @param is_on_edge vertices 1 and 2 are next to vertex 0 on an edge along which nothing changes
    Neighborhood(const Far::TopologyRefiner& refiner, int level, Index vertex, int ring_level, bool is_on_edge = false);

    /// The point of ring_level + 1 that corresponds to v of ring_level; kNoIndex: outside the star.
    Index Successor(Index v) const;

    /// The smallest set of points of ring_level that holds those of `start` (each once, in their order) and that the
    /// rows of their successors do not leave. @param rows of ring_level + 1. None: they leave the star.
    std::optional<Far::LocalMatrix> Close(std::vector<Index> start, const Far::StencilRows<double>& rows) const;

    /// Places in a list of points of ring_level of those that lie one step along the edge from each other.
    /// @pre is_on_edge
    std::vector<std::pair<std::size_t, std::size_t>> StepsAlong(const std::vector<Index>& points) const;

  private:
    std::vector<std::uint64_t> places_;  // of ring_level
    std::uint64_t step_ = 0;             // along the edge
    std::unordered_map<std::uint64_t, Index> point_at_;
};

/// The vertex and all that shares an edge, or among polyhedra a cell or face, with it.
std::vector<Index> RingOf(const Far::TopologyRefiner& refiner, int level, Index vertex);

}  // namespace SolidSubdiv::Analysis::Internal
