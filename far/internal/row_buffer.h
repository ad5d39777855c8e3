// SPDX-License-Identifier: Apache-2.0
// Rows read one after another.
#pragma once

#include <span>
#include <vector>

#include <solidsubdiv/far/internal/row_entries.h>

namespace SolidSubdiv::Far::Internal {

/// One row after another, in room that is used again.
template <class Real>
struct RowBuffer {
    std::vector<Index> indices;  ///< and weights: the first n count
    std::vector<Real> weights;
    std::size_t n = 0;
    RowScratch scratch;

    template <class AnyRows>
    void Read(const AnyRows& rows, Index child) {
        const std::size_t room = rows.MaxLength(child);
        if (indices.size() < room) {
            indices.resize(2 * room);
            weights.resize(2 * room);
        }
        n = rows.Fill(child, indices.data(), weights.data(), scratch);
    }
    std::span<const Index> Indices() const { return {indices.data(), n}; }
    std::span<const Real> Weights() const { return {weights.data(), n}; }
};

}  // namespace SolidSubdiv::Far::Internal
