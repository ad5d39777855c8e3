// SPDX-License-Identifier: Apache-2.0
// Products of rows, from children to parents.
#include <solidsubdiv/far/internal/limit_state.h>

#include <cassert>

namespace SolidSubdiv::Far::Internal {

LimitState::LimitState(const Pocket& p)
    : root(p.root),
      n_root_vertices(p.n_root_vertices),
      n_vertices(p.n_vertices()),
      pocket(p),
      corner_flags(std::make_unique<std::once_flag[]>(static_cast<std::size_t>(p.n_root_vertices))),
      corners(static_cast<std::size_t>(p.n_root_vertices)) {
    if (root == RootKind::Polyhedron) {
        for (Index f = 0; f < static_cast<Index>(p.cell_offsets[1]); ++f) root_faces.Add(p.cell_faces[f]);
    } else if (root == RootKind::Face && !p.is_tet_oct && n_root_vertices != 4) {
        root_faces.Add(p.faces[0]);
    }
}

namespace {

template <int kColumns>
bool PullColumns(const RowsOfChildren& table, const Transition& t, const LimitBlock& child, LimitBlock& parent) {
    const double* from = child.weights.data();
    for (const Index row : t.rows) {
        bool is_zero = true;
        for (int c = 0; c < kColumns; ++c) is_zero = is_zero && from[c] == 0;
        if (!is_zero) {
            if (row == kNoIndex) return false;
            for (std::uint32_t k = table.offsets[row]; k < table.offsets[row + 1]; ++k) {
                double* to = parent.weights.data() + kColumns * static_cast<std::size_t>(table.indices[k]);
                for (int c = 0; c < kColumns; ++c) to[c] += table.weights[k] * from[c];
            }
        }
        from += kColumns;
    }
    return true;
}

}  // namespace

bool Pull(const LimitState& state, const Transition& t, const LimitBlock& child, LimitBlock& parent) {
    parent.Reset(state.n_vertices, child.n_columns);
    switch (child.n_columns) {
        case 1:
            return PullColumns<1>(state.rows, t, child, parent);
        case 2:
            return PullColumns<2>(state.rows, t, child, parent);
        case 3:
            return PullColumns<3>(state.rows, t, child, parent);
        case 4:
            return PullColumns<4>(state.rows, t, child, parent);
        case 6:
            return PullColumns<6>(state.rows, t, child, parent);
        default:
            assert(child.n_columns == 10);
            return PullColumns<10>(state.rows, t, child, parent);
    }
}

void ChangeRows(const Matrix3& by, int dimension, int order, LimitBlock& block) {
    if (order == 0) return;
    const std::size_t n = block.weights.size() / static_cast<std::size_t>(block.n_columns);
    for (std::size_t p = 0; p < n; ++p) {
        ChangeCoordinates(by, dimension, order, 1,
                          block.weights.data() + p * static_cast<std::size_t>(block.n_columns));
    }
}

}  // namespace SolidSubdiv::Far::Internal
