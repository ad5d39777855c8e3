// SPDX-License-Identifier: Apache-2.0
// Items put into the rows that they belong to, by counting: count, scan, fill.
//
// Each thread visits all items in their order and handles the rows of its own range: visiting in sequence costs little
// beside the scattered writes, and there is nothing to share, no atomic counter, and rows keep the items' order.
#pragma once

#include <algorithm>

#include <solidsubdiv/sdc/parallel.h>
#include <solidsubdiv/sdc/types.h>

namespace SolidSubdiv::Vtr {

/// Calls body(first, last) for one range of rows a thread; together they cover [0, n_rows).
template <class Body>
void ForRowRanges(Index n_rows, Body&& body) {
    const Offset n_ranges = Sdc::ThreadCount();
    Sdc::ParallelFor(n_ranges, 1, [&](Offset begin, Offset end) {
        for (Offset range = begin; range < end; ++range) {
            body(static_cast<Index>(n_rows * range / n_ranges), static_cast<Index>(n_rows * (range + 1) / n_ranges));
        }
    });
}

/// Where each of n_rows rows starts, and the end of the last: visit(add) calls add(row, ...) for each item.
template <class Visit>
Array<Offset> CountRows(Index n_rows, Visit&& visit) {
    Array<Offset> offsets(static_cast<std::size_t>(n_rows) + 1);
    Offset* const counts = offsets.data();
    ForRowRanges(n_rows, [&](Index first, Index last) {
        std::fill(counts + first, counts + last, Offset{0});
        visit([&](Index row, const auto&...) {
            if (row >= first && row < last) ++counts[row];
        });
    });
    Sdc::ScanLengths(offsets);
    return offsets;
}

/// Calls put(place, item...) for each add(row, item...) that visit(add) calls, a place after the other in each row.
/// @param offsets as of CountRows; the same afterwards
template <class Visit, class Put>
void FillRows(Array<Offset>& offsets, Visit&& visit, Put&& put) {
    Offset* const next = offsets.data();
    ForRowRanges(static_cast<Index>(offsets.size() - 1), [&](Index first, Index last) {
        visit([&](Index row, const auto&... item) {
            if (row >= first && row < last) put(next[row]++, item...);
        });
    });
    // Each row's start moved to its end: starts are the ends of the rows before.
    std::shift_right(offsets.begin(), offsets.end(), 1);
    offsets[0] = 0;
}

}  // namespace SolidSubdiv::Vtr
