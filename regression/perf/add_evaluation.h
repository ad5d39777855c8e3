// SPDX-License-Identifier: Apache-2.0
// Candidates that evaluate all levels of a cascaded table.
#pragma once

#include <span>
#include <string>

#include <solidsubdiv/far/stencil_table.h>
#include <solidsubdiv/osd/backends.h>
#include <solidsubdiv/osd/evaluator.h>

#include "perf/races.h"

namespace SolidSubdiv::Perf {

/// Positions by our best evaluator. The table outlives the race.
template <class Real>
void AddEvaluation(Race& race, const RaceSettings& settings, const Far::StencilTableReal<Real>& table,
                   std::span<const double> positions, const std::string& name) {
    struct State {
        Osd::EvaluatorReal<Real> eval;
        Array<Real> control, refined;
    };
    const auto state =
        std::make_shared<State>(State{{table, Osd::Backend::Best()}, {positions.begin(), positions.end()}, {}});
    state->refined.assign(3 * static_cast<std::size_t>(state->eval.n_refined_vertices()), 0);
    double moved = static_cast<double>(table.Bytes()) + 3.0 * sizeof(Real) * table.n_control_vertices();
    double points = 0;
    for (int l = 1; l <= table.n_levels(); ++l) {
        points += table.level(l).n_rows();
        moved += 3.0 * sizeof(Real) * table.level(l).n_rows() * (l < table.n_levels() ? 2 : 1);  // written, then read
    }
    for (int n_threads : settings.ThreadCounts()) {
        race.Add({.name = name + ", " + std::to_string(n_threads) + "T",
                  .n_threads = n_threads,
                  .run = [state] { state->eval.Evaluate(state->control, state->refined); },
                  .work = points,
                  .unit = "points",
                  .peers = n_threads == 1 ? std::vector<std::string>{} : std::vector{name + ", 1T"},
                  .moved_bytes = moved});
    }
}

}  // namespace SolidSubdiv::Perf
