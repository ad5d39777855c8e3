// SPDX-License-Identifier: Apache-2.0
// Centroids of the cells and faces that the linear split makes at a corner, as sums over the parent's vertices and
// centroids (a Row is that of centroid_rules.h).
//
// The new cell at a corner of n edges has 2n + 2 corners: the vertex, the middles of the edges, the centroids of the
// faces between them and of the cell. Source: Bajaj, Schaefer, Warren, Xu 2002 (bajaj2002).
#pragma once

#include <algorithm>
#include <array>

#include <solidsubdiv/vtr/polyhedral_level.h>

namespace SolidSubdiv::Far::Internal {

/// Adds weight times the centroid of the new face at corner k of face f.
template <class Row>
void AddNewFace(const Vtr::PolyhedralLevel& level, Index f, std::size_t k, double weight, Row& row) {
    const auto v = level.FaceVertices(f);
    const std::size_t n = v.size();
    row.Add(v[k], weight / 2);
    row.Add(v[(k + 1) % n], weight / 8);
    row.Add(v[(k + n - 1) % n], weight / 8);
    row.AddFace(f, weight / 4);
}

/// The same of the new cell at vertex v of cell c.
template <class Row>
void AddNewCell(const Vtr::PolyhedralLevel& level, Index c, Index v, double weight, Row& row) {
    const auto vertices = level.CellVertices(c);
    const std::ptrdiff_t corner = std::find(vertices.begin(), vertices.end(), v) - vertices.begin();
    if (level.IsHex(c)) {
        // (3/4, 1/4) along each of three axes.
        constexpr std::array<double, 4> kByDistance{27.0 / 64, 9.0 / 64, 3.0 / 64, 1.0 / 64};
        for (int i = 0; i < Sdc::Hex::kVertices; ++i) {
            row.Add(vertices[static_cast<std::size_t>(i)],
                    weight * kByDistance[Sdc::Hex::Distance(static_cast<int>(corner), i)]);
        }
        return;
    }
    const Vtr::Polyhedra& p = level.polyhedra;
    const auto edges = level.CellEdges(c);
    const auto faces = level.CellFaces(c);
    const Offset at = p.vertex_offsets[c - level.n_hexes] + corner, end = p.ring_offsets[at + 1];
    const double share = weight / static_cast<double>(2 * (end - p.ring_offsets[at]) + 2);
    row.Add(v, share);
    for (Offset k = p.ring_offsets[at]; k < end; ++k) {
        for (Index near : level.EdgeVertices(edges[static_cast<std::size_t>(p.ring_edges[k])])) {
            row.Add(near, share / 2);
        }
        row.AddFace(faces[static_cast<std::size_t>(p.ring_faces[k])], share);
    }
    row.AddCell(c, share);
}

}  // namespace SolidSubdiv::Far::Internal
