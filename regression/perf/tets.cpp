// SPDX-License-Identifier: Apache-2.0
// The race of solids: 200,000 tets by two levels, topology and box-spline stencils, beside a loop that only splits.
#include <optional>

#include <solidsubdiv/far/stencil_table.h>

#include "perf/add_evaluation.h"
#include "perf/machine.h"
#include "perf/meshes.h"
#include "perf/races.h"

namespace SolidSubdiv::Perf {

namespace {

constexpr int kLevels = 2;

/// What any refiner of tets must at least do: eight tets for one, and their edges, each once. No faces, no relations,
/// no octahedra (the inner one is cut into four). Into memory that is there already.
class BareSplit {
  public:
    explicit BareSplit(const Vtr::Level& level)
        : level_(level),
          tets_(32 * static_cast<std::size_t>(level.n_tets)),
          edges_(2 * (2 * static_cast<std::size_t>(level.n_edges) + 3 * static_cast<std::size_t>(level.n_faces) +
                      level.n_tets)) {}

    void Run() {
        const Index n = level_.n_vertices;
        Index* edge = edges_.data();
        for (Index e = 0; e < level_.n_edges; ++e) {
            const auto ends = level_.EdgeVertices(e);
            for (Index end : {ends[0], ends[1]}) *edge++ = end, *edge++ = n + e;
        }
        for (Index f = 0; f < level_.n_faces; ++f) {
            const auto e = level_.FaceEdges(f);
            for (int k = 0; k < 3; ++k) *edge++ = n + e[k], *edge++ = n + e[(k + 1) % 3];
        }
        Index* out = tets_.data();
        for (Index t = 0; t < level_.n_tets; ++t) {
            const auto v = level_.TetVertices(t);
            const auto edges = level_.TetEdges(t);
            Index points[10];
            for (int i = 0; i < 4; ++i) points[i] = v[i];
            for (int i = 0; i < 6; ++i) points[4 + i] = n + edges[i];
            // Corners, then four around the segment between the points on the first and the last edge.
            static constexpr int kChildren[8][4] = {{0, 4, 5, 6}, {4, 1, 7, 8}, {5, 7, 2, 9}, {6, 8, 9, 3},
                                                    {4, 9, 5, 6}, {4, 9, 6, 8}, {4, 9, 8, 7}, {4, 9, 7, 5}};
            for (const auto& child : kChildren) {
                for (int i : child) *out++ = points[i];
            }
            *edge++ = points[4];
            *edge++ = points[9];
        }
    }
    double Cells() const { return 8.0 * level_.n_tets; }
    double BytesWritten() const { return static_cast<double>((tets_.size() + edges_.size()) * sizeof(Index)); }
    double BytesMoved() const {
        return BytesWritten() + sizeof(Index) * (10.0 * level_.n_tets + 3.0 * level_.n_faces + 2.0 * level_.n_edges);
    }

  private:
    const Vtr::Level& level_;
    Array<Index> tets_, edges_;
};

}  // namespace

Race RaceTets(const RaceSettings& settings) {
    Race race("tets");
    const TestShapes::Shape shape = TetBlock(settings.is_quick);
    const Far::TopologyDescriptor descriptor = Describe(shape);
    const Sdc::Scheme scheme = Sdc::BoxSpline{};

    // Sizes and memory, from runs without a clock.
    const double bytes_before = ResidentBytes();
    auto refined = Far::TopologyRefiner::Create(descriptor, Sdc::Split::TetOct);
    const double bytes_of_level_0 = ResidentBytes() - bytes_before;
    refined.RefineUniform({.max_level = kLevels});
    const double bytes_of_levels = ResidentBytes() - bytes_before;
    const auto table_float = Far::StencilTableReal<float>::Create(refined, scheme);
    const auto table_double = Far::StencilTableReal<double>::Create(refined, scheme);
    const auto cells = static_cast<double>(refined.level(kLevels).n_cells());
    const double bytes_float = static_cast<double>(table_float.Bytes()),
                 bytes_double = static_cast<double>(table_double.Bytes());

    race.notes = {"Kuhn block of " + std::to_string(refined.level(0).n_tets) + " tets, " + std::to_string(kLevels) +
                      " levels: " + std::to_string(refined.level(kLevels).n_cells()) +
                      " cells (tets and octahedra) and " + std::to_string(refined.level(kLevels).n_vertices) +
                      " vertices in the last. Cells a second counts those of the last level alone.",
                  "Bytes kept of 'refine' are those of all levels, of 'refine + stencils' those of the tables too; "
                  "bytes moved of both are the "
                  "bytes written, which each are read again at least in part: % is a lower bound."};

    BareSplit bare(refined.level(0));
    race.Add({.name = "bare split 1 to 8, nothing else",
              .run = [&] { bare.Run(); },
              .work = bare.Cells(),
              .unit = "cells",
              .moved_bytes = bare.BytesMoved(),
              .kept_bytes = bare.BytesWritten()});

    std::optional<Far::TopologyRefiner> made;
    race.Add({.name = "level 0 from the mesh, 1T",
              .run = [&] { made.emplace(Far::TopologyRefiner::Create(descriptor, Sdc::Split::TetOct)); },
              .work = static_cast<double>(refined.level(0).n_tets),
              .unit = "tets",
              .kept_bytes = bytes_of_level_0,
              .clear = [&] { made.reset(); }});

    auto refiner = Far::TopologyRefiner::Create(descriptor, Sdc::Split::TetOct);
    std::optional<Far::StencilTableReal<float>> stencils_float;
    std::optional<Far::StencilTableReal<double>> stencils_double;
    const auto refine = [&] { refiner.RefineUniform({.max_level = kLevels}); };
    const auto clear = [&] {
        refiner.RefineUniform({.max_level = 0});
        stencils_float.reset();
        stencils_double.reset();
    };
    for (int n_threads : settings.ThreadCounts()) {
        const auto name = [](const char* what, int n) { return std::string(what) + ", " + std::to_string(n) + "T"; };
        const auto add = [&](const char* what, std::function<void()> run, double bytes_of_tables) {
            race.Add({.name = name(what, n_threads),
                      .n_threads = n_threads,
                      .run = std::move(run),
                      .work = cells,
                      .unit = "cells",
                      .peers = {n_threads == 1 ? "bare split 1 to 8, nothing else" : name(what, 1)},
                      .moved_bytes = bytes_of_levels - bytes_of_level_0 + bytes_of_tables,
                      .kept_bytes = bytes_of_levels + bytes_of_tables,
                      .clear = clear});
        };
        add("refine", refine, 0);
        add(
            "refine + stencils, float",
            [&] { refine(), stencils_float.emplace(Far::StencilTableReal<float>::Create(refiner, scheme)); },
            bytes_float);
        add(
            "refine + stencils, double",
            [&] { refine(), stencils_double.emplace(Far::StencilTableReal<double>::Create(refiner, scheme)); },
            bytes_double);
    }
    AddEvaluation(race, settings, table_float, shape.positions, "evaluate positions, float");
    AddEvaluation(race, settings, table_double, shape.positions, "evaluate positions, double");
    SetFreed(Freed::GoesBack);
    race.Run(settings.Turns(9));
    return race;
}

}  // namespace SolidSubdiv::Perf
