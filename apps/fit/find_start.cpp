// SPDX-License-Identifier: Apache-2.0
// Short fits of several starts, side by side.
#include <solidsubdiv/apps/fit/find_start.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <string>
#include <utility>

#include <solidsubdiv/apps/fit/fit.h>
#include <solidsubdiv/sdc/errors.h>
#include <solidsubdiv/sdc/parallel.h>

namespace SolidSubdiv::Fit {

namespace {

constexpr int kMostTried = 16;

/// How far a fit of so many rounds stays away. Where it folds nothing can be said yet, so that it counts for more.
double DistanceOf(const ControlMesh& start, const Sdc::Scheme& scheme, const TargetSurface& target, int n_rounds) {
    constexpr int kRate = 2;
    const Result result = FitControlPoints(MakeProblem(start, scheme, target, kRate),
                                           {.max_rounds = n_rounds, .points_per_control = 6, .is_measured = false});
    return std::hypot(result.rounds.back().surface_rms, result.rounds.back().target_rms) * (1 + result.n_folded);
}

/// The nearest n of those numbered, the nearest first.
std::vector<std::size_t> Nearest(std::size_t n, const std::vector<std::size_t>& numbers,
                                 const std::function<double(std::size_t)>& distance_of) {
    std::vector<std::pair<double, std::size_t>> distances(numbers.size());
    Sdc::ParallelFor(static_cast<Offset>(numbers.size()), 1, [&](Offset begin, Offset end) {
        const Sdc::SerialScope serial;
        for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i) {
            distances[i] = {distance_of(numbers[i]), numbers[i]};
        }
    });
    std::sort(distances.begin(), distances.end());
    std::vector<std::size_t> nearest;
    for (std::size_t i = 0; i < std::min(n, distances.size()); ++i) nearest.push_back(distances[i].second);
    return nearest;
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
    std::vector<std::size_t> left(starts.size());
    std::iota(left.begin(), left.end(), std::size_t{0});
    if (starts.size() > 1) {
        Report(options.progress, "start: trials", .8);
        // A few rounds tell which are no good; which is best only as many as fairness takes to fall.
        constexpr int kFewRounds = 4, kRounds = 32;
        const auto after = [&](int n_rounds) {
            return [&, n_rounds](std::size_t i) {
                return DistanceOf(starts[i], scheme, trial.positions.empty() ? target : trial, n_rounds);
            };
        };
        left = Nearest((starts.size() + 2) / 3, left, after(kFewRounds));
        Report(options.progress, "start: trials", .9);
        left = Nearest(1, left, after(kRounds));
        Report(options.progress, "start: trials", 1);
    }
    const std::size_t best = left.front();
    if (report) *report = reports[best];
    return std::move(starts[best]);
}

}  // namespace SolidSubdiv::Fit
