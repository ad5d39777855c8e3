// SPDX-License-Identifier: Apache-2.0
// Arrays of points: their size, and what rows make of them.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

namespace SolidSubdiv::Validation {

/// The length of the diagonal of the box around all points. @param positions (n, 3), row-major
inline double SizeOf(std::span<const double> positions) {
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        double low = positions[i], high = positions[i];
        for (std::size_t k = i; k < positions.size(); k += 3) {
            low = std::min(low, positions[k]);
            high = std::max(high, positions[k]);
        }
        sum += (high - low) * (high - low);
    }
    return std::sqrt(sum);
}

/// By rows with offsets, indices and weights, an oracle's or ours. @param positions (n, 3), n more than any index
/// @return (n_rows, 3)
template <class Rows>
std::vector<double> Apply(const Rows& rows, const std::vector<double>& positions) {
    std::vector<double> result(3 * static_cast<std::size_t>(rows.n_rows()));
    for (std::size_t r = 0; r + 1 < rows.offsets.size(); ++r) {
        for (auto k = rows.offsets[r]; k < rows.offsets[r + 1]; ++k) {
            for (std::size_t i = 0; i < 3; ++i) {
                result[3 * r + i] += rows.weights[k] * positions[3 * static_cast<std::size_t>(rows.indices[k]) + i];
            }
        }
    }
    return result;
}

}  // namespace SolidSubdiv::Validation
