// SPDX-License-Identifier: Apache-2.0
// The race of location: a million points in lattices of 10,368 cells refined to level 3, by our hierarchy and by
// Embree's under the same tests of cells.
#include <algorithm>
#include <memory>
#include <optional>

#include <solidsubdiv/far/primvar_refiner.h>
#include <solidsubdiv/kit/geometry/locator.h>

#include "perf/embree_locator.h"
#include "perf/hex_meshes.h"
#include "perf/machine.h"
#include "perf/meshes.h"
#include "perf/races.h"

namespace SolidSubdiv::Perf {

namespace {

struct LocationRace {
    std::string name;
    Far::TopologyRefiner refiner;
    int level = 0;
    std::vector<double> positions{};
    std::vector<double> random{}, coherent{};  ///< points of random places, and the same ascending by cell
    std::optional<Geometry::Locator> ours{}, another{};
    std::unique_ptr<EmbreeLocator> embree{}, another_embree{};

    void Refine(const Sdc::Scheme& scheme, int n_levels, std::vector<double> control) {
        level = n_levels;
        positions = std::move(control);
        refiner.RefineUniform({.max_level = level});
        const Far::PrimvarRefiner primvars(refiner, scheme);
        for (int l = 1; l <= level; ++l) {
            std::vector<double> fine(3 * static_cast<std::size_t>(refiner.n_vertices(l)));
            primvars.Interpolate<double>(l, positions, fine, 3);
            positions = std::move(fine);
        }
    }

    void MakePoints(int n) {
        TestShapes::Random chance(1);
        const auto uniform = [&] { return 0.5 + 0.5 * chance.Uniform(); };
        std::vector<Far::Place> places(static_cast<std::size_t>(n));
        for (Far::Place& p : places) {
            p.element = static_cast<Index>(chance.Next() % static_cast<std::uint64_t>(refiner.n_cells(level)));
            p.at = {uniform(), uniform(), uniform()};
            while (!refiner.is_polyhedral() && p.at[0] + p.at[1] + p.at[2] > 1)
                p.at = {uniform(), uniform(), uniform()};
        }
        random = PointsOf(places);
        std::stable_sort(places.begin(), places.end(),
                         [](const Far::Place& a, const Far::Place& b) { return a.element < b.element; });
        coherent = PointsOf(places);
    }

    std::vector<double> PointsOf(const std::vector<Far::Place>& places) const {
        const auto rows = Far::MakePlaceRows(refiner, level, places);
        std::vector<double> points(3 * places.size());
        for (Index i = 0; i < rows.n_rows(); ++i) {
            for (std::size_t k = 0; k < rows.Indices(i).size(); ++k) {
                const double* const p = &positions[3 * static_cast<std::size_t>(rows.Indices(i)[k])];
                for (std::size_t c = 0; c < 3; ++c)
                    points[3 * static_cast<std::size_t>(i) + c] += rows.Weights(i)[k] * p[c];
            }
        }
        return points;
    }
};

using Shared = std::shared_ptr<LocationRace>;

void AddSolid(Race& race, const RaceSettings& settings, const Shared& s) {
    const double before = ResidentBytes();
    s->ours.emplace(s->refiner, s->level, s->positions);
    const double between = ResidentBytes();
    if (EmbreeLocator::IsThere()) s->embree = std::make_unique<EmbreeLocator>(s->refiner, s->level, s->positions, 1);
    const double after = ResidentBytes();
    race.notes.push_back(s->name + ": " + std::to_string(s->refiner.n_cells(0)) + " cells, " +
                         std::to_string(s->refiner.n_cells(s->level)) + " in level " + std::to_string(s->level) + "; " +
                         std::to_string(s->random.size() / 3) + " points.");
    // Both find the same, or the race means nothing.
    const auto found = s->ours->Locate(s->random, {.wants_nearest = false});
    std::size_t n_different = 0;
    if (s->embree) {
        const auto peer = s->embree->Locate(s->random);
        for (std::size_t i = 0; i < peer.size(); ++i) n_different += peer[i].element != found.places[i].element;
    }
    race.notes.push_back(s->name + ": " + std::to_string(found.outside.size()) + " points lost; " +
                         std::to_string(n_different) + " with another cell by Embree's hierarchy.");
    const auto n_cells = static_cast<double>(s->refiner.n_cells(s->level));
    for (int n_threads : settings.ThreadCounts()) {
        const auto name = [&](const std::string& what, int n) {
            return s->name + ": " + what + ", " + std::to_string(n) + "T";
        };
        const auto add = [&](const std::string& what, const std::string& peer, double work, const char* unit,
                             double kept, std::function<void()> run, std::function<void()> clear = {}) {
            std::vector<std::string> peers;
            if (n_threads > 1) peers.push_back(name(what, 1));
            if (!peer.empty() && EmbreeLocator::IsThere()) peers.push_back(name(peer, n_threads));
            race.Add({.name = name(what, n_threads),
                      .n_threads = n_threads,
                      .run = std::move(run),
                      .work = work,
                      .unit = unit,
                      .peers = std::move(peers),
                      .kept_bytes = kept,
                      .clear = std::move(clear)});
        };
        add(
            "build", "build, Embree", n_cells, "cells", between - before,
            [s] { s->another.emplace(s->refiner, s->level, s->positions); }, [s] { s->another.reset(); });
        for (const bool is_random : {true, false}) {
            const std::string order = is_random ? "random points" : "coherent points";
            const std::vector<double>& points = is_random ? s->random : s->coherent;
            const auto n = static_cast<double>(points.size() / 3);
            add(order, order + ", Embree", n, "points", 0,
                [s, &points] { s->ours->Locate(points, {.wants_nearest = false}); });
            if (s->embree) {
                add(order + ", Embree", "", n, "points", 0, [s, &points] { s->embree->Locate(points); });
            }
        }
        if (s->embree) {
            add(
                "build, Embree", "", n_cells, "cells", after - between,
                [s, n_threads] {
                    s->another_embree = std::make_unique<EmbreeLocator>(s->refiner, s->level, s->positions, n_threads);
                },
                [s] { s->another_embree.reset(); });
        }
    }
}

}  // namespace

Race RaceLocation(const RaceSettings& settings) {
    Race race("location");
    race.notes.push_back("Bytes kept beside the level and its positions.");
    const int n_levels = settings.is_quick ? 2 : 3, n_points = settings.is_quick ? 100000 : 1000000;
    SetFreed(Freed::IsKept);

    const TestShapes::Shape block = TestShapes::KuhnBlock(settings.is_quick ? 5 : 12);
    const auto tets = std::make_shared<LocationRace>(
        LocationRace{"tets", Far::TopologyRefiner::Create(Describe(block), Sdc::Split::TetOct)});
    TestShapes::Shape shaken = block;
    TestShapes::Jitter(shaken, 0.1, 1);
    tets->Refine(Sdc::BoxSpline{}, n_levels, shaken.positions);
    tets->MakePoints(n_points);
    AddSolid(race, settings, tets);

    const Io::Mesh ball = HexBall(settings.is_quick ? 4 : 12, settings.is_quick ? 4 : 10);
    const auto hexes = std::make_shared<LocationRace>(
        LocationRace{"hexes", Far::TopologyRefiner::Create(ball.topology, Sdc::Split::Polyhedral)});
    hexes->Refine(Sdc::CatmullClarkSolid{}, n_levels, ball.positions);
    hexes->MakePoints(n_points);
    AddSolid(race, settings, hexes);

    race.Run(settings.Turns(7));
    return race;
}

}  // namespace SolidSubdiv::Perf
