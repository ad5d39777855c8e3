// SPDX-License-Identifier: Apache-2.0
// A row while it is written.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include <solidsubdiv/sdc/types.h>

namespace SolidSubdiv::Far::Internal {

/// Room that a thread needs while it fills rows, one after another.
struct RowScratch {
    std::vector<std::uint32_t> notes;  ///< of each vertex of the level, whatever rows keep there
    std::vector<double> sums;          ///< of a row

    void MakeNotes(Index n_vertices) {
        if (notes.size() < static_cast<std::size_t>(n_vertices)) notes.resize(static_cast<std::size_t>(n_vertices));
    }
};

/// Takes in weights of vertices, in room that somebody else has. A vertex that comes again adds to its weight.
template <class Real>
class RowEntries {
  public:
    RowEntries(Index* indices, Real* weights) : indices_(indices), weights_(weights) {}

    void Add(Index v, double weight) {
        const auto at = std::find(indices_, indices_ + n_, v) - indices_;
        if (at == n_) {
            AddNew(v, weight);
        } else {
            weights_[at] += static_cast<Real>(weight);
        }
    }
    /// The same for a vertex that is not there yet.
    void AddNew(Index v, double weight) {
        indices_[n_] = v;
        weights_[n_++] = static_cast<Real>(weight);
    }
    int size() const { return static_cast<int>(n_); }

  private:
    Index* indices_;
    Real* weights_;
    std::ptrdiff_t n_ = 0;
};

}  // namespace SolidSubdiv::Far::Internal
