// SPDX-License-Identifier: Apache-2.0
// What the fuzz targets of the refiners share: numbers from bytes, and what must hold of any table.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstdlib>

#include <solidsubdiv/far/stencil_table.h>

namespace SolidSubdiv::Fuzz {

class Bytes {
  public:
    Bytes(const std::uint8_t* data, std::size_t size) : data_(data), end_(data + size) {}
    int Next() { return data_ < end_ ? *data_++ : 0; }
    bool empty() const { return data_ >= end_; }

    /// Mostly in range, so that whole complexes come about; 255 is out of it.
    Index NextVertex(Index n_vertices) {
        const int b = Next();
        return b == 255 || n_vertices == 0 ? b - 256 : b % n_vertices;
    }
    float NextSharpness() {
        const int b = Next();
        return b == 255 ? -1.0f : static_cast<float>(b) / 20;
    }

  private:
    const std::uint8_t* data_;
    const std::uint8_t* end_;
};

inline void Require(bool holds) {
    if (!holds) std::abort();
}

/// Rows sum to one and name vertices that are there. Empty ones may be there where `may_lack`.
inline void CheckRows(const Far::StencilRows<double>& rows, bool may_lack = false) {
    for (Index i = 0; i < rows.n_rows(); ++i) {
        double sum = 0;
        for (double w : rows.Weights(i)) sum += w;
        Require(std::abs(sum - 1) < 1e-12 || (may_lack && rows.Weights(i).empty()));
        for (Index v : rows.Indices(i)) Require(v >= 0 && v < rows.n_sources);
    }
}
inline void CheckTable(const Far::StencilTable& table) {
    for (int l = 1; l <= table.n_levels(); ++l) CheckRows(table.level(l));
}

}  // namespace SolidSubdiv::Fuzz
