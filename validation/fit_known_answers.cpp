// SPDX-License-Identifier: Apache-2.0
// Validators fit-known-partners and fit-free-partners: what was made from control points is found again.
#include "fit_known_answers.h"

#include <algorithm>
#include <cmath>

#include "points.h"
#include "validators.h"

namespace SolidSubdiv::Validation {

namespace {

std::vector<FitCase> Cases(const Context& context) {
    std::vector<FitCase> cases = FitCasesAround(MakeFitBall(8).View(), context.is_quick ? 64 : 100);
    FitCase butterfly = cases[2];
    butterfly.name += ", modified butterfly";
    butterfly.scheme = Sdc::ModifiedButterfly{};
    cases.push_back(butterfly);
    return cases;
}

void CheckAll(const Context& context, void (*check)(const FitCase&, Findings&), Findings& findings) {
    for (const FitCase& c : Cases(context)) {
        Findings found;
        check(c, found);
        findings.Merge(found, c.name);
    }
}

}  // namespace

void CompareSeen(const Fit::Problem& problem, const std::vector<double>& found, const std::vector<double>& wanted,
                 Findings& findings) {
    std::vector<bool> is_seen(wanted.size() / 3);
    const auto& rows = problem.surface.rows;
    for (std::size_t k = 0; k < rows.indices.size(); ++k) {
        if (rows.weights[k] != 0) is_seen[static_cast<std::size_t>(rows.indices[k])] = true;
    }
    const double size = SizeOf(wanted);
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        if (!is_seen[i / 3]) continue;
        findings.Error(std::abs(found[i] - wanted[i]) / size, [&] { return "control point " + std::to_string(i / 3); });
    }
}

void CompareRounds(const std::vector<Fit::Round>& rounds, double diagonal, Findings& findings) {
    const auto place = [&] { return "round " + std::to_string(rounds.size()); };
    findings.Error(rounds.back().surface_rms / diagonal, place);
    findings.Error(rounds.back().target_rms / diagonal, place);
    findings.notes.push_back(std::to_string(rounds.size()) + " rounds");
    if (!(rounds.front().surface_rms > 1e-4 * diagonal)) findings.Fault("the start is the answer already");
}

void CheckKnownPartners(const FitCase& fit_case, Findings& findings) {
    Fit::Problem problem = Fit::MakeProblem(fit_case.mesh, fit_case.scheme, {}, 4);
    problem.partners = problem.surface.Positions(problem.control);
    const std::vector<double> wanted = problem.control;
    Shake(problem.control, 0.05 * SizeOf(wanted), 1);
    const Fit::Result result = FitControlPoints(
        problem, {.max_rounds = 30, .fairness = 0, .least_fairness = 0, .barrier = 0, .least_change = 0});
    CompareSeen(problem, result.control, wanted, findings);
}

void CheckFreePartners(const FitCase& fit_case, Findings& findings) {
    Fit::Problem problem = Fit::MakeProblem(fit_case.mesh, fit_case.scheme, {}, 4);
    const FitTarget target = FitSurface(problem);
    problem.target = target.View();
    const double diagonal = SizeOf(target.positions);
    Shake(problem.control, 0.01 * diagonal, 2);
    const Fit::Result result = FitControlPoints(problem, {.max_rounds = 200,
                                                          .fairness = 1e-6,
                                                          .least_fairness = 0,
                                                          .barrier = 0,
                                                          .tolerance = 9e-7 * diagonal,
                                                          .least_change = 0});
    CompareRounds(result.rounds, diagonal, findings);
}

Findings ValidateFitKnownPartners(const Context& context) {
    Findings findings;
    CheckAll(context, CheckKnownPartners, findings);
    return findings;
}

Findings ValidateFitFreePartners(const Context& context) {
    Findings findings;
    CheckAll(context, CheckFreePartners, findings);
    return findings;
}

}  // namespace SolidSubdiv::Validation
