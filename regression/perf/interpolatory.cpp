// SPDX-License-Identifier: Apache-2.0
// The race of solid schemes: interpolatory beside box-spline solids on the same tets, by weights a second.
#include <optional>

#include <solidsubdiv/far/primvar_refiner.h>
#include <solidsubdiv/far/stencil_table.h>

#include "perf/machine.h"
#include "perf/meshes.h"
#include "perf/races.h"

namespace SolidSubdiv::Perf {

namespace {

constexpr int kLevels = 2;

template <class Real>
void AddScheme(Race& race, const RaceSettings& settings, const Far::TopologyRefiner& ready,
               std::optional<Far::TopologyRefiner>& refiner, const Far::TopologyDescriptor& descriptor,
               const TestShapes::Shape& shape, const Sdc::Scheme& scheme, const char* real) {
    using Table = Far::StencilTableReal<Real>;
    struct State {
        std::optional<Table> table{};
        Array<Real> values[kLevels + 1];
    };
    const auto state = std::make_shared<State>();
    state->values[0].assign(shape.positions.begin(), shape.positions.end());
    const Table counted = Table::Create(ready, scheme);
    double n_weights = 0;
    for (int l = 1; l <= kLevels; ++l) {
        n_weights += static_cast<double>(counted.level(l).n_weights());
        state->values[l].resize(3 * static_cast<std::size_t>(ready.level(l).n_vertices));
    }
    const auto make_table = [state, scheme](const Far::TopologyRefiner& from) {
        state->table.emplace(Table::Create(from, scheme));
    };
    const auto add = [&](const char* what, int n_threads, std::function<void()> run, double moved) {
        const auto label = [&](std::string_view name, int n) {
            return std::string(what) + ", " + std::string(name) + ", " + real + ", " + std::to_string(n) + "T";
        };
        const std::string_view mine = Sdc::NameOf(scheme), first = Sdc::BoxSpline::kName;
        std::vector<std::string> peers;
        if (mine != first) peers.push_back(label(first, n_threads));
        if (n_threads > 1) peers.push_back(label(mine, 1));
        race.Add({.name = label(mine, n_threads),
                  .n_threads = n_threads,
                  .run = std::move(run),
                  .work = n_weights,
                  .unit = "weights",
                  .peers = std::move(peers),
                  .moved_bytes = moved,
                  .clear = [state, &refiner] { state->table.reset(), refiner.reset(); }});
    };
    const auto bytes = static_cast<double>(counted.Bytes());
    for (int n : settings.ThreadCounts()) {
        add(
            "stencils", n, [make_table, &ready] { make_table(ready); }, bytes);
        add(
            "create + refine + stencils", n,
            [make_table, &refiner, descriptor] {
                refiner.emplace(Far::TopologyRefiner::Create(descriptor, Sdc::Split::TetOct));
                refiner->RefineUniform({.max_level = kLevels});
                make_table(*refiner);
            },
            bytes);
        add(
            "interpolate positions", n,
            [state, scheme, &ready] {
                const Far::PrimvarRefiner primvars(ready, scheme);
                for (int l = 1; l <= kLevels; ++l) {
                    primvars.Interpolate<Real>(l, state->values[l - 1], state->values[l], 3);
                }
            },
            0);
    }
}

}  // namespace

Race RaceInterpolatory(const RaceSettings& settings) {
    Race race("interpolatory solids");
    const TestShapes::Shape shape = TetBlock(settings.is_quick);
    const Far::TopologyDescriptor descriptor = Describe(shape);
    auto ready = Far::TopologyRefiner::Create(descriptor, Sdc::Split::TetOct);
    ready.RefineUniform({.max_level = kLevels});
    std::optional<Far::TopologyRefiner> refiner;
    race.notes = {"Kuhn block of " + std::to_string(ready.level(0).n_tets) + " tets, " + std::to_string(kLevels) +
                      " levels. Weights are those of the cascaded tables of all levels; bytes moved are those of the "
                      "tables, written once. Interpolating makes as many weights, applies and forgets them.",
                  "Every candidate works on memory that the process kept: none pays for fresh pages."};
    for (const Sdc::Scheme& scheme : {Sdc::Scheme(Sdc::BoxSpline{}), Sdc::Scheme(Sdc::Interpolatory{})}) {
        AddScheme<float>(race, settings, ready, refiner, descriptor, shape, scheme, "float");
        AddScheme<double>(race, settings, ready, refiner, descriptor, shape, scheme, "double");
    }
    SetFreed(Freed::IsKept);
    race.Run(settings.Turns(7));
    SetFreed(Freed::GoesBack);
    return race;
}

}  // namespace SolidSubdiv::Perf
