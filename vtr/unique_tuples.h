// SPDX-License-Identifier: Apache-2.0
// Numbers distinct tuples of vertices in lexicographic order: rows by lowest vertex, each sorted for itself.
#pragma once

#include <algorithm>
#include <array>
#include <span>

#include <solidsubdiv/sdc/parallel.h>
#include <solidsubdiv/sdc/types.h>
#include <solidsubdiv/vtr/grouping.h>

namespace SolidSubdiv::Vtr {

/// Sorts few numbers, without branches.
template <std::size_t N>
void SortFew(std::array<Index, N>& numbers) {
    for (std::size_t i = 1; i < N; ++i) {
        for (std::size_t k = i; k > 0; --k) {
            const auto [low, high] = std::minmax({numbers[k - 1], numbers[k]});
            numbers[k - 1] = low;
            numbers[k] = high;
        }
    }
}

template <std::size_t N>
struct UniqueTuples {
    Array<Index> tuples;  ///< (size(), N), ascending within a tuple, tuples in lexicographic order
    Array<Index> ids;     ///< which tuple each item is

    Index size() const { return static_cast<Index>(tuples.size() / N); }

    /// tuple_of(i) gives item i's vertices in any order. @pre n_items fits Index
    template <class TupleOf>
    UniqueTuples(Index n_vertices, Offset n_items, TupleOf&& tuple_of) {
        constexpr Offset kGrain = 4096;
        Array<std::array<Index, N>> keys(n_items);
        Sdc::ParallelFor(n_items, kGrain, [&](Offset begin, Offset end) {
            for (Offset i = begin; i < end; ++i) {
                keys[i] = tuple_of(i);
                SortFew(keys[i]);
            }
        });

        // Within a row the lowest vertices are the same: the others and the item are kept side by side and sorted.
        using Entry = std::array<Index, N>;
        const auto visit = [&](auto&& add) {
            for (Offset i = 0; i < n_items; ++i) add(keys[i][0], i);
        };
        Array<Offset> offsets = CountRows(n_vertices, visit);
        Array<Entry> entries(n_items);
        FillRows(offsets, visit, [&](Offset place, Offset i) {
            std::copy(keys[i].begin() + 1, keys[i].end(), entries[place].begin());
            entries[place][N - 1] = static_cast<Index>(i);
        });
        const auto row = [&](Offset v) {
            return std::span(entries.data() + offsets[v], static_cast<std::size_t>(offsets[v + 1] - offsets[v]));
        };
        const auto is_new = [](std::span<const Entry> entries_of_row, std::size_t k) {
            if (k == 0) return true;
            const Entry &mine = entries_of_row[k], &last = entries_of_row[k - 1];
            bool same = true;
            for (std::size_t c = 0; c + 1 < N; ++c) same &= mine[c] == last[c];
            return !same;
        };
        Array<Offset> first(static_cast<std::size_t>(n_vertices) + 1);
        Sdc::ParallelFor(n_vertices, kGrain / 16, [&](Offset begin, Offset end) {
            for (Offset v = begin; v < end; ++v) {
                const auto mine = row(v);
                std::sort(mine.begin(), mine.end());
                first[v] = 0;
                for (std::size_t k = 0; k < mine.size(); ++k) first[v] += is_new(mine, k);
            }
        });
        tuples.resize(N * static_cast<std::size_t>(Sdc::ScanLengths(first)));
        ids.resize(n_items);
        Sdc::ParallelFor(n_vertices, kGrain / 16, [&](Offset begin, Offset end) {
            for (Offset v = begin; v < end; ++v) {
                const auto mine = row(v);
                Index id = static_cast<Index>(first[v]) - 1;
                for (std::size_t k = 0; k < mine.size(); ++k) {
                    if (is_new(mine, k)) {
                        Index* const tuple = tuples.data() + N * static_cast<std::size_t>(++id);
                        tuple[0] = static_cast<Index>(v);
                        std::copy(mine[k].begin(), mine[k].end() - 1, tuple + 1);
                    }
                    ids[mine[k][N - 1]] = id;
                }
            }
        });
    }
};

}  // namespace SolidSubdiv::Vtr
