// SPDX-License-Identifier: Apache-2.0
// Rows and corners as functors; Ceres finds their derivatives.
#include "perf/fit_peers.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <thread>

#include <ceres/autodiff_cost_function.h>
#include <ceres/dynamic_autodiff_cost_function.h>
#include <ceres/solver.h>
#include <solidsubdiv/sdc/parallel.h>

namespace SolidSubdiv::Perf {

namespace {

using Fit::Internal::Pair;
using Fit::Internal::StepSettings;

using Row = Fit::Internal::LinearRow;

/// Rows over the control points `points`.
struct RowsFunctor {
    std::vector<std::vector<std::pair<std::size_t, double>>> weights;
    std::vector<std::array<double, 3>> goals;
    std::vector<std::array<double, 9>> matrices;

    template <class T>
    bool operator()(T const* const* p, T* residuals) const {
        for (std::size_t i = 0; i < goals.size(); ++i) {
            T d[3] = {T(-goals[i][0]), T(-goals[i][1]), T(-goals[i][2])};
            for (const auto& [k, w] : weights[i]) {
                for (std::size_t c = 0; c < 3; ++c) d[c] += w * p[k][c];
            }
            const auto& m = matrices[i];
            for (std::size_t r = 0; r < 3; ++r) {
                residuals[3 * i + r] = m[3 * r] * d[0] + m[3 * r + 1] * d[1] + m[3 * r + 2] * d[2];
            }
        }
        return true;
    }
};

/// What Fit::Internal::CornerEnergy is the square of.
struct CornerFunctor {
    double enough, factor;

    template <class T>
    static T OneOverChi(const T& q) {
        constexpr double kSoftness = 0.05;
        return (sqrt(q * q + 4 * kSoftness * kSoftness) - q) / (2 * kSoftness * kSoftness);
    }
    template <class T>
    bool operator()(const T* a, const T* b, const T* c, const T* d, T* residual) const {
        using std::sqrt;
        T e[3], f[3], g[3];
        for (int k = 0; k < 3; ++k) {
            e[k] = b[k] - a[k];
            f[k] = c[k] - a[k];
            g[k] = d[k] - a[k];
        }
        const auto square = [](const T* v) { return v[0] * v[0] + v[1] * v[1] + v[2] * v[2]; };
        const T volume = e[0] * (f[1] * g[2] - f[2] * g[1]) + e[1] * (f[2] * g[0] - f[0] * g[2]) +
                         e[2] * (f[0] * g[1] - f[1] * g[0]);
        const T quality = volume / sqrt(square(e) * square(f) * square(g));
        residual[0] = quality < enough ? T(factor * (OneOverChi(quality) - OneOverChi(enough))) : T(0.0);
        return true;
    }
};

class Builder {
  public:
    explicit Builder(std::span<double> control) : control_(control) {}

    void AddRows(std::span<const Row> rows) {
        std::map<Index, std::size_t> numbers;
        std::vector<double*> parameters;
        auto* const functor = new RowsFunctor;
        for (const Row& row : rows) {
            auto& weights = functor->weights.emplace_back();
            for (const auto& [point, weight] : row.weights) {
                const auto found = numbers.try_emplace(point, numbers.size());
                if (found.second) parameters.push_back(At(point));
                weights.emplace_back(found.first->second, weight);
            }
            functor->goals.push_back(row.goal);
            functor->matrices.push_back(row.matrix);
        }
        auto* const block = new ceres::DynamicAutoDiffCostFunction<RowsFunctor>(functor);
        for (std::size_t i = 0; i < parameters.size(); ++i) block->AddParameterBlock(3);
        block->SetNumResiduals(static_cast<int>(3 * rows.size()));
        problem_.AddResidualBlock(block, nullptr, parameters);
    }
    void AddCorner(const std::array<Index, 4>& v, double enough, double factor) {
        problem_.AddResidualBlock(
            new ceres::AutoDiffCostFunction<CornerFunctor, 1, 3, 3, 3, 3>(new CornerFunctor{enough, factor}), nullptr,
            At(v[0]), At(v[1]), At(v[2]), At(v[3]));
    }
    ceres::Problem& problem() { return problem_; }

  private:
    double* At(Index point) { return &control_[3 * static_cast<std::size_t>(point)]; }

    std::span<double> control_;
    ceres::Problem problem_;
};

void AddPairs(Blocks blocks, const StepSettings& settings, std::span<const Pair> pairs, Builder& builder) {
    constexpr std::size_t kRowsOfBlock = 256;
    std::map<Index, std::vector<Row>> groups;
    for (const Pair& pair : pairs) {
        const Row row = RowOf(pair, settings.problem.surface, settings.across);
        if (row.weights.empty()) continue;
        const auto lighter = [](const auto& a, const auto& b) { return a.second < b.second; };
        auto& rows = groups[std::max_element(row.weights.begin(), row.weights.end(), lighter)->first];
        rows.push_back(row);
        if (blocks == Blocks::Grouped && rows.size() < kRowsOfBlock) continue;
        builder.AddRows(rows);
        rows.clear();
    }
    for (const auto& group : groups) {
        if (!group.second.empty()) builder.AddRows(group.second);
    }
}

}  // namespace

void SolveByAutoDiff(Blocks blocks, const StepSettings& settings, std::span<const Pair> pairs, double fairness,
                     std::span<double> control) {
    Builder builder(control);
    AddPairs(blocks, settings, pairs, builder);
    for (Index i = 0; i < settings.fair_rows.n_rows(); ++i) {
        const Row row = Fit::Internal::FairRowOf(settings.fair_rows, i, fairness);
        if (!row.weights.empty()) builder.AddRows(std::span(&row, 1));
    }
    for (std::size_t i = 0; i < settings.problem.corners.size(); ++i) {
        builder.AddCorner(settings.problem.corners[i], settings.enough[i], std::sqrt(settings.barrier));
    }
    SolveByTrustRegion(builder.problem(), control.size(), settings.problem.corners.empty() ? 1e10 : 1e4);
}

void SolveByTrustRegion(ceres::Problem& problem, std::size_t n_unknowns, double trust_radius) {
    ceres::Solver::Options options;
    options.linear_solver_type = n_unknowns <= 3 * 400 ? ceres::SPARSE_NORMAL_CHOLESKY : ceres::CGNR;
    options.preconditioner_type = ceres::JACOBI;
    options.max_num_iterations = 40;
    options.function_tolerance = 1e-6;
    options.initial_trust_region_radius = trust_radius;
    options.num_threads = std::min(Sdc::ThreadCount(), static_cast<int>(std::thread::hardware_concurrency()));
    options.logging_type = ceres::SILENT;
    ceres::Solver::Summary summary;
    ceres::Solve(options, &problem, &summary);
}

}  // namespace SolidSubdiv::Perf
