// SPDX-License-Identifier: Apache-2.0
// A row of vertices while it is summed from vertices and centroids.
#pragma once

#include <cstdint>
#include <span>

#include <solidsubdiv/far/internal/row_entries.h>
#include <solidsubdiv/vtr/polyhedral_level.h>

namespace SolidSubdiv::Far::Internal {

/// Each vertex has one entry.
class CentroidRow {
  public:
    /// @param scratch has notes of all vertices and room for the row's sums
    CentroidRow(const Vtr::PolyhedralLevel& level, Index* indices, RowScratch& scratch)
        : level_(level), indices_(indices), notes_(scratch.notes.data()), sums_(scratch.sums.data()) {}

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
    void AddFace(Index f, double weight) { AddMean(level_.FaceVertices(f), weight); }
    void AddCell(Index c, double weight) { AddMean(level_.CellVertices(c), weight); }
    int size() const { return static_cast<int>(n_); }
    double operator[](int i) const { return sums_[i]; }

  private:
    void AddMean(std::span<const Index> vertices, double weight) {
        const double share = weight / static_cast<double>(vertices.size());
        for (Index v : vertices) Add(v, share);
    }

    const Vtr::PolyhedralLevel& level_;
    Index* indices_;
    std::uint32_t* notes_;
    double* sums_;
    std::uint32_t n_ = 0;
};

}  // namespace SolidSubdiv::Far::Internal
