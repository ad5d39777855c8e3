// SPDX-License-Identifier: Apache-2.0
// Sparse rows, those with the same weights together: a level of refined hexahedra has thousands of rows, but some
// twenty lists of weights.
//
// Each list is kept once, and a row of a group is its indices only. No branch depends on a row, and rows are summed
// four at a time with each weight read once. Rows whose lists are rare (most, in lattices of tets) follow as they were.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include <solidsubdiv/far/stencil_table.h>

namespace SolidSubdiv::Deform::Internal {

template <class Real>
class GroupedRows {
  public:
    /// Rows are numbered anew. `numbers`: those of the sources, which become those of the rows; empty: as they stand.
    GroupedRows(const Far::StencilRows<double>& rows, std::vector<Index>& numbers);

    Index n_sources() const { return rest_.n_sources; }
    Index n_rows() const { return n_grouped_ + rest_.n_rows(); }
    Offset Bytes() const;

    /// All rows, (n_rows, 4), from all sources, (n_sources, 4). Parallel; the bits of Osd's backends.
    void Eval(const Array<Real>& source, Array<Real>& destination) const;

    /// Calls visit(source, weight) for the terms of a row, in their order.
    template <class Visit>
    void ForEachTerm(Index row, Visit&& visit) const {
        if (row >= n_grouped_) {
            const auto indices = rest_.Indices(row - n_grouped_);
            const auto weights = rest_.Weights(row - n_grouped_);
            for (std::size_t k = 0; k < indices.size(); ++k) visit(indices[k], weights[k]);
            return;
        }
        const Group& group = *GroupOf(row);
        const Offset first = group.first_index + Offset{row - group.begin} * group.length;
        const Real* const weights = weights_.data() + group.first_weight;
        for (Index k = 0; k < group.length; ++k) {
            visit(short_indices_.empty() ? indices_[first + k] : Index{short_indices_[first + k]}, weights[k]);
        }
    }

  private:
    struct Group {
        Index begin = 0, end = 0;  ///< rows
        Offset first_index = 0;
        Index first_weight = 0, length = 0;
    };

    typename std::vector<Group>::const_iterator GroupOf(Index row) const {
        return std::upper_bound(groups_.begin(), groups_.end(), row,
                                [](Index r, const Group& group) { return r < group.end; });
    }

    std::vector<Group> groups_;
    Index n_grouped_ = 0;                 ///< rows
    Array<Index> indices_;                ///< of rows in groups; or
    Array<std::uint16_t> short_indices_;  ///< the same, where all sources have numbers so short
    Array<Real> weights_;                 ///< of groups
    Far::StencilRows<Real> rest_;
};

extern template class GroupedRows<double>;
extern template class GroupedRows<float>;

}  // namespace SolidSubdiv::Deform::Internal
