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

namespace SolidSubdiv::Vtr::Internal {

struct UniqueFaces {
    Array<Index> face_of_item;
    Array<Offset> starts{0};  ///< (size() + 1): of each face, its items among `items`
    Array<Index> items;       ///< ascending within a face

    Index size() const { return static_cast<Index>(starts.size()) - 1; }

    UniqueFaces(const FaceItems& lists, Index n_vertices) {
        constexpr Offset kGrain = 1024;
        const Offset n = lists.size();
        Array<std::array<Index, 4>> keys(static_cast<std::size_t>(n));
        Sdc::ParallelFor(n, kGrain, [&](Offset begin, Offset end) {
            for (Offset i = begin; i < end; ++i) keys[i] = lists.LowestFour(i);
        });
        // Rows by lowest vertex: the next three, which tell all faces but large ones apart, and the item are kept side
        // by side and sorted.
        using Entry = std::array<Index, 4>;
        const auto visit = [&](auto&& add) {
            for (Offset i = 0; i < n; ++i) add(keys[i][0], i);
        };
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
