// SPDX-License-Identifier: Apache-2.0
// Derivatives of a row are its weights.
#include <solidsubdiv/apps/fit/internal/blocks.h>

#include <algorithm>

namespace SolidSubdiv::Fit::Internal {

namespace {

/// Sorted, each once; numbers are found by NumberOf.
void SortOnce(std::vector<Index>& points) {
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
}
std::size_t NumberOf(const std::vector<Index>& points, Index p) {
    return static_cast<std::size_t>(std::lower_bound(points.begin(), points.end(), p) - points.begin());
}

}  // namespace

LinearBlock::LinearBlock(std::span<const Row> rows) {
    for (const Row& row : rows) {
        for (const auto& entry : row.weights) control_points_.push_back(entry.first);
    }
    SortOnce(control_points_);
    const std::size_t width = control_points_.size();
    weights_.resize(rows.size() * width);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        for (const auto& entry : rows[i].weights) {
            weights_[i * width + NumberOf(control_points_, entry.first)] += entry.second;
        }
        goals_.push_back(rows[i].goal);
        matrices_.push_back(rows[i].matrix);
    }
    set_num_residuals(static_cast<int>(3 * rows.size()));
    mutable_parameter_block_sizes()->assign(width, 3);
}

bool LinearBlock::Evaluate(double const* const* parameters, double* residuals, double** jacobians) const {
    const std::size_t width = control_points_.size();
    for (std::size_t i = 0; i < goals_.size(); ++i) {
        std::array<double, 3> d{};
        for (std::size_t c = 0; c < 3; ++c) d[c] = -goals_[i][c];
        const double* const w = &weights_[i * width];
        for (std::size_t j = 0; j < width; ++j) {
            for (std::size_t c = 0; c < 3; ++c) d[c] += w[j] * parameters[j][c];
        }
        const auto& m = matrices_[i];
        for (std::size_t r = 0; r < 3; ++r) {
            residuals[3 * i + r] = m[3 * r] * d[0] + m[3 * r + 1] * d[1] + m[3 * r + 2] * d[2];
        }
    }
    if (jacobians == nullptr) return true;
    for (std::size_t j = 0; j < width; ++j) {
        if (jacobians[j] == nullptr) continue;
        for (std::size_t i = 0; i < goals_.size(); ++i) {
            for (std::size_t k = 0; k < 9; ++k) jacobians[j][9 * i + k] = weights_[i * width + j] * matrices_[i][k];
        }
    }
    return true;
}

}  // namespace SolidSubdiv::Fit::Internal
