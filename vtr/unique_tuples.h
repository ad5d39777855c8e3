// SPDX-License-Identifier: Apache-2.0
// Numbers distinct tuples of vertices in lexicographic order: rows by lowest vertex, each sorted for itself.
#pragma once

#include <algorithm>
#include <array>

#include <solidsubdiv/sdc/parallel.h>
#include <solidsubdiv/sdc/types.h>
#include <solidsubdiv/vtr/relation.h>

namespace SolidSubdiv::Vtr {

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
        Array<Index> lowest(n_items);
        Sdc::ParallelFor(n_items, kGrain, [&](Offset begin, Offset end) {
            for (Offset i = begin; i < end; ++i) {
                keys[i] = tuple_of(i);
                std::sort(keys[i].begin(), keys[i].end());
                lowest[i] = keys[i][0];
            }
        });

        Relation rows = Invert(lowest, 1, n_vertices, false);
        // Within a row the lowest vertices are the same.
        const auto less = [&](Index i, Index j) {
            for (std::size_t k = 1; k < N; ++k) {
                if (keys[i][k] != keys[j][k]) return keys[i][k] < keys[j][k];
            }
            return i < j;
        };
        const auto differ = [&](Index i, Index j) {
            bool same = true;
            for (std::size_t k = 1; k < N; ++k) same &= keys[i][k] == keys[j][k];
            return !same;
        };
        Array<Offset> first(static_cast<std::size_t>(n_vertices) + 1);
        Sdc::ParallelFor(n_vertices, kGrain / 16, [&](Offset begin, Offset end) {
            for (Offset v = begin; v < end; ++v) {
                Index* row = rows.items.data() + rows.Start(static_cast<Index>(v));
                const int n = rows.Count(static_cast<Index>(v));
                std::sort(row, row + n, less);
                Offset distinct = 0;
                for (int k = 0; k < n; ++k) distinct += k == 0 || differ(row[k], row[k - 1]);
                first[v] = distinct;
            }
        });
        tuples.resize(N * static_cast<std::size_t>(Sdc::ScanLengths(first)));
        ids.resize(n_items);
        Sdc::ParallelFor(n_vertices, kGrain / 16, [&](Offset begin, Offset end) {
            for (Offset v = begin; v < end; ++v) {
                const auto row = rows[static_cast<Index>(v)];
                Index id = static_cast<Index>(first[v]) - 1;
                for (std::size_t k = 0; k < row.size(); ++k) {
                    if (k == 0 || differ(row[k], row[k - 1])) {
                        ++id;
                        std::copy(keys[row[k]].begin(), keys[row[k]].end(),
                                  tuples.begin() + N * static_cast<std::ptrdiff_t>(id));
                    }
                    ids[row[k]] = id;
                }
            }
        });
    }
};

}  // namespace SolidSubdiv::Vtr
