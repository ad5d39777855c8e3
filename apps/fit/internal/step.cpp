// SPDX-License-Identifier: Apache-2.0
// Rows are grouped by the control point that weighs most in them: blocks of many rows take a hundredth of the time of
// blocks of one (docs/fitting.md).
#include <solidsubdiv/apps/fit/internal/step.h>

#include <algorithm>
#include <cmath>
#include <map>

#include <ceres/problem.h>
#include <ceres/solver.h>

#include <solidsubdiv/apps/fit/internal/smooth_step.h>
#include <solidsubdiv/sdc/errors.h>

namespace SolidSubdiv::Fit::Internal {

namespace {

constexpr std::size_t kRowsOfBlock = 256;

Index HeaviestOf(const LinearBlock::Row& row) {
    return std::max_element(row.weights.begin(), row.weights.end(),
                            [](const auto& a, const auto& b) { return std::abs(a.second) < std::abs(b.second); })
        ->first;
}

class Builder {
  public:
    explicit Builder(std::span<double> control) : control_(control) {}

    template <class Block>
    void Add(Block* block) {
        std::vector<double*> parameters;
        for (Index p : block->control_points()) parameters.push_back(&control_[3 * static_cast<std::size_t>(p)]);
        problem_.AddResidualBlock(block, nullptr, parameters);
    }
    void Lock(Index point) {
        double* const p = &control_[3 * static_cast<std::size_t>(point)];
        if (problem_.HasParameterBlock(p)) problem_.SetParameterBlockConstant(p);
    }
    ceres::Problem& problem() { return problem_; }

  private:
    std::span<double> control_;
    ceres::Problem problem_;
};

void AddRows(const StepSettings& settings, std::span<const Pair> pairs, Builder& builder) {
    std::map<Index, std::vector<LinearBlock::Row>> groups;
    const auto add = [&](std::vector<LinearBlock::Row>& rows) {
        builder.Add(new LinearBlock(rows));
        rows.clear();
    };
    const auto put = [&](const LinearBlock::Row& row) {
        if (row.weights.empty()) return;
        auto& rows = groups[HeaviestOf(row)];
        rows.push_back(row);
        if (rows.size() == kRowsOfBlock) add(rows);
    };
    for (const Pair& pair : pairs) put(RowOf(pair, settings.problem.surface, settings.across));
    for (const LinearBlock::Row& row : settings.more) put(row);
    for (auto& group : groups) {
        if (!group.second.empty()) add(group.second);
    }
}

void AddFairness(const StepSettings& settings, double fairness, Builder& builder) {
    const auto& rows = settings.fair_rows;
    for (Index i = 0; i < rows.n_rows(); ++i) {
        const LinearBlock::Row row = FairRowOf(rows, i, fairness);
        if (!row.weights.empty()) builder.Add(new LinearBlock(std::span(&row, 1)));
    }
}

}  // namespace

LinearBlock::Row RowOf(const Pair& pair, const MovingSurface& surface, double across) {
    std::map<Index, double> weights;
    for (std::size_t k = 0; k < 3; ++k) {
        if (pair.weights[k] == 0) continue;
        const auto indices = surface.rows.Indices(pair.vertices[k]);
        const auto row = surface.rows.Weights(pair.vertices[k]);
        for (std::size_t i = 0; i < indices.size(); ++i) weights[indices[i]] += pair.weights[k] * row[i];
    }
    LinearBlock::Row row{.weights = {weights.begin(), weights.end()},
                         .goal = {pair.partner.x, pair.partner.y, pair.partner.z}};
    const Vec3& n = pair.normal;
    const bool has_normal = Dot(n, n) > 0;
    const double root = std::sqrt(has_normal ? across : 1.0);
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            row.matrix[3 * i + j] = std::sqrt(pair.weight) * ((i == j ? root : 0.0) + (1 - root) * n[i] * n[j]);
        }
    }
    return row;
}

LinearBlock::Row FairRowOf(const Far::StencilRows<double>& fair_rows, Index point, double fairness) {
    const auto indices = fair_rows.Indices(point);
    const auto weights = fair_rows.Weights(point);
    if (indices.empty()) return {};
    const double root = std::sqrt(fairness / fair_rows.n_rows());
    LinearBlock::Row row{.weights = {{point, 1.0}}, .matrix = {root, 0, 0, 0, root, 0, 0, 0, root}};
    for (std::size_t k = 0; k < indices.size(); ++k) row.weights.emplace_back(indices[k], -weights[k]);
    return row;
}

StepReport SolveStep(const StepSettings& settings, std::span<const Pair> pairs, double fairness,
                     std::span<double> control) {
    if (settings.barrier > 0 && !settings.problem.corners.empty())
        return SolveSmoothStep(settings, pairs, fairness, control);
    Builder builder(control);
    AddRows(settings, pairs, builder);
    if (fairness > 0) AddFairness(settings, fairness, builder);
    for (Index p : settings.problem.locked) builder.Lock(p);

    ceres::Solver::Options options;
    // A direct solver is exact and quick for small problems; conjugate gradients win above (docs/fitting.md).
    constexpr std::size_t kMostOfDirect = 3 * 400;
    options.linear_solver_type = control.size() <= kMostOfDirect ? ceres::SPARSE_NORMAL_CHOLESKY : ceres::CGNR;
    options.preconditioner_type = ceres::JACOBI;
    options.max_num_iterations = 40;
    options.function_tolerance = 1e-6;
    options.initial_trust_region_radius = 1e10;  // all is linear: the first step is the answer
    // Ceres sums in the order in which its threads come. More of them are a fifth faster, and never twice the same.
    options.num_threads = 1;
    options.logging_type = ceres::SILENT;
    ceres::Solver::Summary summary;
    ceres::Solve(options, &builder.problem(), &summary);
    if (!summary.IsSolutionUsable()) throw SolverError("fit: " + summary.message);
    return {summary.num_successful_steps, ceres::LinearSolverTypeToString(summary.linear_solver_type_used)};
}

}  // namespace SolidSubdiv::Fit::Internal
