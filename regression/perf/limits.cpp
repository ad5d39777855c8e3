// SPDX-License-Identifier: Apache-2.0
// The race of limit rows: a hundred thousand places, in cells that are regular, in irregular ones, on a surface beside
// OpenSubdiv; and the evaluation of such rows beside the plain loop.
#include <cmath>
#include <memory>
#include <stdexcept>

#include <solidsubdiv/far/limit_stencil_table.h>
#include <solidsubdiv/kit/io/formats.h>
#include <solidsubdiv/osd/backends.h>
#include <solidsubdiv/osd/evaluator.h>
#include <solidsubdiv/sdc/parallel.h>

#include "perf/hex_meshes.h"
#include "perf/meshes.h"
#include "perf/open_subdiv.h"
#include "perf/plain_rows.h"
#include "perf/races.h"

namespace SolidSubdiv::Perf {

namespace {

using Far::Elements;
using Far::Place;

struct LimitsRace {
    std::string name;
    Far::TopologyRefiner refiner;
    Sdc::Scheme scheme;
    Far::LimitPlacesOptions options{};
    std::vector<Place> places{};
    Far::LimitStencilTable table{};
};
using Shared = std::shared_ptr<LimitsRace>;

/// Random places in the elements of a level that are chosen.
template <class IsChosen>
void MakePlaces(LimitsRace& race, int n, IsChosen&& is_chosen) {
    TestShapes::Random chance(1);
    const auto uniform = [&] { return 0.5 + 0.5 * chance.Uniform(); };
    const int l = race.options.level;
    const bool is_cell = race.options.elements == Elements::Cells;
    const bool is_simplex = !race.refiner.is_polyhedral();
    const Index n_elements = is_cell      ? static_cast<Index>(race.refiner.n_cells(l))
                             : is_simplex ? race.refiner.level(l).n_boundary_faces
                                          : race.refiner.polyhedral_level(l).n_boundary_faces;
    while (static_cast<int>(race.places.size()) < n) {
        Place p{.element = static_cast<Index>(chance.Next() % static_cast<std::uint64_t>(n_elements))};
        if (!is_chosen(p.element)) continue;
        p.at = {uniform(), uniform(), is_cell ? uniform() : 0};
        const double sum = p.at[0] + p.at[1] + p.at[2];
        if (is_simplex && sum > 1) continue;  // within an octahedron as well
        race.places.push_back(p);
    }
}

/// All rows with nothing known before, which is what a first table costs.
void AddRows(Race& race, const RaceSettings& settings, const Shared& s, const std::string& peer = {}) {
    Far::LimitStencilTableFactory factory(s->refiner, s->scheme, s->options);
    s->table = factory.Create(s->places);
    const double bytes = static_cast<double>(s->table.Bytes()), n = static_cast<double>(s->places.size());
    race.notes.push_back(
        s->name + ": " + std::to_string(s->places.size()) + " places, " + std::to_string(static_cast<int>(bytes / n)) +
        " bytes and " + std::to_string(s->table.rows().n_weights() / static_cast<Offset>(s->places.size())) +
        " weights a row, " + std::to_string(factory.n_neighborhoods()) + " neighbourhoods of " +
        std::to_string(factory.Bytes() / 1024) + " KiB, " + std::to_string(s->table.defects().size()) + " defects.");
    for (int n_threads : settings.ThreadCounts()) {
        const std::string name = s->name + ", " + std::to_string(n_threads) + "T";
        std::vector<std::string> peers;
        if (n_threads > 1) peers.push_back(s->name + ", 1T");
        if (!peer.empty() && n_threads == 1) peers.push_back(peer);
        race.Add(
            {.name = name,
             .n_threads = n_threads,
             .run = [s] { s->table = Far::LimitStencilTable::Create(s->refiner, s->scheme, s->places, s->options); },
             .work = n,
             .unit = "rows",
             .peers = std::move(peers),
             .kept_bytes = bytes});
    }
}

Shared Make(const std::string& name, const Far::TopologyDescriptor& mesh, const Sdc::Scheme& scheme,
            const Far::LimitPlacesOptions& options) {
    const Sdc::Split split = Sdc::Takes(scheme, Sdc::Split::TetOct) ? Sdc::Split::TetOct : Sdc::Split::Polyhedral;
    const auto race =
        std::make_shared<LimitsRace>(LimitsRace{name, Far::TopologyRefiner::Create(mesh, split), scheme, options});
    if (options.level > 0) {
        race->refiner.RefineUniform({.max_level = options.level, .full_topology_in_last_level = true});
    }
    return race;
}

/// Points by our evaluator and by the plain loop, which must be the same.
void AddEvaluation(Race& race, const Shared& s) {
    struct Evaluation {
        Far::StencilTableReal<float> table;
        Array<float> control, ours, plain;
    };
    const Far::StencilRows<double>& rows = s->table.rows();
    Far::StencilRows<float> floats;
    floats.n_sources = rows.n_sources;
    floats.offsets = rows.offsets;
    floats.indices = rows.indices;
    floats.weights.assign(rows.weights.begin(), rows.weights.end());
    const auto e = std::make_shared<Evaluation>();
    e->table = Far::StencilTableReal<float>::FromRows(rows.n_sources, {floats});
    const std::size_t n = static_cast<std::size_t>(rows.n_rows());
    e->control.resize(3 * static_cast<std::size_t>(rows.n_sources) + 1);  // the plain loop reads one more
    for (std::size_t i = 0; i < e->control.size(); ++i) e->control[i] = std::sin(static_cast<float>(i));
    e->ours.resize(3 * n);
    e->plain.resize(3 * n + 1);
    const auto run_ours = [e] {
        Osd::EvaluatorReal<float> evaluator(e->table, Osd::Backend::Best());
        evaluator.Evaluate({e->control.data(), e->control.size() - 1}, e->ours);
    };
    const auto run_plain = [e, n] {
        const auto& r = e->table.level(1);
        EvaluatePlainRows(r.offsets.data(), r.indices.data(), r.weights.data(), e->control.data(), e->plain.data(), 0,
                          static_cast<Offset>(n));
    };
    run_ours();
    run_plain();
    for (std::size_t i = 0; i < 3 * n; ++i) {
        // Some tens of terms of numbers below 1.
        if (!(std::abs(e->ours[i] - e->plain[i]) < 1e-5f))
            throw std::runtime_error("the plain loop gives other points");
    }
    const double moved = static_cast<double>(e->table.Bytes()) + 4.0 * static_cast<double>(e->control.size() + 3 * n);
    const std::string plain = "evaluation, plain rows, loads of 4 floats, 1T";
    const double points = static_cast<double>(n);
    race.Add({.name = "evaluation, ours, 1T",
              .run = run_ours,
              .work = points,
              .unit = "points",
              .peers = {plain},
              .moved_bytes = moved});
    race.Add({.name = plain, .run = run_plain, .work = points, .unit = "points", .moved_bytes = moved});
}

}  // namespace

Race RaceLimits(const RaceSettings& settings) {
    Race race("limits");
    const int n = settings.is_quick ? 10000 : 200000;
    const auto everywhere = [](Index) { return true; };

    // Inside a tet refined three times the lattice is regular.
    const std::vector<Index> tet{0, 1, 2, 3};
    for (int order : {0, 1}) {
        const std::string with = order == 0 ? "points" : "points and derivatives";
        const auto tets = Make("box-spline, regular, " + with, {.n_vertices = 4, .tets = tet}, Sdc::BoxSpline{},
                               {.level = 4, .order = order});
        const Vtr::Level& level = tets->refiner.level(4);
        const auto is_inside = [&](Index c) {
            const auto is_solid = [&](auto&& vertices) {
                return std::all_of(vertices.begin(), vertices.end(),
                                   [&](Index v) { return level.vertex_tags[v].rule() == Vtr::Rule::Solid; });
            };
            return c < level.n_tets ? is_solid(level.TetVertices(c)) : is_solid(level.OctVertices(c - level.n_tets));
        };
        MakePlaces(*tets, n, is_inside);
        AddRows(race, settings, tets);

        const Io::Mesh block = HexBall(settings.is_quick ? 4 : 10, 0);
        const auto hexes =
            Make("catmull-clark-solid, regular, " + with, block.topology, Sdc::CatmullClarkSolid{}, {.order = order});
        MakePlaces(*hexes, n, everywhere);
        AddRows(race, settings, hexes);
    }

    const Io::Mesh bunny = Io::ReadMesh(std::string(SOLIDSUBDIV_PERF_SOURCE) + "/../shapes/demo/bunny_lattice.vtu");
    for (int places : {n, 5 * n}) {
        const auto irregular = Make("box-spline, " + std::to_string(bunny.topology.n_tets()) + " irregular tets, " +
                                        std::to_string(places) + " places",
                                    bunny.topology, Sdc::BoxSpline{}, {});
        MakePlaces(*irregular, places, everywhere);
        AddRows(race, settings, irregular);
        if (places == n) AddEvaluation(race, irregular);
    }

    const Io::Mesh ball = HexBall(settings.is_quick ? 4 : 12, settings.is_quick ? 4 : 10);
    for (const Sdc::Scheme scheme : {Sdc::Scheme(Sdc::CatmullClarkSolid{}), Sdc::Scheme(Sdc::Mlca{})}) {
        const auto irregular =
            Make(std::string(Sdc::NameOf(scheme)) + ", at edges of three cells", ball.topology, scheme, {});
        const Vtr::PolyhedralLevel& level = irregular->refiner.polyhedral_level(0);
        MakePlaces(*irregular, n, [&](Index c) {
            const auto edges = level.CellEdges(c);
            return std::any_of(edges.begin(), edges.end(), [&](Index e) {
                return level.edge_tags[e].rule() == Vtr::Rule::Solid && level.edge_faces.Count(e) != 4;
            });
        });
        AddRows(race, settings, irregular);
    }

    const Io::Mesh quads = QuadTorus(settings.is_quick);
    const auto surface = Make("catmull-clark, irregular quadrilaterals, points and derivatives", quads.topology,
                              Sdc::CatmullClark{}, {.elements = Elements::BoundaryFaces, .order = 1});
    MakePlaces(*surface, n, everywhere);
#if SOLIDSUBDIV_HAS_OPENSUBDIV
    const auto theirs = std::make_shared<OpenSubdivLimits>(quads.topology.quads, quads.topology.n_vertices);
    for (const Place& p : surface->places) theirs->AddPlace(p.element, p.at[0], p.at[1]);
    const std::string peer = "OpenSubdiv LimitStencilTableFactory, the same, 1T";
    race.Add({.name = peer, .run = [theirs] { theirs->Make(); }, .work = static_cast<double>(n), .unit = "rows"});
    AddRows(race, settings, surface, peer);
#else
    race.notes.push_back("OpenSubdiv was not there.");
    AddRows(race, settings, surface);
#endif
    race.Run(settings.Turns(7));
    return race;
}

}  // namespace SolidSubdiv::Perf
