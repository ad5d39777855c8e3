// SPDX-License-Identifier: Apache-2.0
// The races of hexahedra: a block of 100^3 by one level, beside the same number of other cells; solids with
// extraordinary edges by two.
#include <filesystem>
#include <memory>

#include <solidsubdiv/kit/io/formats.h>

#include "perf/add_evaluation.h"
#include "perf/hex_meshes.h"
#include "perf/machine.h"
#include "perf/meshes.h"
#include "perf/races.h"
#include "perf/solid.h"

namespace SolidSubdiv::Perf {

namespace {

using SharedSolid = std::shared_ptr<Solid>;

/// Topology, tables and values of a solid; each beside the same of a peer, if there is one. Rates are those of cells in
/// the last level, but for level 0.
void AddSolid(Race& race, const RaceSettings& settings, const SharedSolid& solid, const SharedSolid& peer = nullptr) {
    race.notes.push_back(solid->Describe());
    const double cells = solid->NCells(solid->refiner().max_level());
    const double bytes_of_refinement = solid->bytes_of_levels() - solid->bytes_of_level_0();
    for (int n_threads : settings.ThreadCounts()) {
        const auto add = [&](const char* what, std::function<void()> run, double work, double moved, double kept) {
            const auto label = [&](const SharedSolid& s, int n) {
                return s->name() + ": " + what + ", " + std::to_string(n) + "T";
            };
            std::vector<std::string> peers;
            if (n_threads > 1) peers.push_back(label(solid, 1));
            if (peer) peers.push_back(label(peer, n_threads));
            race.Add({.name = label(solid, n_threads),
                      .n_threads = n_threads,
                      .run = std::move(run),
                      .work = work,
                      .unit = "cells",
                      .peers = std::move(peers),
                      .moved_bytes = moved,
                      .kept_bytes = kept,
                      .clear = [solid] { solid->Clear(); }});
        };
        const auto add_tables = [&]<class Real>(const char* what, const Sdc::Scheme& scheme, Real) {
            const auto bytes =
                static_cast<double>(Far::StencilTableReal<Real>::Create(solid->refiner(), scheme).Bytes());
            add(
                what, [solid, scheme] { solid->Refine(), solid->MakeTable<Real>(scheme); }, cells,
                bytes_of_refinement + bytes, solid->bytes_of_levels() + bytes);
        };
        add(
            "level 0", [solid] { solid->CreateAnother(); }, solid->NCells(0), 0, solid->bytes_of_level_0());
        add(
            "refine", [solid] { solid->Refine(); }, cells, bytes_of_refinement, solid->bytes_of_levels());
        add_tables("refine + stencils, float", Sdc::CatmullClarkSolid{}, float{});
        add(
            "refine + interpolate, float", [solid] { solid->Refine(), solid->Interpolate(); }, cells, 0, 0);
        if (peer) continue;
        add_tables("refine + stencils, double", Sdc::CatmullClarkSolid{}, double{});
        add_tables("refine + linear stencils, float", Sdc::LinearSolid{}, float{});
    }
}

}  // namespace

Race RaceHexes(const RaceSettings& settings) {
    Race race("hexes");
    const int n = settings.is_quick ? 20 : 100;
    const auto hexes = std::make_shared<Solid>("hexes", HexBall(n, 0), 1);
    const auto table_float = Far::StencilTableReal<float>::Create(hexes->refiner(), Sdc::CatmullClarkSolid{});
    const auto table_double = Far::StencilTableReal<double>::Create(hexes->refiner(), Sdc::CatmullClarkSolid{});
    AddSolid(race, settings, hexes);
    AddEvaluation(race, settings, table_float, hexes->mesh().positions, "hexes: evaluate positions, float");
    AddEvaluation(race, settings, table_double, hexes->mesh().positions, "hexes: evaluate positions, double");
    AddSolid(race, settings, std::make_shared<Solid>("polyhedra", AsPolyhedra(HexBall(n, 0)), 1), hexes);
    const int n_cut = settings.is_quick ? 11 : 55;
    AddSolid(race, settings, std::make_shared<Solid>("pyramids", CutIntoPyramids(HexBall(n_cut, 0)), 1), hexes);
    race.notes.push_back("Polyhedra: the same hexahedra, given by their faces. Pyramids: six in a hexahedron.");
    SetFreed(Freed::GoesBack);
    race.Run(settings.Turns(5));
    return race;
}

Race RaceHexModels(const RaceSettings& settings) {
    Race race("hexes of models");
    AddSolid(race, settings,
             std::make_shared<Solid>("ball", HexBall(settings.is_quick ? 4 : 12, settings.is_quick ? 3 : 10), 2));
    const std::filesystem::path path = LocalMesh("hexes/cino_rockerarm.mesh");
    if (std::filesystem::exists(path)) {
        Io::Mesh mesh = Io::ReadSolid(path);
        mesh.topology.quads.clear();  // its boundary: tags
        AddSolid(race, settings, std::make_shared<Solid>("rocker arm", std::move(mesh), 2));
    } else {
        race.notes.push_back("The rocker arm was skipped: " + path.string() + " was not there (SOLIDSUBDIV_DATA).");
    }
    SetFreed(Freed::GoesBack);
    race.Run(settings.Turns(7));
    return race;
}

}  // namespace SolidSubdiv::Perf
