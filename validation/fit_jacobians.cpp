// SPDX-License-Identifier: Apache-2.0
// Validator fit-jacobians: derivatives of all that real rounds minimize against central differences.
#include "fit_jacobians.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <solidsubdiv/apps/fit/internal/corner_shapes.h>
#include <solidsubdiv/apps/fit/internal/fairness.h>
#include <solidsubdiv/apps/fit/internal/normal_equations.h>
#include <solidsubdiv/apps/fit/internal/rows.h>
#include <solidsubdiv/apps/fit/internal/step.h>

#include "fit_shapes.h"
#include "points.h"
#include "validators.h"

namespace SolidSubdiv::Validation {

namespace {

constexpr Offset kAllPoints = 1'000'000'000;

}  // namespace

void CompareSlope(const std::function<double(std::span<const double>, std::span<double>)>& energy,
                  std::span<const double> at, const std::string& what, Findings& findings) {
    std::vector<double> x(at.begin(), at.end()), slope(at.size());
    energy(x, slope);
    double largest = 1e-300;
    for (double s : slope) largest = std::max(largest, std::abs(s));
    constexpr double kStep = 1e-6;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double middle = x[i];
        x[i] = middle + kStep;
        const double above = energy(x, {});
        x[i] = middle - kStep;
        const double below = energy(x, {});
        x[i] = middle;
        findings.Error(std::abs((above - below) / (2 * kStep) - slope[i]) / largest,
                       [&] { return what + ", control point " + std::to_string(i / 3); });
    }
}

void CheckJacobians(const Fit::Problem& problem, double robust, Findings& findings) {
    using namespace Fit::Internal;
    const auto fair_rows = AffineRows(problem.control, problem.neighbors);
    Index n_of_surface = 0;
    const auto pairs =
        PairFinder(problem, kAllPoints).Find(problem.surface.Positions(problem.control), robust, n_of_surface);
    std::vector<LinearRow> rows;
    for (const Pair& pair : pairs) rows.push_back(RowOf(pair, problem.surface, 1e-3));
    for (Index i = 0; i < fair_rows.n_rows(); ++i) {
        LinearRow row = FairRowOf(fair_rows, i, 0.7);
        if (!row.weights.empty()) rows.push_back(std::move(row));
    }
    if (n_of_surface == 0) findings.Fault("no rows of the surface's vertices");
    if (rows.size() == pairs.size()) findings.Fault("no fair rows");
    if (problem.partners.empty() && static_cast<std::size_t>(n_of_surface) == pairs.size()) {
        findings.Fault("no rows of the target's points");
    }
    NormalEquations form(problem.control);
    double half_sum = 0;
    for (const LinearRow& row : rows) {
        form.Add(row.weights, row.goal, row.matrix);
        for (double r : row.Residuals(problem.control)) half_sum += 0.5 * r * r;
    }
    const std::vector<double> nowhere(problem.control.size());
    findings.Error(std::abs(form.Evaluate(nowhere, {}) - half_sum) / half_sum, [] { return "the sum of squares"; });
    CompareSlope([&](auto moved, auto slope) { return form.Evaluate(moved, slope); }, nowhere, "the sum of squares",
                 findings);

    // Half of the corners are better than is asked for.
    std::vector<double> enough;
    for (const auto& corner : problem.corners) {
        enough.push_back(CornerQuality(corner, problem.control) + (enough.size() % 2 == 0 ? 0.2 : -0.2));
    }
    if (problem.corners.empty()) return;
    if (problem.corners.size() < 2) findings.Fault("the barrier stands nowhere or everywhere");
    constexpr double kSoftness = 0.3, kFactor = 0.7;
    const auto barrier = [&](std::span<const double> at, std::span<double> slope) {
        return kFactor * CornerEnergy(problem.corners, enough, at, kSoftness, kFactor, slope);
    };
    CompareSlope(barrier, problem.control, "barrier", findings);
}

Findings ValidateFitJacobians(const Context& context) {
    Findings findings;
    FitTarget target = context.is_quick ? MakeFitBall(8) : ReadFitBunny(context.shapes);
    const double size = SizeOf(target.positions);
    for (double& x : target.positions) x /= size;
    const auto cases = FitCasesAround(target.View(), 64);
    for (const FitCase& c : cases) {
        Fit::Problem problem = Fit::MakeProblem(c.mesh, c.scheme, target.View(), 2);
        Shake(problem.control, 0.01, 1);
        const auto check = [&](const std::string& what, const Fit::Problem& p, double robust) {
            Findings found;
            CheckJacobians(p, robust, found);
            findings.Merge(found, c.name + ", " + what);
        };
        check("nearest points", problem, 2);
        Fit::Problem points = problem;  // without normals
        points.target.triangles = {};
        check("points alone", points, 0);
        problem.partners = problem.surface.Positions(c.mesh.positions);
        check("partners", problem, 0);
    }
    return findings;
}

}  // namespace SolidSubdiv::Validation
