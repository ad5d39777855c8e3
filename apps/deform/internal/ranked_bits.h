// SPDX-License-Identifier: Apache-2.0
// A set of numbers below a bound that numbers its members.
#pragma once

#include <bit>
#include <cstdint>
#include <vector>

#include <solidsubdiv/sdc/types.h>

namespace SolidSubdiv::Deform::Internal {

/// One bit a number that may be in it, and half a bit more.
class RankedBits {
  public:
    explicit RankedBits(std::uint64_t bound) : words_((bound + 63) / 64), before_(words_.size()) {}

    void Insert(std::uint64_t i) { words_[i / 64] |= std::uint64_t{1} << i % 64; }
    bool Has(std::uint64_t i) const { return (words_[i / 64] >> i % 64 & 1) != 0; }
    /// After the last Insert. Returns how many there are.
    Index Number() {
        std::uint32_t n = 0;
        for (std::size_t w = 0; w < words_.size(); ++w) {
            before_[w] = n;
            n += static_cast<std::uint32_t>(std::popcount(words_[w]));
        }
        return static_cast<Index>(n);
    }
    /// How many members are less than i. @pre Number() was called
    Index RankOf(std::uint64_t i) const {
        const std::uint64_t below = words_[i / 64] & ((std::uint64_t{1} << i % 64) - 1);
        return static_cast<Index>(before_[i / 64] + static_cast<std::uint32_t>(std::popcount(below)));
    }
    /// Calls with every member, ascending.
    template <class Function>
    void ForEach(Function&& function) const {
        for (std::size_t w = 0; w < words_.size(); ++w) {
            for (std::uint64_t word = words_[w]; word != 0; word &= word - 1) {
                function(64 * static_cast<std::uint64_t>(w) + static_cast<std::uint64_t>(std::countr_zero(word)));
            }
        }
    }

  private:
    std::vector<std::uint64_t> words_;
    std::vector<std::uint32_t> before_;
};

}  // namespace SolidSubdiv::Deform::Internal
