// SPDX-License-Identifier: Apache-2.0
// The race of fitting: rounds of fits to the scan that the repository carries, by our rows in blocks, by machine
// derivatives, and by OpenSubdiv's limit stencils; and what limit points are worth beside those of the control mesh.
#include <cstdio>
#include <memory>

#include <solidsubdiv/apps/fit/internal/fairness.h>
#include <solidsubdiv/apps/fit/start.h>
#include <solidsubdiv/kit/geometry/box.h>
#include <solidsubdiv/kit/io/formats.h>
#include <solidsubdiv/sdc/parallel.h>

#include "perf/fit_peers.h"
#include "perf/machine.h"
#include "perf/open_subdiv_fit.h"
#include "perf/races.h"

namespace SolidSubdiv::Perf {

namespace {

using Fit::Internal::Pair;
using Solve = std::function<void(const Fit::Internal::StepSettings&, std::span<const Pair>, double, std::span<double>)>;

const Solve kOurs = [](const auto& settings, auto pairs, double fairness, auto control) {
    Fit::Internal::SolveStep(settings, pairs, fairness, control);
};
const Solve kOneARow = [](const auto& settings, auto pairs, double fairness, auto control) {
    SolveByAutoDiff(Blocks::OneARow, settings, pairs, fairness, control);
};
const Solve kGrouped = [](const auto& settings, auto pairs, double fairness, auto control) {
    SolveByAutoDiff(Blocks::Grouped, settings, pairs, fairness, control);
};

/// A problem with what rounds need.
struct FitRace {
    std::string name;
    Fit::Problem problem;
    Far::StencilRows<double> fair_rows{};
    std::vector<double> enough{};

    FitRace(std::string what, Fit::Problem of) : name(std::move(what)), problem(std::move(of)) {
        fair_rows = Fit::Internal::AffineRows(problem.control, problem.neighbors);
        enough.assign(problem.corners.size(), 1.0);
    }
    FitRace(const FitRace&) = delete;

    /// From the start on. @return the control points
    std::vector<double> Rounds(int n, const Solve& solve) const {
        const Fit::Options options;
        const Fit::Internal::StepSettings settings{problem, fair_rows, enough, options.barrier, options.across};
        const Fit::Internal::PairFinder finder(problem, static_cast<Offset>(problem.target.positions.size()));
        std::vector<double> control = problem.control;
        double fairness = options.fairness;
        for (int i = 0; i < n; ++i) {
            Index n_of_surface = 0;
            const auto pairs = finder.Find(problem.surface.Positions(control), 0, n_of_surface);
            solve(settings, pairs, fairness, control);
            fairness = std::max(options.least_fairness, fairness / 2);
        }
        return control;
    }
    /// Of the limit from the target, in percent of the diagonal, which is 1.
    double Rms(std::span<const double> control) const {
        const Geometry::ClosestPoints target(problem.target.positions, problem.target.triangles);
        return 100 * MeasureDistance(problem.fine.Positions(control), problem.fine.triangles, target).rms;
    }
};

std::string Percent(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.4f %%", value);
    return text;
}

/// @param more a peer of this race alone
void AddRace(Race& race, const RaceSettings& settings, const std::shared_ptr<FitRace>& s, int n_rounds,
             const std::pair<std::string, Solve>& more) {
    const std::string rounds = s->name + ", after " + std::to_string(n_rounds) + " rounds: ";
    race.notes.push_back(s->name + ": " + std::to_string(s->problem.control.size() / 3) + " control points, " +
                         std::to_string(s->problem.surface.rows.n_rows()) + " vertices of the limit.");
    race.notes.push_back(rounds + "RMS of the limit " + Percent(s->Rms(s->Rounds(n_rounds, kOurs))) + " ours, " +
                         Percent(s->Rms(s->Rounds(n_rounds, kOneARow))) + " a block a row, " +
                         Percent(s->Rms(s->Rounds(n_rounds, kGrouped))) + " grouped.");
    if (more.second) {
        race.notes.push_back(rounds + "RMS of the limit " + Percent(s->Rms(s->Rounds(n_rounds, more.second))) + " " +
                             more.first + ".");
    }
    const auto add = [&](const std::string& what, int n_threads, const Solve& solve, std::vector<std::string> peers) {
        race.Add({.name = s->name + ": " + what + ", " + std::to_string(n_threads) + "T",
                  .n_threads = n_threads,
                  .run = [s, solve] { s->Rounds(1, solve); },
                  .work = 1,
                  .unit = "rounds",
                  .peers = std::move(peers)});
    };
    for (int n : settings.ThreadCounts()) {
        const std::string t = ", " + std::to_string(n) + "T";
        std::vector<std::string> peers = {s->name + ": autodiff, a block a row" + t,
                                          s->name + ": autodiff, grouped" + t};
        if (more.second) peers.push_back(s->name + ": " + more.first + t);
        add("a round of ours", n, kOurs, peers);
        add("autodiff, a block a row", n, kOneARow, {});
        add("autodiff, grouped", n, kGrouped, {});
        if (more.second) add(more.first, n, more.second, {});
    }
}

/// The vertices of the control mesh, cut linearly, are drawn to the target; what is measured is the limit.
void NotePlain(Race& race, const FitRace& limit, const Fit::ControlMesh& mesh, const Sdc::Scheme& linear,
               int n_rounds) {
    const FitRace plain(limit.name, Fit::MakeProblem(mesh, linear, limit.problem.target, 4));
    const double with = limit.Rms(limit.Rounds(n_rounds, kOurs)), without = limit.Rms(plain.Rounds(n_rounds, kOurs));
    char ratio[32];
    std::snprintf(ratio, sizeof ratio, "%.2f", without / with);
    race.notes.push_back(limit.name + ": RMS of the limit " + Percent(without) +
                         " where the control mesh itself is drawn to the target, " + ratio + " times ours.");
}

}  // namespace

Race RaceFit(const RaceSettings& settings) {
    Race race("fit");
    race.notes.push_back("A round: nearest points both ways and the step; percent of the target's diagonal.");
    SetFreed(Freed::IsKept);
    static Io::Mesh scan;
    scan = Io::ReadMesh(std::string(SOLIDSUBDIV_PERF_SOURCE) + "/../shapes/demo/bunny.obj");
    const double diagonal = Geometry::BoundingBox(scan.positions).Diagonal();
    for (double& x : scan.positions) x /= diagonal;
    const Fit::TargetSurface target{.positions = scan.positions, .triangles = scan.topology.triangles};
    const Index n_control = settings.is_quick ? 100 : 480;
    const int n_rounds = settings.is_quick ? 3 : 8;
    constexpr int kRate = 4;
    const auto add = [&](const std::string& name, const Fit::ControlMesh& mesh, const Sdc::Scheme& scheme,
                         const Sdc::Scheme& linear, const std::pair<std::string, Solve>& more = {}) {
        const auto shared = std::make_shared<FitRace>(name, Fit::MakeProblem(mesh, scheme, target, kRate, 12));
        AddRace(race, settings, shared, n_rounds, more);
        NotePlain(race, *shared, mesh, linear, n_rounds);
    };
    add("hexahedra", MakeSolidStart(target, {.n_control = n_control}), Sdc::CatmullClarkSolid{}, Sdc::LinearSolid{});
    const Fit::ControlMesh cage = MakeCage(target, {.n_control = n_control});
    std::pair<std::string, Solve> more;
#if SOLIDSUBDIV_HAS_OPENSUBDIV
    const auto theirs = std::make_shared<OpenSubdivFit>(cage, kRate);
    more = {"OpenSubdiv's limit stencils", [theirs](const auto& step, auto pairs, double fairness, auto control) {
                theirs->Solve(step, pairs, fairness, control);
            }};
#endif
    add("Loop cage", cage, Sdc::Loop{}, Sdc::LinearSurface{}, more);
    race.Run(settings.Turns(3));
    return race;
}

}  // namespace SolidSubdiv::Perf
