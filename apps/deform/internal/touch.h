// SPDX-License-Identifier: Apache-2.0
// Sets of indices that are made, walked through in order and emptied again in time of what is in them.
#pragma once

#include <bit>
#include <cstdint>
#include <vector>

#include <solidsubdiv/far/stencil_table.h>
#include <solidsubdiv/vtr/grouping.h>

namespace SolidSubdiv::Deform::Internal {

/// A bit an index; two levels, so that few indices among many are found fast.
class TouchSet {
  public:
    explicit TouchSet(Index n = 0)
        : bits_((static_cast<std::size_t>(n) + 63) / 64), blocks_((bits_.size() + 63) / 64) {}

    void Add(Index i) {
        const std::size_t word = static_cast<std::size_t>(i) / 64;
        bits_[word] |= std::uint64_t{1} << (i % 64);
        blocks_[word / 64] |= std::uint64_t{1} << (word % 64);
    }

    /// Calls visit(i) for all, ascending, and empties the set.
    template <class Visit>
    void Drain(Visit&& visit) {
        for (std::size_t b = 0; b < blocks_.size(); ++b) {
            for (; blocks_[b] != 0; blocks_[b] &= blocks_[b] - 1) {
                const std::size_t word = 64 * b + static_cast<std::size_t>(std::countr_zero(blocks_[b]));
                for (; bits_[word] != 0; bits_[word] &= bits_[word] - 1) {
                    visit(static_cast<Index>(64 * word + static_cast<std::size_t>(std::countr_zero(bits_[word]))));
                }
            }
        }
    }

  private:
    std::vector<std::uint64_t> bits_, blocks_;
};

/// For each of n parts the items that have it, ascending: the transpose of rows of indices.
struct Users {
    Array<Offset> offsets{0};
    Array<Index> items;

    std::span<const Index> operator[](Index part) const {
        return {items.data() + offsets[part], static_cast<std::size_t>(offsets[part + 1] - offsets[part])};
    }
    Offset Bytes() const { return static_cast<Offset>(offsets.size() * sizeof(Offset) + items.size() * sizeof(Index)); }
};

/// @param visit calls its argument (part, item) for every pair, items ascending
template <class Visit>
Users MakeUsers(Index n_parts, Visit&& visit) {
    Users users{Vtr::CountRows(n_parts, visit), {}};
    users.items.resize(static_cast<std::size_t>(users.offsets.back()));
    Vtr::FillRows(users.offsets, visit, [&](Offset place, Index item) { users.items[place] = item; });
    return users;
}

}  // namespace SolidSubdiv::Deform::Internal
