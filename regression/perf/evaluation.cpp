// SPDX-License-Identifier: Apache-2.0
// The race of evaluators: three floats a point, the composite rows of a Loop surface's third level; beside OpenSubdiv,
// Eigen and a plain loop.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>
#include <thread>

#include <solidsubdiv/far/stencil_table.h>
#include <solidsubdiv/osd/backends.h>
#include <solidsubdiv/osd/evaluator.h>
#include <solidsubdiv/sdc/parallel.h>

#include "perf/eigen.h"
#include "perf/machine.h"
#include "perf/meshes.h"
#include "perf/open_subdiv.h"
#include "perf/plain_rows.h"
#include "perf/races.h"

namespace SolidSubdiv::Perf {

namespace {

constexpr int kLevels = 3;

/// @throws std::runtime_error unless rows of `width` begin with the same three numbers, to the round-off of their sums
void RequireSame(const char* name, const Array<float>& ours, const Array<float>& theirs, int width) {
    for (std::size_t i = 0; i < ours.size() / 3; ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
            // Some 15 terms of numbers of size 3, weights that sum to 1.
            const float error = std::abs(ours[3 * i + c] - theirs[static_cast<std::size_t>(width) * i + c]);
            if (!(error <= 3e-5f)) throw std::runtime_error(std::string(name) + " gives other points than we");
        }
    }
}

}  // namespace

Race RaceEvaluation(const RaceSettings& settings) {
    Race race("evaluation");
    const TestShapes::Shape shape = Torus(settings.is_quick);
    auto refiner = Far::TopologyRefiner::Create(Describe(shape), Sdc::Split::TetOct);
    refiner.RefineUniform({.max_level = kLevels});
    using Table = Far::StencilTableReal<float>;
    const Table table = Table::CreateComposite(refiner, Sdc::Loop{}, {{.level = kLevels, .vertices = {}}});
    const auto& rows = table.level(1);
    const auto n = static_cast<std::size_t>(rows.n_rows()), n_control = static_cast<std::size_t>(rows.n_sources);
    race.notes = {"Composite rows of level " + std::to_string(kLevels) + " of the torus: " + std::to_string(n) +
                  " rows, " + std::to_string(rows.n_weights()) + " weights, " + std::to_string(n_control) +
                  " control vertices; floats."};

    // Sources have a number more than they need: the plain loop reads four of each three.
    Array<float> control(3 * n_control + 1), wide_control(4 * n_control);
    for (std::size_t i = 0; i < n_control; ++i) {
        for (std::size_t c = 0; c < 4; ++c) {
            const auto x = c < 3 ? static_cast<float>(shape.positions[3 * i + c]) : 1.0f;
            if (c < 3) control[3 * i + c] = x;
            wide_control[4 * i + c] = x;
        }
    }
    Array<float> refined(3 * n), wide(4 * n), others(4 * n);
    const double points = static_cast<double>(n);
    const double moved = static_cast<double>(table.Bytes()) + 12.0 * static_cast<double>(n_control) + 12.0 * points;
    const auto add = [&](std::string name, int n_threads, std::vector<std::string> peer_names,
                         std::function<void()> run, double bytes) {
        race.Add({.name = std::move(name),
                  .n_threads = n_threads,
                  .run = std::move(run),
                  .work = points,
                  .unit = "points",
                  .peers = std::move(peer_names),
                  .moved_bytes = bytes});
    };

    const std::string plain = "plain rows, loads of 4 floats";
    const auto run_plain = [&] {
        Sdc::ParallelFor(static_cast<Offset>(n), 4096, [&](Offset begin, Offset end) {
            EvaluatePlainRows(rows.offsets.data(), rows.indices.data(), rows.weights.data(), control.data(),
                              others.data(), begin, end);
        });
    };
    Osd::EvaluatorReal eval(table, Osd::Backend::Best());
    const std::span<const float> packed(control.data(), 3 * n_control);
    const auto run_ours = [&] { eval.Evaluate(packed, refined); };
    const auto run_ours_wide = [&] { eval.Evaluate(wide_control, wide, 4); };
    const double moved_wide = moved + 4.0 * static_cast<double>(n_control) + 4.0 * points;
    run_ours();
    run_plain();
    RequireSame("the plain loop", refined, others, 3);
    run_ours_wide();
    RequireSame("our width 4", refined, wide, 4);

    std::vector<std::string> peers[2];  // of one thread, of two
    for (int n_threads : settings.ThreadCounts()) {
        const std::string name = plain + ", " + std::to_string(n_threads) + "T";
        add(name, n_threads, {}, run_plain, moved);
        peers[n_threads - 1].push_back(name);
    }

#if SOLIDSUBDIV_HAS_OPENSUBDIV
    OpenSubdivRows their_rows{{}, {}, rows.indices.data(), rows.weights.data()};
    for (std::size_t i = 0; i < n; ++i) {
        their_rows.offsets.push_back(static_cast<int>(rows.offsets[i]));
        their_rows.sizes.push_back(static_cast<int>(rows.offsets[i + 1] - rows.offsets[i]));
    }
    for (int width : {3, 4}) {
        const auto run = [&, width] {
            EvaluateByOpenSubdiv(their_rows, width == 3 ? control.data() : wide_control.data(), others.data(), width);
        };
        run();
        RequireSame("OpenSubdiv", refined, others, width);
        const std::string name = "OpenSubdiv CpuEvaluator, width " + std::to_string(width) + ", 1T";
        add(name, 1, {}, run, width == 3 ? moved : moved_wide);
        peers[0].push_back(name);
    }
#else
    race.notes.push_back("OpenSubdiv was not there.");
#endif

#if SOLIDSUBDIV_HAS_EIGEN
    const EigenRows eigen(static_cast<int>(n), static_cast<int>(n_control), rows.offsets.data(), rows.indices.data(),
                          rows.weights.data());
    for (int n_threads = 1; n_threads <= std::min(settings.ThreadCounts().back(), EigenRows::MaxThreads());
         ++n_threads) {
        const auto run = [&, n_threads] { eigen.Evaluate(control.data(), others.data(), n_threads); };
        run();
        RequireSame("Eigen", refined, others, 3);
        const std::string name = "Eigen, n x 3 row-major, " + std::to_string(n_threads) + "T";
        race.Add(
            {.name = name,
             .n_threads = n_threads,
             .run = run,
             .work = points,
             .unit = "points",
             .moved_bytes = moved,
             .clear = [] { std::this_thread::sleep_for(std::chrono::milliseconds(20)); }});  // OpenMP's threads spin
        peers[n_threads - 1].push_back(name);
    }
#else
    race.notes.push_back("Eigen was not there.");
#endif

    peers[1].push_back("ours, width 3, 1T");
    for (int n_threads : settings.ThreadCounts()) {
        const std::string t = ", " + std::to_string(n_threads) + "T";
        add("ours, width 3" + t, n_threads, peers[n_threads - 1], run_ours, moved);
        add("ours, width 4" + t, n_threads, peers[n_threads - 1], run_ours_wide, moved_wide);
    }
    race.Run(settings.Turns(25));
    return race;
}

}  // namespace SolidSubdiv::Perf
