// SPDX-License-Identifier: Apache-2.0
// Rows of the dragged points, solved for the least change; with the volume again and again, about the last change.
#include <solidsubdiv/apps/deform/direct_manipulation.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include <solidsubdiv/apps/deform/deformer.h>
#include <solidsubdiv/apps/deform/internal/drag_system.h>
#include <solidsubdiv/apps/deform/internal/transpose.h>

namespace SolidSubdiv::Deform {

namespace {

using Triple = std::array<double, 3>;

Triple At(std::span<const double> triples, Index i) {
    const double* x = triples.data() + 3 * static_cast<std::size_t>(i);
    return {x[0], x[1], x[2]};
}

Triple Cross(const Triple& a, const Triple& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

void RequireIndex(Index i, Index n, const std::string& of) {
    if (i < 0 || i >= n) throw InvalidInput(of + " is " + std::to_string(i) + ", out of " + std::to_string(n));
}

void RequireFinite(std::span<const double> values, const std::string& of) {
    for (double x : values) {
        if (!std::isfinite(x)) throw InvalidInput(of + " is " + std::to_string(x));
    }
}

void RequireTriples(std::span<const double> values, Index n, const std::string& of) {
    if (values.size() == 3 * static_cast<std::size_t>(n)) return;
    throw InvalidInput(of + ": " + std::to_string(values.size()) + " coordinates are given for " + std::to_string(n));
}

void CheckInput(const Embedding& embedding, std::span<const double> control_points, std::span<const DragTarget> targets,
                const DragOptions& options) {
    options.Validate();
    RequireTriples(control_points, embedding.n_control_points(), "control points");
    RequireFinite(control_points, "a coordinate of a control point");
    for (std::size_t t = 0; t < targets.size(); ++t) {
        const std::string of = "drag target " + std::to_string(t);
        RequireIndex(targets[t].point, embedding.n_points(), of + ": its point");
        RequireFinite(targets[t].position, of + ": a coordinate");
        if (!(targets[t].weight > 0)) {
            throw InvalidInput(of + ": its weight is " + std::to_string(targets[t].weight) + ", not positive");
        }
    }
    for (Index i : options.locked) RequireIndex(i, embedding.n_control_points(), "a locked control point");
    if (options.preserve_volume) {
        for (std::size_t k = 0; k < options.triangles.size(); ++k) {
            RequireIndex(options.triangles[k], embedding.n_points(),
                         "a point of triangle " + std::to_string(k / 3) + " to preserve the volume of");
        }
    }
    if (options.correction.empty()) return;
    RequireTriples(options.correction, embedding.n_points(), "corrections of points");
    RequireFinite(options.correction, "a coordinate of a correction");
}

/// The model's volume and its gradient, as functions of the control points.
class Volume {
  public:
    Volume(const Embedding& embedding, const DragOptions& options, const Triple& apex)
        : embedding_(embedding),
          options_(options),
          apex_(apex),
          deformer_(embedding),
          points_(3 * static_cast<std::size_t>(embedding.n_points())) {}

    /// Also prepares Gradient().
    double Of(std::span<const double> control_points) {
        deformer_.Deform(control_points, points_);
        for (std::size_t i = 0; i < points_.size(); ++i) {
            points_[i] += (options_.correction.empty() ? 0 : options_.correction[i]) - apex_[i % 3];
        }
        double sum = 0;
        for (std::size_t k = 0; k < options_.triangles.size(); k += 3) {
            const Triple a = Corner(k), normal = Cross(Corner(k + 1), Corner(k + 2));
            sum += a[0] * normal[0] + a[1] * normal[1] + a[2] * normal[2];
        }
        return sum / 6;
    }
    std::vector<double> Gradient() const {
        std::vector<double> by_points(points_.size());
        for (std::size_t k = 0; k < options_.triangles.size(); k += 3) {
            for (std::size_t i = 0; i < 3; ++i) {
                const Triple normal = Cross(Corner(k + (i + 1) % 3), Corner(k + (i + 2) % 3));
                double* to = by_points.data() + 3 * static_cast<std::size_t>(options_.triangles[k + i]);
                for (std::size_t axis = 0; axis < 3; ++axis) to[axis] += normal[axis] / 6;
            }
        }
        return Internal::ApplyTransposed(embedding_.tables(), by_points);
    }

  private:
    Triple Corner(std::size_t k) const { return At(points_, options_.triangles[k]); }

    const Embedding& embedding_;
    const DragOptions& options_;
    Triple apex_;  ///< of the cones: near the model, so that they are small
    Deformer deformer_;
    std::vector<double> points_;  ///< seen from the apex
};

/// Control points after a change; those that do not change keep their bits.
std::vector<double> Changed(std::span<const double> control_points, const std::vector<double>& change,
                            const std::vector<char>& is_locked) {
    std::vector<double> result(control_points.begin(), control_points.end());
    for (std::size_t i = 0; i < result.size(); ++i) {
        if (!is_locked[i / 3] && change[i] != 0) result[i] += change[i];
    }
    return result;
}

/// What the targets' points lack, three numbers a target.
std::vector<double> Lacks(const Embedding& embedding, const Far::StencilRows<double>& rows,
                          std::span<const double> control_points, std::span<const DragTarget> targets,
                          std::span<const double> correction) {
    std::vector<double> lacks;
    for (Index t = 0; t < rows.n_rows(); ++t) {
        const DragTarget& target = targets[static_cast<std::size_t>(t)];
        Triple lack = target.position;
        for (Offset k = rows.offsets[t]; k < rows.offsets[t + 1]; ++k) {
            const Triple x = At(control_points, rows.indices[k]);
            for (std::size_t axis = 0; axis < 3; ++axis) lack[axis] -= rows.weights[k] * x[axis];
        }
        const auto& outside = embedding.outside();
        const auto out = std::lower_bound(outside.begin(), outside.end(), target.point,
                                          [](const OutsidePoint& o, Index p) { return o.point < p; });
        const bool is_outside = out != outside.end() && out->point == target.point;
        const Triple constant = is_outside ? out->constant : Triple{};
        const Triple added = correction.empty() ? Triple{} : At(correction, target.point);
        for (std::size_t axis = 0; axis < 3; ++axis) lacks.push_back(lack[axis] - constant[axis] - added[axis]);
    }
    return lacks;
}

}  // namespace

void DragOptions::Validate() const {
    if (!(tolerance > 0 && tolerance < 1)) {
        throw InvalidInput("tolerance of a drag must be in (0, 1), not " + std::to_string(tolerance));
    }
    if (max_iterations < 1) {
        throw InvalidInput("max_iterations of a drag must be at least 1, not " + std::to_string(max_iterations));
    }
    if (preserve_volume && (triangles.empty() || triangles.size() % 3 != 0)) {
        throw InvalidInput("to preserve a volume needs triangles, three corners each; there are " +
                           std::to_string(triangles.size()) + " corners");
    }
}

DragResult Drag(const Embedding& embedding, std::span<const double> control_points, std::span<const DragTarget> targets,
                const DragOptions& options) {
    CheckInput(embedding, control_points, targets, options);
    std::vector<Index> points;
    std::vector<double> softness;
    for (const DragTarget& target : targets) {
        points.push_back(target.point);
        softness.push_back(1 / std::sqrt(target.weight));
    }
    std::vector<char> is_locked(static_cast<std::size_t>(embedding.n_control_points()), 0);
    for (Index i : options.locked) is_locked[static_cast<std::size_t>(i)] = 1;
    Triple low{}, high{};
    for (std::size_t i = 0; i < control_points.size(); ++i) {
        low[i % 3] = i < 3 ? control_points[i] : std::min(low[i % 3], control_points[i]);
        high[i % 3] = i < 3 ? control_points[i] : std::max(high[i % 3], control_points[i]);
    }
    const double size = std::hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]);

    const Far::StencilRows<double> rows = embedding.ControlRows(points);
    Internal::DragSystem system(rows, softness, is_locked);
    DragResult result;
    result.control_points.assign(control_points.begin(), control_points.end());
    for (Index t = 0; t < rows.n_rows(); ++t) {
        if (system.IsImmovable(t)) result.immovable.push_back(points[static_cast<std::size_t>(t)]);
    }
    std::sort(result.immovable.begin(), result.immovable.end());
    result.immovable.erase(std::unique(result.immovable.begin(), result.immovable.end()), result.immovable.end());

    std::vector<double> right = Lacks(embedding, rows, control_points, targets, options.correction);
    std::vector<double> unknowns(system.n_unknowns());
    if (!options.preserve_volume) {
        unknowns = system.LeastNorm(right, options.max_iterations, result.iterations);
        result.control_points = Changed(control_points, unknowns, is_locked);
    } else {
        // The least change that meets the targets and the volume's tangent at the last change, until the volume holds.
        // Where this has not settled after some steps the change is corrected instead, by the least correction: it
        // gets there, if not by the very least change.
        constexpr int kSteps = 50, kLeastChanges = 25;
        Volume volume(embedding, options, {(low[0] + high[0]) / 2, (low[1] + high[1]) / 2, (low[2] + high[2]) / 2});
        result.volume_before = result.volume_after = volume.Of(control_points);
        right.push_back(0);
        for (int step = 0; step < kSteps; ++step) {
            system.SetVolumeRow(volume.Gradient());
            const std::vector<double> reached = system.Apply(unknowns);
            right.back() = (result.volume_before - result.volume_after) / system.volume_row_length() + reached.back();
            if (step < kLeastChanges) {
                unknowns = system.LeastNorm(right, options.max_iterations, result.iterations);
            } else {
                std::vector<double> lack = right;
                for (std::size_t i = 0; i < lack.size(); ++i) lack[i] -= reached[i];
                const auto more = system.LeastNorm(lack, options.max_iterations, result.iterations);
                for (std::size_t i = 0; i < more.size(); ++i) unknowns[i] += more[i];
            }
            result.control_points = Changed(control_points, unknowns, is_locked);
            result.volume_after = volume.Of(result.control_points);
            const double error = std::abs(result.volume_after - result.volume_before);
            if (error <= options.tolerance * std::abs(result.volume_before)) break;
        }
        const double error = std::abs(result.volume_after - result.volume_before);
        result.is_consistent = error <= options.tolerance * std::abs(result.volume_before);
    }

    for (std::size_t i = 0; i < is_locked.size(); ++i) {
        if (At(result.control_points, static_cast<Index>(i)) != At(control_points, static_cast<Index>(i))) {
            result.moved.push_back(static_cast<Index>(i));
        }
    }
    const auto lacks = Lacks(embedding, rows, result.control_points, targets, options.correction);
    for (std::size_t t = 0; t < targets.size(); ++t) {
        if (std::isfinite(targets[t].weight)) continue;
        const Triple lack = At(lacks, static_cast<Index>(t));
        result.largest_residual = std::max(result.largest_residual, std::hypot(lack[0], lack[1], lack[2]));
    }
    result.is_consistent = result.is_consistent && result.largest_residual <= options.tolerance * size;
    return result;
}

}  // namespace SolidSubdiv::Deform
