// SPDX-License-Identifier: Apache-2.0
// Numbers faces: lists with the same vertices are one, faces in lexicographic order of their ascending vertices.
#pragma once

#include <algorithm>
#include <array>
#include <compare>
#include <vector>

#include <solidsubdiv/sdc/parallel.h>
#include <solidsubdiv/vtr/grouping.h>
#include <solidsubdiv/vtr/internal/face_items.h>
#include <solidsubdiv/vtr/unique_tuples.h>

namespace SolidSubdiv::Vtr::Internal {

struct UniqueFaces {
    Array<Index> face_of_item;
    Array<Offset> starts{0};  ///< (size() + 1): of each face, its items among `items`
    Array<Index> items;       ///< ascending within a face

    Index size() const { return static_cast<Index>(starts.size()) - 1; }

    UniqueFaces(const FaceItems& lists, Index n_vertices) {
        constexpr Offset kGrain = 1024;
        const Offset n = lists.size();
        // The lowest four vertices order all faces but large ones; of shorter lists the last is none.
        Array<std::array<Index, 4>> keys(static_cast<std::size_t>(n));
        Sdc::ParallelFor(n, kGrain, [&](Offset begin, Offset end) {
            std::vector<Index> list;
            for (Offset i = begin; i < end; ++i) {
                lists.Copy(i, list);
                if (list.size() == 4) {
                    std::copy(list.begin(), list.end(), keys[i].begin());
                    SortFew(keys[i]);
                } else {
                    const auto end_of_list =
                        std::partial_sort_copy(list.begin(), list.end(), keys[i].begin(), keys[i].end());
                    std::fill(end_of_list, keys[i].end(), kNoIndex);
                }
            }
        });
        const auto visit = [&](auto&& add) {
            for (Offset i = 0; i < n; ++i) add(keys[i][0], i);
        };
        // Rows by lowest vertex: the vertices after it and the item are kept side by side and sorted.
        using Entry = std::array<Index, 4>;
        Array<Offset> rows = CountRows(n_vertices, visit);
        Array<Entry> entries(static_cast<std::size_t>(n));
        FillRows(rows, visit, [&](Offset place, Offset i) {
            entries[place] = {keys[i][1], keys[i][2], keys[i][3], static_cast<Index>(i)};
        });
        const auto compare = [&](const Entry& a, const Entry& b) -> std::strong_ordering {
            for (std::size_t k = 0; k < 3; ++k) {
                if (a[k] != b[k]) return a[k] <=> b[k];
            }
            return CompareLarge(lists, a[3], b[3]);
        };
        Array<Offset> first(static_cast<std::size_t>(n_vertices) + 1);
        const auto is_new = [&](Offset v, Offset place) {
            return place == rows[v] || compare(entries[place], entries[place - 1]) != 0;
        };
        Sdc::ParallelFor(n_vertices, kGrain / 4, [&](Offset begin, Offset end) {
            for (Offset v = begin; v < end; ++v) {
                std::sort(entries.begin() + rows[v], entries.begin() + rows[v + 1],
                          [&](const Entry& a, const Entry& b) {
                              const auto order = compare(a, b);
                              return order != 0 ? order < 0 : a[3] < b[3];
                          });
                first[v] = 0;
                for (Offset place = rows[v]; place < rows[v + 1]; ++place) first[v] += is_new(v, place);
            }
        });
        const Offset n_faces = Sdc::ScanLengths(first);
        face_of_item.resize(static_cast<std::size_t>(n));
        items.resize(static_cast<std::size_t>(n));
        starts.resize(static_cast<std::size_t>(n_faces) + 1);
        Sdc::ParallelFor(n_vertices, kGrain / 4, [&](Offset begin, Offset end) {
            for (Offset v = begin; v < end; ++v) {
                Offset face = first[v] - 1;
                for (Offset place = rows[v]; place < rows[v + 1]; ++place) {
                    if (is_new(v, place)) starts[++face] = place;
                    const Index item = entries[place][3];
                    items[place] = item;
                    face_of_item[item] = static_cast<Index>(face);
                }
            }
        });
        starts[n_faces] = n;
    }

  private:
    /// Of two lists whose lowest four vertices are the same.
    static std::strong_ordering CompareLarge(const FaceItems& lists, Index i, Index j) {
        if (lists.Count(i) <= 4 && lists.Count(j) <= 4) return std::strong_ordering::equal;
        std::vector<Index> a, b;
        for (auto [item, list] : {std::pair{i, &a}, std::pair{j, &b}}) {
            lists.Copy(item, *list);
            std::sort(list->begin(), list->end());
        }
        return std::lexicographical_compare_three_way(a.begin(), a.end(), b.begin(), b.end());
    }
};

}  // namespace SolidSubdiv::Vtr::Internal
