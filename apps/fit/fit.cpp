// SPDX-License-Identifier: Apache-2.0
// Rounds of pairs and steps, in coordinates in which the target's diagonal is 1.
#include <solidsubdiv/apps/fit/fit.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>

#include <solidsubdiv/apps/fit/internal/cell_volumes.h>
#include <solidsubdiv/apps/fit/internal/corner_shapes.h>
#include <solidsubdiv/apps/fit/internal/fairness.h>
#include <solidsubdiv/apps/fit/internal/more_rows.h>
#include <solidsubdiv/apps/fit/internal/pairs.h>
#include <solidsubdiv/apps/fit/internal/step.h>
#include <solidsubdiv/kit/geometry/box.h>
#include <solidsubdiv/sdc/errors.h>

namespace SolidSubdiv::Fit {

using namespace Internal;

namespace {

/// To coordinates around the middle of what is to be met, and back.
struct Frame {
    std::array<double, 3> middle{};
    double size = 1;

    std::vector<double> To(std::span<const double> positions) const {
        std::vector<double> result(positions.begin(), positions.end());
        for (std::size_t i = 0; i < result.size(); ++i) result[i] = (result[i] - middle[i % 3]) / size;
        return result;
    }
    std::vector<double> From(std::span<const double> positions) const {
        std::vector<double> result(positions.begin(), positions.end());
        for (std::size_t i = 0; i < result.size(); ++i) result[i] = result[i] * size + middle[i % 3];
        return result;
    }
};

Frame FrameOf(std::span<const double> positions) {
    const Geometry::Box box = Geometry::BoundingBox(positions);
    Frame frame;
    for (std::size_t c = 0; c < 3; ++c) frame.middle[c] = 0.5 * (box.low[c] + box.high[c]);
    if (box.Diagonal() > 0) frame.size = box.Diagonal();
    return frame;
}

int CountFolded(std::span<const std::array<Index, 4>> corners, std::span<const double> control) {
    return static_cast<int>(std::count_if(corners.begin(), corners.end(),
                                          [&](const auto& corner) { return !(CornerVolume(corner, control) > 0); }));
}

/// Scaled Jacobians at which corners are well shaped enough: half of that of the start, so that affine maps that shear
/// less are none of the barrier's business.
std::vector<double> EnoughOf(const Problem& problem) {
    constexpr double kPart = 0.5, kLeast = 0.05, kMost = 0.5;
    std::vector<double> enough;
    for (const auto& corner : problem.corners) {
        enough.push_back(std::clamp(kPart * CornerQuality(corner, problem.control), kLeast, kMost));
    }
    return enough;
}

double RmsOf(std::span<const Pair> pairs) {
    double sum = 0, weight = 0;
    for (const Pair& p : pairs) {
        sum += p.weight * p.distance * p.distance;
        weight += p.weight;
    }
    return weight > 0 ? std::sqrt(sum / weight) : 0;
}

/// Each of a mirrored pair becomes the mean of itself and the other's image.
void Mirror(const Problem& problem, std::vector<double>& control) {
    const auto axis = static_cast<std::size_t>(problem.mirror_axis);
    for (const auto& pair : problem.mirrored) {
        double* const a = &control[3 * static_cast<std::size_t>(pair[0])];
        double* const b = &control[3 * static_cast<std::size_t>(pair[1])];
        for (std::size_t c = 0; c < 3; ++c) {
            const double image = c == axis ? 2 * problem.mirror_offset - b[c] : b[c];
            const double mean = 0.5 * (a[c] + image);
            a[c] = mean;
            b[c] = c == axis ? 2 * problem.mirror_offset - mean : mean;
        }
    }
}

std::vector<double> DistancesOf(std::span<const double> points, const Geometry::ClosestPoints& to) {
    std::vector<double> distances;
    for (const Geometry::ClosestPoint& p : to.Find(points)) distances.push_back(p.distance);
    return distances;
}

/// Of the last round, for those who watch.
std::string ErrorText(std::span<const Round> rounds, double diagonal) {
    if (rounds.empty()) return {};
    char text[64];
    std::snprintf(text, sizeof text, ", RMS %.3g %% of the diagonal",
                  100 * std::max(rounds.back().surface_rms, rounds.back().target_rms) / diagonal);
    return text;
}

void RequireRange(const char* name, double value, double least, double most) {
    if (!(value >= least && value <= most)) {
        throw InvalidInput(std::string("fit: ") + name + " is " + std::to_string(value) + "; it must be from " +
                           std::to_string(least) + " to " + std::to_string(most));
    }
}

}  // namespace

void Options::Validate() const {
    RequireRange("max_rounds", max_rounds, 1, 10000);
    RequireRange("fairness", fairness, 0, 1e12);
    RequireRange("least_fairness", least_fairness, 0, 1e12);
    RequireRange("barrier", barrier, 0, 1e12);
    RequireRange("across", across, 0, 1);
    RequireRange("normals", normals, 0, 1e12);
    RequireRange("spring", spring, 0, 1e12);
    RequireRange("robust", robust, 0, 1e6);
    RequireRange("points_per_control", points_per_control, 1, 1e6);
    RequireRange("tolerance", tolerance, 0, 1e75);
    RequireRange("least_change", least_change, 0, 1);
}

void Measure(const Problem& problem, Result& result) {
    const MovingSurface& surface = problem.fine.triangles.empty() ? problem.surface : problem.fine;
    const TargetSurface& target = problem.target;
    result.vertices = surface.Positions(result.control);
    if (target.positions.empty()) return;
    const Geometry::ClosestPoints on_target(target.positions, target.triangles);
    const Geometry::ClosestPoints on_surface(result.vertices, surface.triangles);
    const Coverage coverage(target);
    const auto is_over_hole = [&](const Geometry::ClosestPoint& nearest, const std::array<double, 3>& p,
                                  Index triangle) {
        const TargetSurface own{.positions = result.vertices, .triangles = surface.triangles};
        return !coverage.Covers(nearest, {p[0], p[1], p[2]}, NormalOf(own, triangle));
    };
    result.to_target = MeasureDistance(result.vertices, surface.triangles, on_target, {.is_left_out = is_over_hole});
    result.from_target = MeasureDistance(target.positions, target.triangles, on_surface);
    const auto nearest = on_target.Find(result.vertices);
    for (const Geometry::ClosestPoint& p : nearest) result.to_target_distances.push_back(p.distance);
    result.normal_rms = NormalRms(result.vertices, surface.triangles, target, nearest);
    result.from_target_distances = DistancesOf(target.positions, on_surface);
}

Result FitControlPoints(const Problem& problem, const Options& options) {
    options.Validate();
    problem.Validate();
    if (options.normals > 0 && problem.surface.tangent_vertices.empty()) {
        throw InvalidInput("fit: normals is " + std::to_string(options.normals) +
                           ", but the surface has no tangents (MakeProblem, with_tangents)");
    }
    const Frame frame = FrameOf(problem.partners.empty() ? problem.target.positions : problem.partners);
    const std::vector<double> target = frame.To(problem.target.positions);
    Problem scaled = problem;
    scaled.target.positions = target;
    scaled.control = frame.To(problem.control);
    scaled.partners = frame.To(problem.partners);
    scaled.mirror_offset =
        (problem.mirror_offset - frame.middle[static_cast<std::size_t>(problem.mirror_axis)]) / frame.size;

    const Far::StencilRows<double> fair_rows = AffineRows(scaled.control, scaled.neighbors);
    const Offset most_points = static_cast<Offset>(problem.control.size() / 3) * options.points_per_control;
    // On the way corners are kept as good as can be; in the end they only must not get flat.
    const std::vector<double> enough = EnoughOf(scaled), best(enough.size(), 1.0);
    const PairFinder finder(scaled, most_points);
    StepSettings settings{scaled, fair_rows, best, options.barrier, options.across};
    std::vector<LinearRow> springs;
    if (options.spring > 0) AddSpringRows(scaled.neighbors, options.spring, springs);

    Result result;
    std::vector<double>& control = scaled.control;
    double fairness = options.fairness, last_error = HUGE_VAL;
    bool was_least_fair = false;
    result.stopped = "rounds";
    try {
        for (int i = 0; i < options.max_rounds; ++i) {
            Report(options.progress, "fit" + ErrorText(result.rounds, frame.size),
                   static_cast<double>(i) / options.max_rounds);
            const auto start = std::chrono::steady_clock::now();
            Round round{.fairness = fairness};
            Index n_of_surface = 0;
            // Parts that the start lacks are as far as outliers: these are told apart later, while fairness falls.
            const double widening = options.least_fairness > 0 ? std::sqrt(fairness / options.least_fairness) : 1;
            const std::vector<Pair> pairs =
                finder.Find(scaled.surface.Positions(control), options.robust * std::max(1.0, widening), n_of_surface);
            const auto [of_surface, of_target] = [&] {
                const auto n = static_cast<std::size_t>(n_of_surface);
                return std::pair(std::span(pairs).first(n), std::span(pairs).subspan(n));
            }();
            if (pairs.empty())
                throw InvalidInput("fit: the surface and the target look away from each other everywhere");
            round.surface_rms = frame.size * RmsOf(of_surface);
            round.target_rms = frame.size * RmsOf(of_target);
            const double error = std::hypot(round.surface_rms, round.target_rms);
            const bool is_least_fair = fairness <= options.least_fairness;
            if (options.tolerance > 0 && std::max(round.surface_rms, round.target_rms) <= options.tolerance) {
                result.stopped = "tolerance";
            } else if (was_least_fair && std::abs(last_error - error) <= options.least_change * error) {
                if (settings.barrier > 0 && CountFolded(scaled.corners, control) > 0) {
                    settings.barrier *= 10;
                } else {
                    result.stopped = "change";
                }
            }
            if (is_least_fair) settings.enough = enough;
            was_least_fair = is_least_fair;
            if (result.stopped == "rounds") {
                std::vector<LinearRow> more = springs;
                if (options.normals > 0) {
                    // Directions are worth something once places are about right: before, they keep parts from turning.
                    const double part = std::max(1.0, widening * widening);
                    AddTangentRows(scaled.surface, of_surface, control, options.normals / part, more);
                }
                settings.more = more;
                round.steps = SolveStep(settings, pairs, fairness, control);
                Mirror(scaled, control);
            }
            round.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
            result.rounds.push_back(round);
            if (result.stopped != "rounds") break;
            last_error = error;
            fairness = std::max(options.least_fairness, fairness / 2);
        }
    } catch (const Cancelled&) {
        result.stopped = "cancelled";
    }
    result.control = frame.From(control);
    for (Index p : problem.locked) {
        std::copy_n(&problem.control[3 * static_cast<std::size_t>(p)], 3,
                    &result.control[3 * static_cast<std::size_t>(p)]);
    }
    result.n_folded = CountFolded(scaled.corners, control);
    if (options.is_measured) Measure(problem, result);
    return result;
}

}  // namespace SolidSubdiv::Fit
