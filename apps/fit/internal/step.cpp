// SPDX-License-Identifier: Apache-2.0
// All rows as one quadratic form, the energy of corners beside it, and Ceres' L-BFGS. Gauss-Newton's steps, which see
// that energy as a parabola, are refused a dozen times on the way around a corner (docs/decisions/0014).
#include <solidsubdiv/apps/fit/internal/step.h>

#include <algorithm>
#include <cmath>

#include <ceres/gradient_problem.h>
#include <ceres/gradient_problem_solver.h>
#include <Eigen/Dense>

#include <solidsubdiv/apps/fit/internal/corner_shapes.h>
#include <solidsubdiv/apps/fit/internal/normal_equations.h>
#include <solidsubdiv/sdc/errors.h>

namespace SolidSubdiv::Fit::Internal {

namespace {

constexpr double kSoftness = 0.05;  // of corners: below a twentieth of a cube's scaled Jacobian it gets steep

/// Half of what is minimized, times kScale, over movements in which the quadratic form looks alike along every axis of
/// a point: movement = factor^-T * unknown, factor factor^T the form's block of the point with itself.
class Objective final : public ceres::FirstOrderFunction {
  public:
    Objective(const StepSettings& settings, const NormalEquations& form, std::span<const double> start)
        : settings_(settings),
          form_(form),
          start_(start),
          moved_(start.size()),
          at_(start.size()),
          slope_(start.size()),
          fine_{settings.problem.fine_places, {}},
          fine_enough_(settings.problem.fine_corners.size(), kEnoughOfFine) {
        stays_.resize(start.size() / 3);
        for (Index p : settings.problem.locked) stays_[static_cast<std::size_t>(p)] = true;
        for (std::size_t p = 0; p < stays_.size(); ++p) {
            const auto d = form.Diagonal(static_cast<Index>(p));
            Eigen::Matrix3d block = Eigen::Map<const Eigen::Matrix3d>(d.data());
            // What corners add where they are well shaped, and cells some thirtieth of the diagonal.
            block.diagonal().array() += kLeast + 1e3 * settings.barrier;
            factors_.push_back(block.llt().matrixL());
        }
    }

    int NumParameters() const override { return static_cast<int>(start_.size()); }

    bool Evaluate(const double* unknown, double* cost, double* gradient) const override {
        Move(unknown);
        *cost = form_.Evaluate(moved_, gradient ? std::span<double>(slope_) : std::span<double>());
        *cost += 0.5 * settings_.barrier *
                 CornerEnergy(settings_.problem.corners, settings_.enough, at_, kSoftness, 0.5 * settings_.barrier,
                              gradient ? std::span<double>(slope_) : std::span<double>());
        *cost += AddFineCorners(gradient != nullptr);
        *cost *= kScale;
        if (gradient == nullptr) return true;
        for (std::size_t p = 0; p < stays_.size(); ++p) {
            Eigen::Map<Eigen::Vector3d> to(gradient + 3 * p);
            to.setZero();
            if (stays_[p]) continue;
            to = Eigen::Map<const Eigen::Vector3d>(&slope_[3 * p]);
            to = kScale * factors_[p].triangularView<Eigen::Lower>().solve(to);
        }
        return true;
    }

    /// Where the points are for these unknowns.
    const std::vector<double>& Move(const double* unknown) const {
        for (std::size_t p = 0; p < stays_.size(); ++p) {
            Eigen::Vector3d d = Eigen::Map<const Eigen::Vector3d>(unknown + 3 * p);
            d = factors_[p].transpose().triangularView<Eigen::Upper>().solve(d);
            for (std::size_t c = 0; c < 3; ++c) {
                moved_[3 * p + c] = stays_[p] ? 0 : d[static_cast<Eigen::Index>(c)];
                at_[3 * p + c] = start_[3 * p + c] + moved_[3 * p + c];
            }
        }
        return at_;
    }

  private:
    /// Their energy; adds its slope. Places are sums of control points, so the slope goes back by the same weights.
    double AddFineCorners(bool with_slope) const {
        const Problem& p = settings_.problem;
        if (p.fine_corners.empty()) return 0;
        const std::vector<double> at = fine_.Positions(at_);
        const double factor = 0.5 * settings_.barrier;
        std::vector<double> slope(with_slope ? at.size() : 0);
        const double energy = CornerEnergy(p.fine_corners, fine_enough_, at, kSoftness, factor, slope);
        for (Index v = 0; with_slope && v < p.fine_places.n_rows(); ++v) {
            const auto indices = p.fine_places.Indices(v);
            const auto weights = p.fine_places.Weights(v);
            for (std::size_t k = 0; k < indices.size(); ++k) {
                for (std::size_t c = 0; c < 3; ++c) {
                    slope_[3 * static_cast<std::size_t>(indices[k]) + c] +=
                        weights[k] * slope[3 * static_cast<std::size_t>(v) + c];
                }
            }
        }
        return factor * energy;
    }

    static constexpr double kScale = 1e6;   // distances of a thousandth of the diagonal give costs of about 1
    static constexpr double kLeast = 1e-9;  // for points in no row
    static constexpr double kEnoughOfFine = 0.35;
    const StepSettings& settings_;
    const NormalEquations& form_;
    std::span<const double> start_;
    std::vector<bool> stays_{};
    std::vector<Eigen::Matrix3d> factors_{};
    mutable std::vector<double> moved_, at_, slope_;
    MovingSurface fine_;  ///< the fine places
    std::vector<double> fine_enough_;
};

}  // namespace

int SolveStep(const StepSettings& settings, std::span<const Pair> pairs, double fairness, std::span<double> control) {
    const std::vector<double> start(control.begin(), control.end());
    NormalEquations form(start);
    for (const Pair& pair : pairs) {
        const LinearRow row = RowOf(pair, settings.problem.surface, settings.across);
        if (!row.weights.empty()) form.Add(row.weights, row.goal, row.matrix);
    }
    for (const LinearRow& row : settings.more) form.Add(row.weights, row.goal, row.matrix);
    if (fairness > 0) {
        for (Index i = 0; i < settings.fair_rows.n_rows(); ++i) {
            const LinearRow row = FairRowOf(settings.fair_rows, i, fairness);
            if (!row.weights.empty()) form.Add(row.weights, row.goal, row.matrix);
        }
    }
    // Ceres takes ownership.
    auto* const objective = new Objective(settings, form, start);
    const ceres::GradientProblem problem(objective);
    std::vector<double> unknown(start.size());
    ceres::GradientProblemSolver::Options options;
    options.max_num_iterations = 1000;
    options.function_tolerance = 1e-7;
    options.gradient_tolerance = 1e-14;
    options.parameter_tolerance = 1e-9;
    options.logging_type = ceres::SILENT;
    ceres::GradientProblemSolver::Summary summary;
    ceres::Solve(options, problem, unknown.data(), &summary);
    if (!summary.IsSolutionUsable()) throw SolverError("fit: " + summary.message);
    const std::vector<double>& at = objective->Move(unknown.data());
    std::copy(at.begin(), at.end(), control.begin());
    return static_cast<int>(summary.iterations.size()) - 1;
}

}  // namespace SolidSubdiv::Fit::Internal
