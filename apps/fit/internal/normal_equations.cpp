// SPDX-License-Identifier: Apache-2.0
// Rows are added in their order: the same bits each time.
#include <solidsubdiv/apps/fit/internal/normal_equations.h>

#include <algorithm>

namespace SolidSubdiv::Fit::Internal {

NormalEquations::NormalEquations(std::span<const double> at) : at_(at), rows_(at.size() / 3), slope_(at.size()) {}

void NormalEquations::Add(Weights weights, const std::array<double, 3>& goal, const std::array<double, 9>& matrix) {
    std::array<double, 9> square{};  // M M
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            for (std::size_t k = 0; k < 3; ++k) square[3 * i + j] += matrix[3 * i + k] * matrix[3 * k + j];
        }
    }
    std::array<double, 3> off{}, pull{};
    for (std::size_t c = 0; c < 3; ++c) off[c] = -goal[c];
    for (const auto& w : weights) {
        for (std::size_t c = 0; c < 3; ++c) off[c] += w.second * at_[3 * static_cast<std::size_t>(w.first) + c];
    }
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t k = 0; k < 3; ++k) pull[i] += square[3 * i + k] * off[k];
        start_ += 0.5 * off[i] * pull[i];
    }
    for (const auto& a : weights) {
        const auto i = static_cast<std::size_t>(a.first);
        for (std::size_t c = 0; c < 3; ++c) slope_[3 * i + c] += a.second * pull[c];
        std::vector<Block>& row = rows_[i];
        for (const auto& b : weights) {
            auto block = std::lower_bound(row.begin(), row.end(), b.first,
                                          [](const Block& x, Index column) { return x.column < column; });
            if (block == row.end() || block->column != b.first) block = row.insert(block, Block{b.first});
            const double w = a.second * b.second;
            for (std::size_t k = 0; k < 9; ++k) block->sum[k] += w * square[k];
        }
    }
}

double NormalEquations::Evaluate(std::span<const double> moved, std::span<double> slope) const {
    double sum = start_;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        std::array<double, 3> s{};
        for (const Block& block : rows_[i]) {
            const double* const d = &moved[3 * static_cast<std::size_t>(block.column)];
            const auto& m = block.sum;
            s[0] += m[0] * d[0] + m[1] * d[1] + m[2] * d[2];
            s[1] += m[3] * d[0] + m[4] * d[1] + m[5] * d[2];
            s[2] += m[6] * d[0] + m[7] * d[1] + m[8] * d[2];
        }
        for (std::size_t c = 0; c < 3; ++c) {
            sum += moved[3 * i + c] * (slope_[3 * i + c] + 0.5 * s[c]);
            if (!slope.empty()) slope[3 * i + c] = slope_[3 * i + c] + s[c];
        }
    }
    return sum;
}

std::array<double, 9> NormalEquations::Diagonal(Index point) const {
    for (const Block& block : rows_[static_cast<std::size_t>(point)]) {
        if (block.column == point) return block.sum;
    }
    return {};
}

}  // namespace SolidSubdiv::Fit::Internal
