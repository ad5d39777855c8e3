// SPDX-License-Identifier: Apache-2.0
// Products with the rows of a drag, and conjugate gradients (CGLS).
#include <solidsubdiv/apps/deform/internal/drag_system.h>

#include <cmath>
#include <numeric>
#include <utility>

namespace SolidSubdiv::Deform::Internal {

namespace {

double SquaredLength(const std::vector<double>& v) { return std::inner_product(v.begin(), v.end(), v.begin(), 0.0); }

}  // namespace

DragSystem::DragSystem(Far::StencilRows<double> rows, std::vector<double> softness, std::vector<char> is_locked)
    : rows_(std::move(rows)), softness_(std::move(softness)), is_locked_(std::move(is_locked)) {
    for (std::size_t k = 0; k < rows_.indices.size(); ++k) {
        if (is_locked_[static_cast<std::size_t>(rows_.indices[k])]) rows_.weights[k] = 0;
    }
}

void DragSystem::SetVolumeRow(std::vector<double> gradient) {
    volume_row_ = std::move(gradient);
    for (std::size_t i = 0; i < volume_row_.size(); ++i) {
        if (is_locked_[i / 3]) volume_row_[i] = 0;
    }
    const double length = std::sqrt(SquaredLength(volume_row_));
    volume_row_length_ = length > 0 ? length : 1;
    for (double& x : volume_row_) x /= volume_row_length_;
}

bool DragSystem::IsImmovable(Index target) const {
    const auto weights = rows_.Weights(target);
    for (double weight : weights) {
        if (weight != 0) return false;
    }
    return true;
}

std::vector<double> DragSystem::Apply(const std::vector<double>& unknowns) const {
    std::vector<double> equations(n_equations());
    const double* slack = unknowns.data() + 3 * is_locked_.size();
    for (Index t = 0; t < n_targets(); ++t) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            double sum = 0;
            for (Offset k = rows_.offsets[t]; k < rows_.offsets[t + 1]; ++k) {
                sum += rows_.weights[k] * unknowns[3 * static_cast<std::size_t>(rows_.indices[k]) + axis];
            }
            const std::size_t at = 3 * static_cast<std::size_t>(t) + axis;
            equations[at] = sum + softness_[static_cast<std::size_t>(t)] * slack[at];
        }
    }
    if (!volume_row_.empty()) {
        equations.back() = std::inner_product(volume_row_.begin(), volume_row_.end(), unknowns.begin(), 0.0);
    }
    return equations;
}

std::vector<double> DragSystem::ApplyTransposed(const std::vector<double>& equations) const {
    std::vector<double> unknowns(n_unknowns());
    for (std::size_t i = 0; i < volume_row_.size(); ++i) unknowns[i] = volume_row_[i] * equations.back();
    double* slack = unknowns.data() + 3 * is_locked_.size();
    for (Index t = 0; t < n_targets(); ++t) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const std::size_t at = 3 * static_cast<std::size_t>(t) + axis;
            for (Offset k = rows_.offsets[t]; k < rows_.offsets[t + 1]; ++k) {
                unknowns[3 * static_cast<std::size_t>(rows_.indices[k]) + axis] += rows_.weights[k] * equations[at];
            }
            slack[at] = softness_[static_cast<std::size_t>(t)] * equations[at];
        }
    }
    return unknowns;
}

std::vector<double> DragSystem::LeastNorm(const std::vector<double>& right, int max_iterations,
                                          int& n_iterations) const {
    // A pass gains ten digits; then the residual is taken anew, and what rounding has left is solved for. Where no
    // unknowns solve the equations a residual stays, and its gradient can't fall below its rounding.
    constexpr int kPasses = 3;
    constexpr double kGain = 1e-10, kRounding = 1e-14;
    std::vector<double> unknowns(n_unknowns());
    std::vector<double> residual = right;
    for (int pass = 0; pass < kPasses; ++pass) {
        std::vector<double> gradient = ApplyTransposed(residual), direction = gradient;
        double slope = SquaredLength(gradient);
        const double aim = kGain * kGain * slope;
        const auto is_rounding = [&] { return slope <= kRounding * kRounding * SquaredLength(residual); };
        while (slope > aim && !is_rounding() && n_iterations < max_iterations) {
            ++n_iterations;
            const std::vector<double> image = Apply(direction);
            const double step = slope / SquaredLength(image);
            for (std::size_t i = 0; i < unknowns.size(); ++i) unknowns[i] += step * direction[i];
            for (std::size_t i = 0; i < residual.size(); ++i) residual[i] -= step * image[i];
            gradient = ApplyTransposed(residual);
            const double next = SquaredLength(gradient), ratio = next / slope;
            slope = next;
            for (std::size_t i = 0; i < direction.size(); ++i) direction[i] = gradient[i] + ratio * direction[i];
        }
        residual = Apply(unknowns);
        for (std::size_t i = 0; i < residual.size(); ++i) residual[i] = right[i] - residual[i];
        if (SquaredLength(residual) <= .01 * kRounding * kRounding * SquaredLength(right)) break;
    }
    return unknowns;
}

}  // namespace SolidSubdiv::Deform::Internal
