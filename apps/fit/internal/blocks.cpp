// SPDX-License-Identifier: Apache-2.0
// Derivatives by hand: of a row its weights, of a volume the cross products of its edges.
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

BarrierBlock::BarrierBlock(std::span<const Corner> corners, double factor) : factor_(factor) {
    for (const Corner& corner : corners) {
        control_points_.insert(control_points_.end(), corner.vertices.begin(), corner.vertices.end());
    }
    SortOnce(control_points_);
    for (const Corner& corner : corners) {
        std::array<std::size_t, 4> numbers{};
        for (std::size_t k = 0; k < 4; ++k) numbers[k] = NumberOf(control_points_, corner.vertices[k]);
        corners_.push_back(numbers);
        least_.push_back(corner.least);
    }
    set_num_residuals(static_cast<int>(corners.size()));
    mutable_parameter_block_sizes()->assign(control_points_.size(), 3);
}

bool BarrierBlock::Evaluate(double const* const* parameters, double* residuals, double** jacobians) const {
    if (jacobians != nullptr) {
        for (std::size_t j = 0; j < control_points_.size(); ++j) {
            if (jacobians[j] != nullptr) std::fill_n(jacobians[j], 3 * corners_.size(), 0.0);
        }
    }
    for (std::size_t i = 0; i < corners_.size(); ++i) {
        const auto& corner = corners_[i];
        std::array<std::array<double, 3>, 3> e{};  // edges from the corner
        for (std::size_t k = 0; k < 3; ++k) {
            for (std::size_t c = 0; c < 3; ++c) e[k][c] = parameters[corner[k + 1]][c] - parameters[corner[0]][c];
        }
        const auto cross = [](const auto& a, const auto& b) {
            return std::array<double, 3>{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                                         a[0] * b[1] - a[1] * b[0]};
        };
        // The derivative of the volume by each edge.
        const std::array<std::array<double, 3>, 3> by = {cross(e[1], e[2]), cross(e[2], e[0]), cross(e[0], e[1])};
        const double volume = e[0][0] * by[0][0] + e[0][1] * by[0][1] + e[0][2] * by[0][2];
        const double missing = 1 - volume / least_[i];
        residuals[i] = missing > 0 ? factor_ * missing : 0;
        if (jacobians == nullptr || !(missing > 0)) continue;
        const double scale = -factor_ / least_[i];
        for (std::size_t k = 0; k < 3; ++k) {
            for (std::size_t c = 0; c < 3; ++c) {
                if (jacobians[corner[k + 1]] != nullptr) jacobians[corner[k + 1]][3 * i + c] += scale * by[k][c];
                if (jacobians[corner[0]] != nullptr) jacobians[corner[0]][3 * i + c] -= scale * by[k][c];
            }
        }
    }
    return true;
}

}  // namespace SolidSubdiv::Fit::Internal
