// SPDX-License-Identifier: Apache-2.0
// Validators fit-affine and fit-affine-lattice: fairness has nothing against affine maps, and lattices carry models to
// affine images.
#include <cmath>

#include <solidsubdiv/apps/fit/internal/fairness.h>

#include "fit_known_answers.h"
#include "points.h"
#include "validators.h"

namespace SolidSubdiv::Validation {

namespace {

std::vector<double> AffineImage(std::vector<double> positions) {
    for (std::size_t i = 0; i < positions.size(); i += 3) {
        const double x = positions[i], y = positions[i + 1], z = positions[i + 2];
        positions[i] = 1.1 * x + 0.1 * y + 0.05;
        positions[i + 1] = 0.9 * y - 0.2 * z;
        positions[i + 2] = z - 0.1 * x + 0.3;
    }
    return positions;
}

/// The largest of what fair rows leave, over the size.
double LargestGap(const Far::StencilRows<double>& rows, const std::vector<double>& positions, Findings* findings) {
    const std::vector<double> sums = Apply(rows, positions);
    const double size = SizeOf(positions);
    double largest = 0;
    for (Index i = 0; i < rows.n_rows(); ++i) {
        if (rows.Indices(i).empty()) continue;
        for (std::size_t c = 0; c < 3; ++c) {
            const std::size_t k = 3 * static_cast<std::size_t>(i) + c;
            const double gap = std::abs(sums[k] - positions[k]) / size;
            largest = std::max(largest, gap);
            if (findings) findings->Error(gap, [&] { return "fairness at control point " + std::to_string(i); });
        }
    }
    return largest;
}

}  // namespace

void CompareFairness(const Far::StencilRows<double>& rows, const std::vector<double>& positions, Findings& findings) {
    std::vector<double> moved = AffineImage(positions);
    LargestGap(rows, moved, &findings);
    Shake(moved, 1e-3 * SizeOf(moved), 1);
    if (!(LargestGap(rows, moved, nullptr) > 1e-4)) findings.Fault("fairness does not see points that are shaken");
}

void CheckFairness(const FitCase& fit_case, Findings& findings) {
    const Fit::Problem problem = Fit::MakeProblem(fit_case.mesh, fit_case.scheme, {}, 1);
    CompareFairness(Fit::Internal::AffineRows(problem.control, problem.neighbors), problem.control, findings);
}

void ComparePoints(const std::vector<double>& found, const std::vector<double>& wanted, Findings& findings) {
    const double size = SizeOf(wanted);
    for (std::size_t i = 0; i < found.size(); ++i) {
        findings.Error(std::abs(found[i] - wanted[i]) / size, [&] { return "point " + std::to_string(i / 3); });
    }
}

void CheckAffineLattice(const FitTarget& model, const Sdc::Scheme& scheme, Findings& findings) {
    const std::vector<double> image = AffineImage(model.positions);
    const Fit::ControlMesh lattice = Fit::MakeBoxLattice(model.positions, 200);
    Fit::Problem problem = MakeLatticeProblem(lattice, scheme, model.View(), {});
    problem.partners = image;
    // Fairness as high as it ever is: it must not be in the way.
    const Fit::Result result = FitControlPoints(
        problem, {.max_rounds = 20, .fairness = 1, .least_fairness = 1, .barrier = 0, .least_change = 0});
    ComparePoints(problem.surface.Positions(result.control), image, findings);
}

Findings ValidateFitAffine(const Context& context) {
    Findings findings;
    const FitTarget ball = MakeFitBall(8);
    for (const FitCase& c : FitCasesAround(ball.View(), context.is_quick ? 64 : 100)) {
        Findings found;
        CheckFairness(c, found);
        findings.Merge(found, c.name);
    }
    return findings;
}

Findings ValidateFitAffineLattice(const Context&) {
    Findings findings;
    const FitTarget ball = MakeFitBall(8);
    for (const Sdc::Scheme& scheme : {Sdc::Scheme(Sdc::CatmullClarkSolid{}), Sdc::Scheme(Sdc::LinearSolid{})}) {
        Findings found;
        CheckAffineLattice(ball, scheme, found);
        findings.Merge(found, std::string(Sdc::NameOf(scheme)));
    }
    return findings;
}

}  // namespace SolidSubdiv::Validation
