// SPDX-License-Identifier: Apache-2.0
// A sparse matrix by rows, as oracles give it.
#pragma once

#include <cstdint>
#include <vector>

#include "points.h"

namespace SolidSubdiv::Validation {

/// Row r in [offsets[r], offsets[r + 1]), every index once, ascending.
struct SparseRows {
    std::vector<std::int64_t> offsets = {0};
    std::vector<int> indices;
    std::vector<double> weights;

    int n_rows() const { return static_cast<int>(offsets.size()) - 1; }
};

}  // namespace SolidSubdiv::Validation
