// SPDX-License-Identifier: Apache-2.0
// The columns that rows have: what is kept of many, where few are read.
#pragma once

#include <algorithm>
#include <initializer_list>
#include <numeric>
#include <vector>

#include <solidsubdiv/sdc/types.h>

namespace SolidSubdiv::Deform::Internal {

class UsedColumns {
  public:
    UsedColumns() = default;
    /// The columns, of 0 to n - 1, in these lists, which are renumbered to count among them. Where the lists are as
    /// long as there are columns, all are kept: so cost and memory are those of the lists, whatever n is.
    UsedColumns(Index n, std::initializer_list<Array<Index>*> lists) {
        std::size_t length = 0;
        for (const auto* list : lists) length += list->size();
        if (length >= static_cast<std::size_t>(n)) {
            columns_.resize(static_cast<std::size_t>(n));
            std::iota(columns_.begin(), columns_.end(), 0);
            return;
        }
        for (const auto* list : lists) columns_.insert(columns_.end(), list->begin(), list->end());
        std::sort(columns_.begin(), columns_.end());
        columns_.erase(std::unique(columns_.begin(), columns_.end()), columns_.end());
        for (auto* list : lists) {
            for (Index& i : *list) i = PlaceOf(i);
        }
    }

    Index size() const { return static_cast<Index>(columns_.size()); }
    Index operator[](Index place) const { return columns_[static_cast<std::size_t>(place)]; }
    /// The place of a column among those kept, or kNoIndex.
    Index PlaceOf(Index column) const {
        const auto it = std::lower_bound(columns_.begin(), columns_.end(), column);
        return it != columns_.end() && *it == column ? static_cast<Index>(it - columns_.begin()) : kNoIndex;
    }

  private:
    std::vector<Index> columns_;  // ascending
};

/// The control points that something reads, which is renumbered to count among them. `tables`: as EmbeddingTables.
template <class Tables>
UsedColumns KeepUsedControlPoints(Tables& tables) {
    const bool has_cascade = !tables.cascade.empty();
    UsedColumns used = has_cascade ? UsedColumns(tables.n_control_points, {&tables.cascade[0].indices})
                                   : UsedColumns(tables.n_control_points,
                                                 {&tables.hexes.corners, &tables.tets.corners, &tables.rows.indices});
    (has_cascade ? tables.cascade[0] : tables.rows).n_sources = used.size();
    return used;
}

}  // namespace SolidSubdiv::Deform::Internal
