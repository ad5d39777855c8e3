// SPDX-License-Identifier: Apache-2.0
// The race of dimensions: our solids of hexahedra beside OpenSubdiv's surfaces of quadrilaterals, by what they make:
// components of levels, rows of tables, refined points.
#include "perf/hex_meshes.h"
#include "perf/machine.h"
#include "perf/meshes.h"
#include "perf/open_subdiv.h"
#include "perf/races.h"
#include "perf/solid.h"

namespace SolidSubdiv::Perf {

namespace {

constexpr int kQuadLevels = 3, kHexLevels = 2;

/// What is made of a mesh in all levels but the first.
struct Children {
    double components = 0;  ///< vertices, edges, faces, cells
    double vertices = 0;
};
Children ChildrenOf(const Io::Mesh& mesh, int n_levels) {
    const auto refiner = Far::TopologyRefiner::Create(mesh.topology, Sdc::Split::Polyhedral);
    Children children;
    for (int l = 1; l <= n_levels; ++l) {
        const Vtr::PolyhedralCounts n = refiner.PolyhedralCountsAt(l);
        children.components += static_cast<double>(n.n_vertices + n.n_edges + n.n_faces + n.n_cells());
        children.vertices += static_cast<double>(n.n_vertices);
    }
    return children;
}

Race RaceHexesCatmark(const RaceSettings& settings, Freed freed) {
    Race race(freed == Freed::GoesBack ? "hexes and quads, fresh memory" : "hexes and quads, kept memory");
    const Io::Mesh quads = QuadTorus(settings.is_quick),
                   hexes = HexBall(settings.is_quick ? 7 : 15, settings.is_quick ? 7 : 15);
    race.notes = {"Torus of " + std::to_string(quads.topology.n_quads()) + " quadrilaterals, " +
                      std::to_string(kQuadLevels) + " levels, by OpenSubdiv; ball of " +
                      std::to_string(hexes.topology.n_hexes()) + " hexahedra, " + std::to_string(kHexLevels) +
                      " levels, ours. All levels but the first count. Topology: the last level thin; components are "
                      "vertices, edges, faces and cells. Tables are cascaded, of floats.",
                  freed == Freed::GoesBack
                      ? "Every candidate works on fresh memory: what it frees goes back to the system."
                      : "Every candidate works on memory that the process kept: none pays for fresh pages."};
    const auto add = [&](std::string name, int n_threads, double work, const char* unit, std::vector<std::string> peers,
                         std::function<void()> run, std::function<void()> clear) {
        race.Add({.name = std::move(name),
                  .n_threads = n_threads,
                  .run = std::move(run),
                  .work = work,
                  .unit = unit,
                  .peers = std::move(peers),
                  .clear = std::move(clear)});
    };
    const std::string what[] = {"refine", "stencils", "create + refine + interpolate"};
    const char* const units[] = {"components", "rows", "points"};
    std::vector<std::string> peers(3);

#if SOLIDSUBDIV_HAS_OPENSUBDIV
    const Children quad_children = ChildrenOf(quads, kQuadLevels);
    OpenSubdivSurface theirs(quads.topology, quads.positions, kQuadLevels),
        theirs_ready(quads.topology, quads.positions, kQuadLevels);
    theirs.Create();
    theirs_ready.Create();
    theirs_ready.Refine(false);
    race.notes.push_back(theirs_ready.Describe());
    for (std::size_t i = 0; i < 3; ++i) peers[i] = "OpenSubdiv: " + what[i];
    const auto clear_theirs = [&] { theirs.Clear(); };
    add(
        peers[0], 1, quad_children.components, units[0], {}, [&] { theirs.Refine(false); }, clear_theirs);
    add(
        peers[1], 1, quad_children.vertices, units[1], {},
        [&] {
            theirs_ready.MakeCascaded();
            theirs.TakeTable(theirs_ready);
        },
        clear_theirs);
    add(
        peers[2], 1, quad_children.vertices, units[2], {},
        [&] {
            theirs.Create();
            theirs.Refine(false);
            theirs.Interpolate();
        },
        clear_theirs);
#else
    race.notes.push_back("OpenSubdiv was not there.");
#endif

    const Children hex_children = ChildrenOf(hexes, kHexLevels);
    Solid ours("ball", hexes, kHexLevels), ready("ball", hexes, kHexLevels);
    ours.Clear();
    Offset n_weights = 0;
    const auto table = Far::StencilTableReal<float>::Create(ready.refiner(), Sdc::CatmullClarkSolid{});
    for (int l = 1; l <= kHexLevels; ++l) n_weights += table.level(l).n_weights();
    race.notes.push_back("Weights in ours: " + std::to_string(n_weights) + " cascaded in " +
                         std::to_string(static_cast<Offset>(hex_children.vertices)) + " rows.");
    const auto clear = [&] { ours.Clear(); };
    for (int n_threads : settings.ThreadCounts()) {
        const auto add_ours = [&](std::size_t i, double work, std::function<void()> run) {
            const auto name = [&](int n) { return "hexes: " + what[i] + ", " + std::to_string(n) + "T"; };
            std::vector<std::string> others;
            if (n_threads > 1) others.push_back(name(1));
            if (!peers[i].empty()) others.push_back(peers[i]);
            add(name(n_threads), n_threads, work, units[i], others, std::move(run), clear);
        };
        add_ours(0, hex_children.components, [&] { ours.Refine(); });
        add_ours(1, hex_children.vertices, [&] {
            ready.MakeTable<float>(Sdc::CatmullClarkSolid{});
            ours.TakeTable(ready);
        });
        add_ours(2, hex_children.vertices, [&] {
            ours.Create();
            ours.Refine();
            ours.Interpolate();
        });
    }
    SetFreed(freed);
    race.Run(settings.Turns(7));
    SetFreed(Freed::GoesBack);
    return race;
}

}  // namespace

Race RaceHexesCatmarkFresh(const RaceSettings& settings) { return RaceHexesCatmark(settings, Freed::GoesBack); }
Race RaceHexesCatmarkKept(const RaceSettings& settings) { return RaceHexesCatmark(settings, Freed::IsKept); }

}  // namespace SolidSubdiv::Perf
