// SPDX-License-Identifier: Apache-2.0
// The races of hexahedra: a block of 100^3 by one level, beside the same number of other cells; solids with
// extraordinary edges by two.
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <optional>

#include <solidsubdiv/far/primvar_refiner.h>
#include <solidsubdiv/far/stencil_table.h>
#include <solidsubdiv/kit/io/formats.h>

#include "perf/add_evaluation.h"
#include "perf/hex_meshes.h"
#include "perf/machine.h"
#include "perf/races.h"

namespace SolidSubdiv::Perf {

namespace {

/// A solid, its levels and tables, as one object that races can fill and empty.
class Solid {
  public:
    Solid(std::string name, Io::Mesh mesh, int n_levels) : name_(std::move(name)), mesh_(std::move(mesh)) {
        const double before = ResidentBytes();
        Create();
        bytes_of_level_0_ = ResidentBytes() - before;
        refiner_->RefineUniform({.max_level = n_levels});
        bytes_of_levels_ = ResidentBytes() - before;
        n_levels_ = n_levels;
    }
    const std::string& name() const { return name_; }
    const Io::Mesh& mesh() const { return mesh_; }
    const Far::TopologyRefiner& refiner() const { return *refiner_; }
    double bytes_of_level_0() const { return bytes_of_level_0_; }
    double bytes_of_levels() const { return bytes_of_levels_; }
    double NCells(int level) const { return static_cast<double>(refiner_->n_cells(level)); }

    void Create() { refiner_.emplace(Far::TopologyRefiner::Create(mesh_.topology, Sdc::Split::Polyhedral)); }
    void Refine() { refiner_->RefineUniform({.max_level = n_levels_}); }
    template <class Real>
    void MakeTable(const Sdc::Scheme& scheme) {
        table_ = Far::StencilTableReal<Real>::Create(*refiner_, scheme);
    }
    /// Positions level by level, in floats.
    void Interpolate() {
        const Far::PrimvarRefiner primvars(*refiner_, Sdc::CatmullClarkSolid{});
        values_[0].assign(mesh_.positions.begin(), mesh_.positions.end());
        for (int l = 1; l <= n_levels_; ++l) {
            Array<float>& fine = values_[l % 2];
            fine.resize(3 * static_cast<std::size_t>(refiner_->n_vertices(l)));
            primvars.Interpolate<float>(l, values_[(l + 1) % 2], fine, 3);
        }
    }
    /// Level 0 is left.
    void Clear() {
        refiner_->RefineUniform({.max_level = 0});
        table_ = {};
        for (Array<float>& v : values_) v = {};
    }

    std::string Describe() const {
        const auto& fine = refiner_->polyhedral_level(n_levels_);
        return name_ + ": " + std::to_string(refiner_->n_cells(0)) + " cells, " + std::to_string(n_levels_) +
               (n_levels_ == 1 ? " level: " : " levels: ") + std::to_string(fine.n_hexes) + " hexahedra, " +
               std::to_string(fine.n_polyhedra()) + " other cells and " + std::to_string(fine.n_vertices) +
               " vertices in the last.";
    }

  private:
    std::string name_;
    Io::Mesh mesh_;
    int n_levels_ = 0;
    double bytes_of_level_0_ = 0, bytes_of_levels_ = 0;
    std::optional<Far::TopologyRefiner> refiner_;
    std::variant<std::monostate, Far::StencilTableReal<float>, Far::StencilTableReal<double>> table_;
    Array<float> values_[2];
};
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
            "level 0", [solid] { solid->Create(); }, solid->NCells(0), 0, solid->bytes_of_level_0());
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

/// A mesh of the local collection, which the repository may not carry.
std::filesystem::path LocalMesh(const char* name) {
    const char* const given = std::getenv("SOLIDSUBDIV_DATA");
    return std::filesystem::path(given ? given : SOLIDSUBDIV_PERF_SOURCE "/../../../shared/data/local") / name;
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
