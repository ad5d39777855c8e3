// SPDX-License-Identifier: Apache-2.0
// Validator fit-distances: the largest distances of fits from their targets, and back, against CGAL's.
#include "fit_distances.h"

#include <algorithm>
#include <cmath>

#include <solidsubdiv/kit/geometry/surface_distance.h>

#include "hausdorff_oracle.h"
#include "points.h"
#include "validators.h"

namespace SolidSubdiv::Validation {

namespace {

double AreaOf(const FitTarget& surface) {
    double area = 0;
    for (std::size_t t = 0; t < surface.triangles.size(); t += 3) {
        std::array<double, 3> e{}, f{};
        for (std::size_t c = 0; c < 3; ++c) {
            const auto at = [&](std::size_t k) {
                return surface.positions[3 * static_cast<std::size_t>(surface.triangles[t + k]) + c];
            };
            e[c] = at(1) - at(0);
            f[c] = at(2) - at(0);
        }
        area += 0.5 * std::hypot(e[1] * f[2] - e[2] * f[1], e[2] * f[0] - e[0] * f[2], e[0] * f[1] - e[1] * f[0]);
    }
    return area;
}

}  // namespace

void CompareMost(double ours, double theirs, double bound, double gap, double size, Findings& findings) {
    findings.Error(std::max(0.0, ours - theirs - bound) / size, [] { return "ours is larger"; });
    findings.Error(std::max(0.0, theirs - bound - ours - gap) / size, [] { return "ours is smaller"; });
}

void CheckDistance(const FitTarget& from, const FitTarget& to, Findings& findings) {
    const double size = SizeOf(to.positions), bound = 1e-4 * size;
    const auto summary =
        Geometry::MeasureDistance(from.positions, from.triangles, Geometry::ClosestPoints(to.positions, to.triangles));
    const double theirs = HausdorffDistance(from.positions, from.triangles, to.positions, to.triangles, bound);
    // Points that are spread by area lie about a square's side apart; none of it is two sides from the next.
    const double gap = 2 * std::sqrt(AreaOf(from) / static_cast<double>(summary.n_points));
    CompareMost(summary.most, theirs, bound, gap, size, findings);
    findings.notes.push_back("ours " + std::to_string(100 * summary.most / size) + " %, CGAL's " +
                             std::to_string(100 * theirs / size) + " % of the diagonal");
}

Findings ValidateFitDistances(const Context& context) {
    Findings findings;
    const FitTarget target = ReadFitBunny(context.shapes);
    for (const FitCase& c : FitCasesAround(target.View(), context.is_quick ? 64 : 100)) {
        Fit::Problem problem = Fit::MakeProblem(c.mesh, c.scheme, target.View(), 3);
        problem.control = FitControlPoints(problem, {.max_rounds = 2}).control;
        const FitTarget fitted = FitSurface(problem);
        for (const bool is_back : {false, true}) {
            Findings found;
            CheckDistance(is_back ? target : fitted, is_back ? fitted : target, found);
            findings.Merge(found, c.name + (is_back ? ", from the target" : ", to the target"));
        }
    }
    return findings;
}

}  // namespace SolidSubdiv::Validation
