// SPDX-License-Identifier: Apache-2.0
// The sum of a few sparse rows, with ascending indices.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include <solidsubdiv/sdc/types.h>

namespace SolidSubdiv::Far::Internal {

/// One row being summed.
class RowSum {
  public:
    /// Indices are [0, n_columns). Memory: 9 bytes a column.
    explicit RowSum(Index n_columns)
        : weights_(static_cast<std::size_t>(n_columns)), is_touched_(static_cast<std::size_t>(n_columns)) {}

    /// Adds factor times a row of distinct or repeated indices.
    void Add(double factor, std::span<const Index> indices, std::span<const double> weights) {
        if (touched_.size() < n_touched_ + indices.size()) touched_.resize(2 * (n_touched_ + indices.size()));
        Index* const touched = touched_.data();
        double* const sums = weights_.data();
        char* const is_touched = is_touched_.data();
        std::size_t n = n_touched_;
        // Without a branch: whether an index is new to the row is anybody's guess.
        for (std::size_t k = 0; k < indices.size(); ++k) {
            const Index i = indices[k];
            touched[n] = i;
            n += 1 - static_cast<std::size_t>(is_touched[i]);
            is_touched[i] = 1;
            sums[i] += factor * weights[k];
        }
        n_touched_ = n;
    }

    /// Appends the row, indices ascending, and starts anew.
    template <class Real>
    void Flush(Array<Index>& indices, Array<Real>& weights) {
        std::sort(touched_.begin(), touched_.begin() + static_cast<std::ptrdiff_t>(n_touched_));
        const std::size_t at = indices.size();
        indices.insert(indices.end(), touched_.begin(), touched_.begin() + static_cast<std::ptrdiff_t>(n_touched_));
        weights.resize(at + n_touched_);
        for (std::size_t i = 0; i < n_touched_; ++i) {
            const auto place = static_cast<std::size_t>(touched_[i]);
            weights[at + i] = static_cast<Real>(weights_[place]);
            weights_[place] = 0;
            is_touched_[place] = 0;
        }
        n_touched_ = 0;
    }

  private:
    std::vector<double> weights_;
    std::vector<char> is_touched_;
    std::vector<Index> touched_;
    std::size_t n_touched_ = 0;
};

}  // namespace SolidSubdiv::Far::Internal
