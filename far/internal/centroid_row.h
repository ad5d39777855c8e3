// SPDX-License-Identifier: Apache-2.0
// A row while it is summed from centroids.
#pragma once

#include <cstdint>
#include <span>

#include <solidsubdiv/far/internal/row_entries.h>

namespace SolidSubdiv::Far::Internal {

/// A row being summed from vertices and means of vertices; each vertex has one entry.
class CentroidRow {
  public:
    /// @param scratch has notes of all vertices and room for the row's sums
    CentroidRow(Index* indices, RowScratch& scratch)
        : indices_(indices), notes_(scratch.notes.data()), sums_(scratch.sums.data()) {}

    void Add(Index v, double weight) {
        const std::uint32_t noted = notes_[v];
        if (noted < n_ && indices_[noted] == v) {
            sums_[noted] += weight;
        } else {
            notes_[v] = n_;
            indices_[n_] = v;
            sums_[n_++] = weight;
        }
    }
    void AddMean(std::span<const Index> vertices, double weight) {
        const double share = weight / static_cast<double>(vertices.size());
        for (Index v : vertices) Add(v, share);
    }
    int size() const { return static_cast<int>(n_); }
    double operator[](int i) const { return sums_[i]; }

  private:
    Index* indices_;
    std::uint32_t* notes_;
    double* sums_;
    std::uint32_t n_ = 0;
};

}  // namespace SolidSubdiv::Far::Internal
