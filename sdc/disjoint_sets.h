// SPDX-License-Identifier: Apache-2.0
// Which of the numbers from 0 on belong together, while they are joined.
#pragma once

#include <algorithm>
#include <numeric>
#include <vector>

namespace SolidSubdiv::Sdc {

/// Disjoint sets of 0 .. n - 1; the least member stands for its set.
class DisjointSets {
  public:
    explicit DisjointSets(std::size_t n = 0) { Reset(n); }
    /// Each number is a set of its own.
    void Reset(std::size_t n) {
        parent_.resize(n);
        std::iota(parent_.begin(), parent_.end(), std::size_t{0});
        n_sets_ = n;
    }
    std::size_t Find(std::size_t i) {
        while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
        return i;
    }
    void Unite(std::size_t i, std::size_t j) {
        i = Find(i);
        j = Find(j);
        if (i == j) return;
        parent_[std::max(i, j)] = std::min(i, j);
        --n_sets_;
    }
    std::size_t n_sets() const { return n_sets_; }

  private:
    std::vector<std::size_t> parent_;
    std::size_t n_sets_ = 0;
};

}  // namespace SolidSubdiv::Sdc
