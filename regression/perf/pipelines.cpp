// SPDX-License-Identifier: Apache-2.0
// The race of whole pipelines: 50,000 triangles by three levels of Loop's and of the butterfly scheme, from arrays to
// arrays, beside OpenSubdiv, OpenMesh, CGAL and VTK.
#include <memory>
#include <optional>

#include <solidsubdiv/far/primvar_refiner.h>
#include <solidsubdiv/far/stencil_table.h>
#include <solidsubdiv/osd/backends.h>
#include <solidsubdiv/osd/evaluator.h>

#include "perf/machine.h"
#include "perf/meshes.h"
#include "perf/open_subdiv.h"
#include "perf/races.h"
#include "perf/surface_peers.h"

namespace SolidSubdiv::Perf {

namespace {

constexpr int kLevels = 3;

/// Ours, from nothing at every run: the triangles are left in the refiner's last level, the points in values.
template <class Real>
struct Ours {
    const TestShapes::Shape& shape;
    Sdc::Scheme scheme;
    std::optional<Far::TopologyRefiner> refiner{};
    Array<Real> values[2]{};  // the last level's in the first

    void Refine() {
        refiner.emplace(Far::TopologyRefiner::Create(Describe(shape), Sdc::Split::TetOct));
        refiner->RefineUniform({.max_level = kLevels});
        values[1].assign(shape.positions.begin(), shape.positions.end());
    }
    std::size_t Size(int level) const { return 3 * static_cast<std::size_t>(refiner->level(level).n_vertices); }
    /// Rows made, applied and forgotten.
    void RunByRefiner() {
        static_assert(kLevels % 2 == 1);
        Refine();
        const Far::PrimvarRefiner primvars(*refiner, scheme);
        for (int l = 1; l <= kLevels; ++l) {
            Array<Real>& fine = values[1 - l % 2];
            fine.resize(Size(l));
            primvars.Interpolate<Real>(l, values[l % 2], fine, 3);
        }
    }
    /// Rows kept in tables, as for values that change.
    void RunByTable() {
        Refine();
        const auto table = Far::StencilTableReal<Real>::Create(*refiner, scheme);
        values[0].resize(Size(kLevels));
        Osd::EvaluatorReal<Real>(table, Osd::Backend::Best()).Evaluate(values[1], values[0]);
    }
    PointSums Sums() const { return SumsOf<Real>(values[0], refiner->level(kLevels).n_boundary_faces); }
    void Clear() {
        refiner.reset();
        for (Array<Real>& v : values) v = {};
    }
};

template <class Real>
void AddOurs(std::vector<SurfacePipeline>& pipelines, const TestShapes::Shape& shape, const Sdc::Scheme& scheme,
             const char* real) {
    const auto ours = std::make_shared<Ours<Real>>(Ours<Real>{shape, scheme});
    const auto add = [&](const char* how, std::function<void()> run) {
        pipelines.push_back({.name = std::string("ours, ") + how + ", " + real,
                             .run = std::move(run),
                             .run_apart = {},
                             .sums = [ours] { return ours->Sums(); },
                             .clear = [ours] { ours->Clear(); }});
    };
    add("PrimvarRefiner", [ours] { ours->RunByRefiner(); });
    add("StencilTable + Evaluator", [ours] { ours->RunByTable(); });
}

#if SOLIDSUBDIV_HAS_OPENSUBDIV
SurfacePeers OpenSubdivPeers(const TestShapes::Shape& shape) {
    const auto theirs = std::make_shared<OpenSubdivSurface>(Describe(shape), shape.positions, kLevels);
    SurfacePeers peers;
    peers.loop.push_back({.name = "OpenSubdiv, float",
                          .run =
                              [theirs] {
                                  theirs->Create();
                                  theirs->Refine(false);
                                  theirs->Interpolate();
                              },
                          .run_apart = {},
                          .sums = [theirs] { return theirs->Sums(); },
                          .clear = [theirs] { theirs->Clear(); }});
    return peers;
}
#else
SurfacePeers OpenSubdivPeers(const TestShapes::Shape&) { return {.missing = "OpenSubdiv was not there."}; }
#endif

/// Adds one scheme's candidates, after a check that all of them do the same work.
void AddScheme(Race& race, const RaceSettings& settings, const TestShapes::Shape& shape, const std::string& name,
               const Sdc::Scheme& scheme, const std::vector<SurfacePipeline>& peers) {
    std::vector<SurfacePipeline> ours;
    AddOurs<float>(ours, shape, scheme, "float");
    AddOurs<double>(ours, shape, scheme, "double");
    ours.back().run();
    const PointSums truth = ours.back().sums();
    const auto add = [&](const SurfacePipeline& p, const std::string& label, int n_threads,
                         std::vector<std::string> others) {
        p.run ? p.run() : static_cast<void>(p.run_apart());
        truth.RequireSame(p.sums(), p.name);
        if (p.clear) p.clear();
        race.Add({.name = label,
                  .n_threads = n_threads,
                  .run = p.run,
                  .run_apart = p.run_apart,
                  .work = truth.n_faces,
                  .unit = "triangles",
                  .peers = std::move(others),
                  .clear = p.clear});
    };
    std::vector<std::string> peer_names;
    for (const SurfacePipeline& p : peers) {
        peer_names.push_back(name + ": " + p.name);
        add(p, peer_names.back(), 1, {});
    }
    for (int n_threads : settings.ThreadCounts()) {
        for (const SurfacePipeline& p : ours) {
            const auto label = [&](int n) { return name + ": " + p.name + ", " + std::to_string(n) + "T"; };
            std::vector<std::string> others = peer_names;
            if (n_threads > 1) others.insert(others.begin(), label(1));
            add(p, label(n_threads), n_threads, std::move(others));
        }
    }
}

Race RacePipelines(const RaceSettings& settings, const char* title, Freed freed) {
    Race race(title);
    const TestShapes::Shape shape = Torus(settings.is_quick);
    race.notes = {"Torus of " + std::to_string(shape.triangles.size() / 3) +
                      " triangles, three in four vertices irregular; " + std::to_string(kLevels) +
                      " levels. From positions and triangles in arrays to refined ones in memory; triangles a second "
                      "counts those of the last level alone. Points and triangles of all candidates were compared.",
                  freed == Freed::GoesBack
                      ? "Every candidate works on fresh memory: what it frees goes back to the system."
                      : "Every candidate works on memory that the process kept: none pays for fresh pages."};
    std::vector<SurfacePipeline> loop, butterfly;
    for (const SurfacePeers& peers : {OpenSubdivPeers(shape), CgalPeers(shape, kLevels), OpenMeshPeers(shape, kLevels),
                                      VtkPeers(shape, kLevels, freed)}) {
        loop.insert(loop.end(), peers.loop.begin(), peers.loop.end());
        butterfly.insert(butterfly.end(), peers.butterfly.begin(), peers.butterfly.end());
        if (!peers.missing.empty()) race.notes.push_back(peers.missing);
    }
    AddScheme(race, settings, shape, "butterfly", Sdc::ModifiedButterfly{}, butterfly);
    AddScheme(race, settings, shape, "Loop", Sdc::Loop{}, loop);
    SetFreed(freed);
    race.Run(settings.Turns(7));
    SetFreed(Freed::GoesBack);
    return race;
}

}  // namespace

Race RacePipelinesFresh(const RaceSettings& settings) {
    return RacePipelines(settings, "pipelines, fresh memory", Freed::GoesBack);
}
Race RacePipelinesKept(const RaceSettings& settings) {
    return RacePipelines(settings, "pipelines, kept memory", Freed::IsKept);
}

}  // namespace SolidSubdiv::Perf
