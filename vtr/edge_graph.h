// SPDX-License-Identifier: Apache-2.0
// The vertices and edges of a level, whatever its cells are: what creases need to know.
#pragma once

#include <span>

#include <solidsubdiv/vtr/relation.h>
#include <solidsubdiv/vtr/tags.h>

namespace SolidSubdiv::Vtr {

/// A view of a full level, which outlives it.
class EdgeGraph {
  public:
    template <class AnyLevel>
    explicit EdgeGraph(const AnyLevel& level)
        : n_vertices(level.n_vertices),
          n_edges(level.n_edges),
          vertex_edges(level.vertex_edges),
          edge_faces(level.edge_faces),
          vertex_tags(level.vertex_tags),
          edge_tags(level.edge_tags),
          edge_vertices_(level.edge_vertices) {}

    Index n_vertices, n_edges;
    const Relation& vertex_edges;
    const Relation& edge_faces;
    const Array<Tag>& vertex_tags;
    const Array<Tag>& edge_tags;

    std::span<const Index, 2> EdgeVertices(Index e) const {
        return std::span<const Index, 2>(edge_vertices_.data() + 2 * static_cast<std::size_t>(e), 2);
    }
    /// The edge from a to b, or kNoIndex. Cost: a walk over the edges of a.
    Index FindEdge(Index a, Index b) const {
        for (Index e : vertex_edges[a]) {
            const auto ends = EdgeVertices(e);
            if (ends[ends[0] == a ? 1 : 0] == b) return e;
        }
        return kNoIndex;
    }

  private:
    const Array<Index>& edge_vertices_;
};

}  // namespace SolidSubdiv::Vtr
