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
        for (Index f = 0; f < n_faces; ++f) {
            const std::span<const Index> v = face(f);
            for (std::size_t k = 0; k < v.size(); ++k) {
                const Index a = CornerOf(v[k]), b = CornerOf(v[k + 1 < v.size() ? k + 1 : 0]);
                std::size_t e = 0;
                while (e < edges.size() && edges[e] != std::array{a, b} && edges[e] != std::array{b, a}) ++e;
                if (e == edges.size()) {
                    edges.push_back({a, b});
                    sides_.push_back({kNoIndex, kNoIndex});
                }
                Index& side = sides_[e][edges[e][0] == a ? 0 : 1];
                if (side != kNoIndex) return false;
                side = f;
            }
        }
        for (const auto& side : sides_) {
            if (side[0] == kNoIndex || side[1] == kNoIndex) return false;
        }
        return FindRings();
    }

  private:
    Index CornerOf(Index vertex) {
        const auto at = std::find(vertices.begin(), vertices.end(), vertex) - vertices.begin();
        if (at == static_cast<std::ptrdiff_t>(vertices.size())) vertices.push_back(vertex);
        return static_cast<Index>(at);
    }

    /// A face on the left of an edge that leaves a corner comes next; the edge on which it comes back leaves after it.
    bool FindRings() {
        ring_offsets.assign(1, 0);
        ring_edges.clear();
        ring_faces.clear();
        for (Index corner = 0; corner < static_cast<Index>(vertices.size()); ++corner) {
            const auto starts_here = [&](const auto& e) { return e[0] == corner || e[1] == corner; };
            const auto n = std::count_if(edges.begin(), edges.end(), starts_here);
            const Index first =
                static_cast<Index>(std::find_if(edges.begin(), edges.end(), starts_here) - edges.begin());
            Index e = first;
            do {
                ring_edges.push_back(e);
                ring_faces.push_back(sides_[e][edges[e][0] == corner ? 0 : 1]);
                e = ComesBack(corner, ring_faces.back());
            } while (e != first && static_cast<std::ptrdiff_t>(ring_edges.size()) - ring_offsets.back() <= n);
            if (static_cast<std::ptrdiff_t>(ring_edges.size()) - ring_offsets.back() != n) return false;
            ring_offsets.push_back(static_cast<Index>(ring_edges.size()));
        }
        return true;
    }
    /// The edge on which a face comes back to a corner: it has the corner and the face on its right as it leaves.
    Index ComesBack(Index corner, Index f) const {
        for (std::size_t e = 0; e < edges.size(); ++e) {
            if ((edges[e][0] == corner && sides_[e][1] == f) || (edges[e][1] == corner && sides_[e][0] == f)) {
                return static_cast<Index>(e);
            }
        }
        return kNoIndex;
    }

    std::vector<std::array<Index, 2>> sides_;  // of each edge: the face on the left, on the right from its first end
};

}  // namespace SolidSubdiv::Vtr::Internal
