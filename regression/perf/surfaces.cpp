// SPDX-License-Identifier: Apache-2.0
// The races of surfaces: 50,000 triangles by three levels of Loop's scheme, as many quadrilaterals by three of Catmull
// and Clark's, beside OpenSubdiv.
#include <optional>

#include <solidsubdiv/far/primvar_refiner.h>
#include <solidsubdiv/far/stencil_table.h>

#include "perf/machine.h"
#include "perf/meshes.h"
#include "perf/open_subdiv.h"
#include "perf/races.h"

namespace SolidSubdiv::Perf {

namespace {

constexpr int kLevels = 3;
using FloatTable = Far::StencilTableReal<float>;

/// What is refined.
struct Surface {
    std::string note{};  ///< about it, for the report
    Far::TopologyDescriptor mesh{};
    std::span<const double> positions{};
    Sdc::Split split{};
    Sdc::Scheme scheme{};
};

/// Ours, as one object that races can fill and empty.
struct Ours {
    const Surface& surface;
    std::optional<Far::TopologyRefiner> refiner{};
    std::optional<FloatTable> table{};
    std::vector<float> values[2]{};

    void Create() { refiner.emplace(Far::TopologyRefiner::Create(surface.mesh, surface.split)); }
    void Refine(bool full) { refiner->RefineUniform({.max_level = kLevels, .full_topology_in_last_level = full}); }
    /// Refines positions level by level; the last are left in values[kLevels % 2].
    void Interpolate() {
        const Far::PrimvarRefiner primvars(*refiner, surface.scheme);
        values[0].assign(surface.positions.begin(), surface.positions.end());
        for (int l = 1; l <= kLevels; ++l) {
            std::vector<float>& fine = values[l % 2];
            fine.resize(3 * static_cast<std::size_t>(refiner->n_vertices(l)));
            primvars.Interpolate<float>(l, values[(l + 1) % 2], fine, 3);
        }
    }
    Index NFaces() const {
        return refiner->is_polyhedral() ? refiner->polyhedral_level(kLevels).n_boundary_faces
                                        : refiner->level(kLevels).n_boundary_faces;
    }
};

double BytesOf(const std::function<void()>& make) {
    const double before = ResidentBytes();
    make();
    return ResidentBytes() - before;
}

Race RaceSurface(const RaceSettings& settings, const std::string& kind, Freed freed, const Surface& surface) {
    Race race(kind + (freed == Freed::GoesBack ? ", fresh memory" : ", kept memory"));
    Ours ours{surface}, ready{surface};
    ready.Create();
    ready.Refine(false);
    const double faces = ready.NFaces();
    race.notes = {surface.note + ", " + std::to_string(kLevels) + " levels: " + std::to_string(ready.NFaces()) +
                      " faces and " + std::to_string(ready.refiner->n_vertices(kLevels)) +
                      " vertices in the last. Faces a second counts those of the last level alone.",
                  freed == Freed::GoesBack
                      ? "Every candidate works on fresh memory: what it frees goes back to the system."
                      : "Every candidate works on memory that the process kept: none pays for fresh pages."};

    const auto add = [&](std::string name, int n_threads, std::vector<std::string> peers, std::function<void()> run,
                         std::function<void()> clear, double bytes) {
        race.Add({.name = std::move(name),
                  .n_threads = n_threads,
                  .run = std::move(run),
                  .work = faces,
                  .unit = "faces",
                  .peers = std::move(peers),
                  .kept_bytes = bytes,
                  .clear = std::move(clear)});
    };
    const auto clear = [&] {
        ours.refiner->RefineUniform({.max_level = 0});
        ours.table.reset();
    };

#if SOLIDSUBDIV_HAS_OPENSUBDIV
    const char* const osd = "OpenSubdiv: ";
    OpenSubdivSurface theirs(surface.mesh, surface.positions, kLevels),
        theirs_ready(surface.mesh, surface.positions, kLevels);
    theirs.Create();
    theirs_ready.Create();
    theirs_ready.Refine(false);
    const auto clear_theirs = [&] { theirs.Clear(); };
    const auto add_theirs = [&](const char* what, std::function<void()> run, bool counts_bytes = true) {
        const double bytes = counts_bytes ? BytesOf(run) : 0;
        clear_theirs();
        add(std::string(osd) + what, 1, {}, std::move(run), clear_theirs, bytes);
    };
    add_theirs(
        "create", [&] { theirs.Create(); }, false);
    add_theirs("refine, minimal", [&] { theirs.Refine(false); });
    add_theirs("refine, full topology", [&] { theirs.Refine(true); });
    add_theirs("stencils, cascaded", [&] {
        theirs_ready.MakeCascaded();
        theirs.TakeTable(theirs_ready);
    });
    add_theirs("stencils, composite", [&] {
        theirs_ready.MakeComposite();
        theirs.TakeTable(theirs_ready);
    });
    add_theirs(
        "create + refine + interpolate",
        [&] {
            theirs.Create();
            theirs.Refine(false);
            theirs.Interpolate();
        },
        false);
    race.notes.push_back(theirs_ready.Describe());
#else
    const char* const osd = "";
    race.notes.push_back("OpenSubdiv was not there.");
#endif

    const FloatTable cascaded = FloatTable::Create(*ready.refiner, surface.scheme);
    Offset n_weights = 0, n_rows = 0;
    for (int l = 1; l <= kLevels; ++l) {
        n_weights += cascaded.level(l).n_weights();
        n_rows += cascaded.level(l).n_rows();
    }
    race.notes.push_back("Weights in ours: " + std::to_string(n_weights) + " cascaded in " + std::to_string(n_rows) +
                         " rows.");
    ours.Create();
    for (int n_threads : settings.ThreadCounts()) {
        const auto add_ours = [&](const std::string& what, std::function<void()> run, bool counts_bytes = true) {
            const double bytes = counts_bytes ? BytesOf(run) : 0;
            clear();
            std::vector<std::string> peers;
            if (n_threads > 1) peers.push_back("ours: " + what + ", 1T");
            if (*osd) peers.push_back(osd + what);
            add("ours: " + what + ", " + std::to_string(n_threads) + "T", n_threads, peers, std::move(run), clear,
                bytes);
        };
        add_ours(
            "create", [&] { ours.Create(); }, false);
        add_ours("refine, minimal", [&] { ours.Refine(false); });
        add_ours("refine, full topology", [&] { ours.Refine(true); });
        add_ours("stencils, cascaded", [&] { ours.table.emplace(FloatTable::Create(*ready.refiner, surface.scheme)); });
        add_ours("stencils, composite", [&] {
            ours.table.emplace(
                FloatTable::CreateComposite(*ready.refiner, surface.scheme, {{.level = kLevels, .vertices = {}}}));
        });
        add_ours(
            "create + refine + interpolate",
            [&] {
                ours.Create();
                ours.Refine(false);
                ours.Interpolate();
            },
            false);
    }

#if SOLIDSUBDIV_HAS_OPENSUBDIV
    // Both must do the same work.
    theirs.Refine(false);
    theirs.Interpolate();
    ours.Refine(false);
    ours.Interpolate();
    SumsOf<float>(ours.values[kLevels % 2], faces).RequireSame(theirs.Sums(), "OpenSubdiv");
    clear();
    clear_theirs();
#endif
    SetFreed(freed);
    race.Run(settings.Turns(7));
    SetFreed(Freed::GoesBack);
    return race;
}

Race RaceTriangles(const RaceSettings& settings, Freed freed) {
    const TestShapes::Shape shape = Torus(settings.is_quick);
    return RaceSurface(settings, "triangles", freed,
                       {"Torus of " + std::to_string(shape.triangles.size() / 3) +
                            " triangles, three in four vertices irregular; Loop",
                        Describe(shape), shape.positions, Sdc::Split::TetOct, Sdc::Loop{}});
}

Race RaceQuads(const RaceSettings& settings, Freed freed) {
    const Io::Mesh mesh = QuadTorus(settings.is_quick);
    return RaceSurface(settings, "quads", freed,
                       {"Torus of " + std::to_string(mesh.topology.n_quads()) +
                            " quadrilaterals, nearly half of the vertices irregular; Catmull-Clark",
                        mesh.topology, mesh.positions, Sdc::Split::Polyhedral, Sdc::CatmullClark{}});
}

}  // namespace

Race RaceTrianglesFresh(const RaceSettings& settings) { return RaceTriangles(settings, Freed::GoesBack); }
Race RaceTrianglesKept(const RaceSettings& settings) { return RaceTriangles(settings, Freed::IsKept); }
Race RaceQuadsFresh(const RaceSettings& settings) { return RaceQuads(settings, Freed::GoesBack); }
Race RaceQuadsKept(const RaceSettings& settings) { return RaceQuads(settings, Freed::IsKept); }

}  // namespace SolidSubdiv::Perf
