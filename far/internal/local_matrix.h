// SPDX-License-Identifier: Apache-2.0
// The local matrix of a vertex from its own row and those of its edges and octahedra.
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include <solidsubdiv/far/internal/row_buffer.h>
#include <solidsubdiv/far/internal/rows.h>
#include <solidsubdiv/far/local_matrix.h>

namespace SolidSubdiv::Far::Internal {

/// None where rows reach beyond the vertex and its neighbours.
template <class Scheme>
std::optional<LocalMatrix> MakeLocalMatrix(const Level& level, const Rows<Scheme>& rows, Index vertex) {
    LocalMatrix m;
    RowBuffer<double> row;
    row.Read(rows, rows.ChildOfVertex(vertex));
    m.ring.assign(row.Indices().begin(), row.Indices().end());
    const std::size_t n = m.ring.size();
    m.weights.assign(n * n, 0.0);
    bool closed = true;

    const auto place = [&](Index v) {
        return static_cast<std::size_t>(std::find(m.ring.begin(), m.ring.end(), v) - m.ring.begin());
    };
    std::vector<bool> has_row(n, false);
    const auto set_row = [&](std::size_t i) {
        for (std::size_t k = 0; k < row.n; ++k) {
            const std::size_t column = place(row.indices[k]);
            if (column == n) {
                closed = false;
            } else {
                m.weights[i * n + column] += row.weights[k];
            }
        }
        has_row[i] = true;
    };
    set_row(0);

    for (Index e : level.vertex_edges[vertex]) {
        const auto ends = level.EdgeVertices(e);
        const std::size_t i = place(ends[0] + ends[1] - vertex);
        if (i == n) continue;  // an edge that the rule at the vertex does not see
        row.Read(rows, rows.ChildOfEdge(e));
        set_row(i);
    }
    // What is left are vertices opposite in octahedra; their successors are the centres.
    const auto octs = level.vertex_octs[vertex];
    const auto locals = level.vertex_octs.Locals(vertex);
    for (std::size_t k = 0; k < octs.size(); ++k) {
        const std::size_t i = place(level.OctVertices(octs[k])[Sdc::Oct::Opposite(locals[k])]);
        if (i == n || has_row[i]) continue;
        row.Read(rows, rows.ChildOfOct(octs[k]));
        set_row(i);
    }
    if (!closed || std::find(has_row.begin(), has_row.end(), false) != has_row.end()) return std::nullopt;
    return m;
}

}  // namespace SolidSubdiv::Far::Internal
