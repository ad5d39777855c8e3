// SPDX-License-Identifier: Apache-2.0
// How the faces of one polyhedron hang together.
#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include <solidsubdiv/sdc/types.h>

namespace SolidSubdiv::Vtr::Internal {

/// Corners, edges and rings of a cell, found from its faces. All numbers but vertices are places in the cell's lists.
struct CellRings {
    std::vector<Index> vertices;                ///< in order of first mention
    std::vector<std::array<Index, 2>> edges;    ///< ends as corners, in order of first mention
    std::vector<Index> ring_offsets;            ///< (vertices + 1)
    std::vector<Index> ring_edges, ring_faces;  ///< around each corner, counterclockwise from outside

    /// False if the faces are not those of a cell: three at least, each edge in two of them, which pass it in opposite
    /// directions, and all faces at a corner in one ring. @param face(f) the vertices of face f, counterclockwise from
    /// outside
    template <class Face>
    bool Find(Index n_faces, Face&& face) {
        if (n_faces < 3) return false;
        vertices.clear();
        edges.clear();
        sides_.clear();
        passes_.clear();
        for (Index f = 0; f < n_faces; ++f) {
            const std::span<const Index> v = face(f);
            const Index start = static_cast<Index>(passes_.size()), n = static_cast<Index>(v.size());
            const Index first = CornerOf(v[0]);
            for (Index k = 0, a = first; k < n; ++k) {
                const Index b = k + 1 < n ? CornerOf(v[static_cast<std::size_t>(k) + 1]) : first;
                const Index e = EdgeOf(a, b);  // twice from a to b: two edges, of which one stays without a side
                Index& side = sides_[e][edges[e][0] == a ? 0 : 1];
                if (side != kNoIndex) return false;
                side = start + k;
                passes_.push_back({e, f, start + (k > 0 ? k : n) - 1});
                a = b;
            }
        }
        for (const auto& side : sides_) {
            if (side[0] == kNoIndex || side[1] == kNoIndex) return false;
        }
        return FindRings();
    }
    /// One of the two faces at an edge.
    Index FaceAt(Index edge) const { return passes_[sides_[edge][0]].face; }

  private:
    /// A face goes along an edge, counterclockwise.
    struct Pass {
        Index edge, face;
        Index before;  ///< the face's pass that ends where this one starts
    };

    Index CornerOf(Index vertex) {
        const auto at = std::find(vertices.begin(), vertices.end(), vertex) - vertices.begin();
        if (at == static_cast<std::ptrdiff_t>(vertices.size())) vertices.push_back(vertex);
        return static_cast<Index>(at);
    }
    /// The edge that a face passed from b to a, or a new one.
    Index EdgeOf(Index a, Index b) {
        const auto is_it = [&](const auto& ends) { return ends[0] == b && ends[1] == a; };
        const auto at = std::find_if(edges.begin(), edges.end(), is_it) - edges.begin();
        if (at == static_cast<std::ptrdiff_t>(edges.size())) {
            edges.push_back({a, b});
            sides_.push_back({kNoIndex, kNoIndex});
        }
        return static_cast<Index>(at);
    }

    /// A face on the left of an edge that leaves a corner comes next; the edge on which it comes back leaves after it.
    bool FindRings() {
        degrees_.assign(vertices.size(), 0);
        first_edges_.assign(vertices.size(), kNoIndex);
        for (std::size_t e = 0; e < edges.size(); ++e) {
            for (Index corner : edges[e]) {
                if (degrees_[corner]++ == 0) first_edges_[corner] = static_cast<Index>(e);
            }
        }
        ring_offsets.assign(1, 0);
        ring_edges.clear();
        ring_faces.clear();
        for (Index corner = 0; corner < static_cast<Index>(vertices.size()); ++corner) {
            Index e = first_edges_[corner];
            do {
                const Pass& pass = passes_[sides_[e][edges[e][0] == corner ? 0 : 1]];
                ring_edges.push_back(e);
                ring_faces.push_back(pass.face);
                e = passes_[pass.before].edge;
            } while (e != first_edges_[corner]);
            ring_offsets.push_back(static_cast<Index>(ring_edges.size()));
            if (ring_offsets.back() - ring_offsets[corner] != degrees_[corner]) return false;
        }
        return true;
    }

    std::vector<Pass> passes_;                  // of all faces, one after another
    std::vector<std::array<Index, 2>> sides_;   // of each edge: the pass from its first end, from its second
    std::vector<Index> degrees_, first_edges_;  // of each corner
};

}  // namespace SolidSubdiv::Vtr::Internal
