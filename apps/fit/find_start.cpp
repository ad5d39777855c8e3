// SPDX-License-Identifier: Apache-2.0
// Short fits of several starts, side by side.
#include <solidsubdiv/apps/fit/find_start.h>

#include <algorithm>
#include <cmath>
#include <string>

#include <solidsubdiv/apps/fit/fit.h>
#include <solidsubdiv/sdc/errors.h>
#include <solidsubdiv/sdc/parallel.h>

namespace SolidSubdiv::Fit {

namespace {

constexpr int kMostTried = 16;

/// How far a short fit stays away. Where it folds nothing can be said yet, so that it counts for more.
double DistanceOf(const ControlMesh& start, const Sdc::Scheme& scheme, const TargetSurface& target) {
    constexpr int kRounds = 8, kRate = 2;
    const Result result = FitControlPoints(MakeProblem(start, scheme, target, kRate),
                                           {.max_rounds = kRounds, .points_per_control = 6, .is_measured = false});
    return std::hypot(result.rounds.back().surface_rms, result.rounds.back().target_rms) * (1 + result.n_folded);
}

}  // namespace

ControlMesh FindSolidStart(const TargetSurface& target, const Sdc::Scheme& scheme, const StartOptions& options,
                           StartReport* report, int n_tried, const TargetSurface& trial) {
    if (n_tried < 1 || n_tried > kMostTried) {
        throw InvalidInput("n_tried is " + std::to_string(n_tried) + "; it must be from 1 to " +
                           std::to_string(kMostTried));
    }
    std::vector<StartReport> reports;
    std::vector<ControlMesh> starts = MakeSolidStarts(target, options, n_tried, &reports);
    std::vector<double> distances(starts.size());
    if (starts.size() > 1) {
        Report(options.progress, "start: trials", .8);
        Sdc::ParallelFor(static_cast<Offset>(starts.size()), 1, [&](Offset begin, Offset end) {
            const Sdc::SerialScope serial;
            for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i) {
                distances[i] = DistanceOf(starts[i], scheme, trial.positions.empty() ? target : trial);
            }
        });
        Report(options.progress, "start: trials", 1);
    }
    const auto best =
        static_cast<std::size_t>(std::min_element(distances.begin(), distances.end()) - distances.begin());
    if (report) *report = reports[best];
    return std::move(starts[best]);
}

}  // namespace SolidSubdiv::Fit
