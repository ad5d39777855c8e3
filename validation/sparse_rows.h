// SPDX-License-Identifier: Apache-2.0
// A sparse matrix by rows, as oracles give it.
#pragma once

#include <cstdint>
#include <vector>

namespace SolidSubdiv::Validation {

/// Row r in [offsets[r], offsets[r + 1]), every index once, ascending.
struct SparseRows {
    std::vector<std::int64_t> offsets = {0};
    std::vector<int> indices;
    std::vector<double> weights;

    int n_rows() const { return static_cast<int>(offsets.size()) - 1; }
};

/// @param positions (n, 3), row-major, n more than any index
/// @return (n_rows, 3)
inline std::vector<double> Apply(const SparseRows& rows, const std::vector<double>& positions) {
    std::vector<double> result(3 * static_cast<std::size_t>(rows.n_rows()));
    for (std::size_t r = 0; r + 1 < rows.offsets.size(); ++r) {
        for (std::int64_t k = rows.offsets[r]; k < rows.offsets[r + 1]; ++k) {
            for (std::size_t i = 0; i < 3; ++i) {
                result[3 * r + i] += rows.weights[k] * positions[3 * static_cast<std::size_t>(rows.indices[k]) + i];
            }
        }
    }
    return result;
}

}  // namespace SolidSubdiv::Validation
