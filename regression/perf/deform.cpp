// SPDX-License-Identifier: Apache-2.0
// The races of free-form deformation: models of 495 to a million vertices in octree lattices of levels 0 to 5, all of
// their control points moved or one, beside classic deformations; and what embedding takes.
#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <stdexcept>

#include <solidsubdiv/apps/deform/deformer.h>
#include <solidsubdiv/apps/deform/octree_lattices.h>
#include <solidsubdiv/kit/io/formats.h>

#include "perf/ffd_peers.h"
#include "perf/machine.h"
#include "perf/meshes.h"
#include "perf/races.h"

namespace SolidSubdiv::Perf {

namespace {

struct Model {
    std::string name;
    std::vector<double> points;  ///< (n, 3)
    double n() const { return static_cast<double>(points.size() / 3); }
    int Times() const { return std::max(1, static_cast<int>(1e6 / n())); }  // a turn lasts some milliseconds
};

/// A ball with waves, its points along a spiral.
Model WavyBall(int n) {
    Model model{std::to_string(n) + " vertices", {}};
    const double turn = std::numbers::pi * (3 - std::sqrt(5.0));
    for (int i = 0; i < n; ++i) {
        const double z = 1 - (2 * i + 1.0) / n, r = std::sqrt(1 - z * z);
        const double x = r * std::cos(turn * i), y = r * std::sin(turn * i);
        const double size = 1 + 0.2 * std::sin(7 * x) * std::sin(6 * y) * std::sin(5 * z + 1);
        model.points.insert(model.points.end(), {size * x, size * y, size * z});
    }
    return model;
}

Deform::EmbedOptions Refined(int levels) { return {.scheme = Sdc::CatmullClarkSolid{}, .levels = levels}; }

/// How often lattices of a level are refined.
std::vector<int> RefinementsOf(int level) { return level < 4 ? std::vector{2} : std::vector{1, 2}; }

std::vector<int> LevelsOf(const RaceSettings& settings) {
    return settings.is_quick ? std::vector{0, 3} : std::vector{0, 1, 2, 3, 4, 5};
}

template <class Real>
const char* NameOfReal() {
    return sizeof(Real) == 4 ? "float" : "double";
}

template <class To, class From>
std::vector<To> Converted(const std::vector<From>& from) {
    return std::vector<To>(from.begin(), from.end());
}

/// An embedded model in one precision, its control points moved.
template <class Real>
struct Session {
    Session(const Deform::Embedding& embedding, const std::vector<double>& at_rest,
            std::shared_ptr<std::vector<Real>> moved_points)
        : deformer(embedding), control(Converted<Real>(at_rest)), points(std::move(moved_points)) {
        for (std::size_t i = 0; i < control.size(); ++i) {
            control[i] += Real(0.02) * std::sin(static_cast<Real>(i));
        }
        const Index n = embedding.n_control_points(), n_dragged = std::min<Index>(n, 32);
        for (Index i = 0; i < n_dragged; ++i) dragged.push_back(static_cast<Index>(Offset{i} * n / n_dragged));
        deformer.Deform(control, *points);
    }
    void Deform() { deformer.Deform(control, *points); }
    /// Each control point there and back, one at a time. @return points moved, all together
    std::size_t Drag() {
        std::size_t n_moved = 0;
        for (const Index& p : dragged) {
            Real& x = control[3 * static_cast<std::size_t>(p)];
            const Real before = x;
            for (const Real to : {before + Real(0.1), before}) {
                x = to;
                n_moved += deformer.Update({&p, 1}, control, *points).size();
            }
        }
        return n_moved;
    }
    double n_drags() const { return 2.0 * static_cast<double>(dragged.size()); }
    double MovedBytes() const {
        return static_cast<double>(deformer.Bytes()) +
               static_cast<double>(sizeof(Real) * (control.size() + points->size()));
    }

    Deform::DeformerReal<Real> deformer;
    std::vector<Real> control;
    std::shared_ptr<std::vector<Real>> points;
    std::vector<Index> dragged;
};

std::string WithThreads(const std::string& name, int n) { return name + ", " + std::to_string(n) + "T"; }

const char* const kBernstein = "Bernstein FFD, 4^3 control points, float";
std::string SplineName(int level) {
    return "B-spline FFD, " + std::to_string((1 << level) + 3) + "^3 control points, float";
}

/// A peer, held to leave its points where they are while its control points are at rest.
template <class Ffd>
void AddPeer(Race& race, const RaceSettings& settings, const Model& model, const std::string& name, Ffd peer) {
    struct Shared {
        Ffd ffd;
        Array<float> control;
        std::vector<float> points;
    };
    const auto s = std::make_shared<Shared>(Shared{std::move(peer), {}, Converted<float>(model.points)});
    s->control = s->ffd.ControlPoints();
    s->ffd.Deform(s->control, s->points);
    for (std::size_t i = 0; i < model.points.size(); ++i) {
        // Sums of 64 terms of size 1.
        if (!(std::abs(s->points[i] - model.points[i]) < 1e-5)) throw std::runtime_error(name + " moves its points");
    }
    for (int n_threads : settings.ThreadCounts()) {
        race.Add({.name = WithThreads(name, n_threads),
                  .n_threads = n_threads,
                  .run = [s] { s->ffd.Deform(s->control, s->points); },
                  .times = model.Times(),
                  .work = model.n(),
                  .unit = "points",
                  // Control points are few, or not all are near the model.
                  .moved_bytes = s->ffd.Bytes() + static_cast<double>(sizeof(float) * s->points.size()),
                  .kept_bytes = s->ffd.Bytes()});
    }
}

/// How many points the moves of a candidate move, each.
using MovedPoints = std::vector<std::pair<std::string, double>>;

template <class Real>
void AddSession(Race& race, const RaceSettings& settings, const Model& model, const std::string& lattice, int level,
                const std::shared_ptr<Session<Real>>& s, MovedPoints& moved) {
    const std::string name = lattice + ", " + NameOfReal<Real>();
    for (int n_threads : settings.ThreadCounts()) {
        std::vector<std::string> peers;
        if (n_threads > 1) peers.push_back(WithThreads(name, 1));
        if (sizeof(Real) == sizeof(float)) {
            peers.push_back(WithThreads(kBernstein, n_threads));
            peers.push_back(WithThreads(SplineName(level), n_threads));
        }
        race.Add({.name = WithThreads(name, n_threads),
                  .n_threads = n_threads,
                  .run = [s] { s->Deform(); },
                  .times = model.Times(),
                  .work = model.n(),
                  .unit = "points",
                  .peers = std::move(peers),
                  .moved_bytes = s->MovedBytes(),
                  .kept_bytes = static_cast<double>(s->deformer.Bytes())});
    }
    char text[120];
    const double bytes = static_cast<double>(s->deformer.Bytes()) / model.n(),
                 own = static_cast<double>(s->deformer.PointBytes()) / model.n();
    std::snprintf(text, sizeof text, ": %.1f bytes a vertex: %.1f for its place, %.1f for the refined lattice", bytes,
                  own, bytes - own);
    race.notes.push_back(name + text);
    const std::string one = name + ", one control point";
    moved.push_back({one, static_cast<double>(s->Drag()) / s->n_drags()});
    race.Add({.name = one, .run = [s] { s->Drag(); }, .work = s->n_drags(), .unit = "moves"});
}

/// What tables do not say: updates a second, microseconds a move.
void AddFigures(Race& race, const MovedPoints& moved) {
    for (const Result& r : race.results()) {
        char text[160];
        const double seconds = r.median_seconds;
        const auto at = std::find_if(moved.begin(), moved.end(),
                                     [&](const auto& entry) { return entry.first == r.candidate.name; });
        if (at != moved.end()) {
            const double each = seconds / r.candidate.work;
            std::snprintf(text, sizeof text, ": %.2f us a move, %.0f vertices, %.1f ns a vertex", each * 1e6,
                          at->second, each * 1e9 / std::max(at->second, 1.0));
        } else if (r.candidate.unit == "points") {
            std::snprintf(text, sizeof text, ": %.4g updates/s, %.4g ms", 1 / seconds, seconds * 1e3);
        } else {
            continue;
        }
        race.notes.push_back(r.candidate.name + text);
    }
}

Race RaceModel(const RaceSettings& settings, const Model& model) {
    Race race("deform, " + model.name);
    SetFreed(Freed::IsKept);
    MovedPoints moved;
    const auto points = Converted<float>(model.points);
    AddPeer(race, settings, model, kBernstein, BernsteinFfd(points));
    const auto floats = std::make_shared<std::vector<float>>(points);
    const auto doubles = std::make_shared<std::vector<double>>(model.points);
    const auto lattices = Deform::MakeOctreeLattices(model.points, {}, {.levels = LevelsOf(settings).back()});
    for (int level : LevelsOf(settings)) {
        AddPeer(race, settings, model, SplineName(level), SplineFfd(points, 1 << level));
        const Deform::ControlLattice& lattice = lattices.levels[static_cast<std::size_t>(level)].lattice;
        for (int levels : RefinementsOf(level)) {
            const std::string name = "level " + std::to_string(level) + ", refined " + std::to_string(levels) + "x";
            const auto embedding =
                Deform::Embedding::Create(lattice.View(), lattice.positions, model.points, Refined(levels));
            Offset n_terms = 0;
            for (const auto& rows : embedding.tables().cascade) n_terms += rows.n_weights();
            race.notes.push_back(name + ": " + std::to_string(lattice.n_cells()) + " cells, " +
                                 std::to_string(lattice.n_control_points()) + " control points; refined, " +
                                 std::to_string(embedding.tables().hexes.n_cells()) + " cells that hold vertices, of " +
                                 std::to_string(embedding.tables().n_patch_points()) + " points, sums of " +
                                 std::to_string(n_terms) + " terms all together; " +
                                 std::to_string(embedding.outside().size()) + " vertices outside.");
            AddSession(race, settings, model, name, level,
                       std::make_shared<Session<float>>(embedding, lattice.positions, floats), moved);
            AddSession(race, settings, model, name, level,
                       std::make_shared<Session<double>>(embedding, lattice.positions, doubles), moved);
        }
    }
    race.Run(settings.Turns(11));
    AddFigures(race, moved);
    return race;
}

}  // namespace

Race RaceDeform(const RaceSettings& settings, int n_vertices) {
    return RaceModel(settings, WavyBall(settings.is_quick ? std::max(495, n_vertices / 10) : n_vertices));
}

Race RaceDeformKoala(const RaceSettings& settings) {
    const std::filesystem::path path = LocalMesh("surfaces/ode_koala.obj");
    if (std::filesystem::exists(path)) {
        const Io::Mesh mesh = Io::ReadMesh(path);
        return RaceModel(settings,
                         {"koala, " + std::to_string(mesh.topology.n_vertices) + " vertices", mesh.positions});
    }
    Race race("deform, koala");
    race.notes.push_back("Skipped: " + path.string() + " was not there (SOLIDSUBDIV_DATA).");
    return race;
}

Race RaceEmbedding(const RaceSettings& settings) {
    struct Shared {
        Model model;
        Deform::ControlLattice lattice;
        std::optional<Deform::Embedding> embedding{};
        std::optional<Deform::DeformerReal<float>> deformer{};
        std::vector<float> control{}, points{};
    };
    Race race("deform, embedding");
    SetFreed(Freed::IsKept);
    for (int n : {53417, 1000000}) {
        const Model model = WavyBall(settings.is_quick ? n / 10 : n);
        for (int level : LevelsOf(settings)) {
            const auto make = [points = model.points, level] {
                return Deform::MakeOctreeLattices(points, {}, {.levels = level}).levels.back().lattice;
            };
            const auto s = std::make_shared<Shared>(Shared{model, make()});
            s->control = Converted<float>(s->lattice.positions);
            s->points = Converted<float>(model.points);
            const std::string name = model.name + ", level " + std::to_string(level);
            for (int n_threads : settings.ThreadCounts()) {
                race.Add({.name = WithThreads(name + ", lattices up to it", n_threads),
                          .n_threads = n_threads,
                          .run = [s, make] { s->lattice = make(); },
                          .work = model.n(),
                          .unit = "points"});
            }
            for (int levels : RefinementsOf(level)) {
                const std::string refined = name + ", refined " + std::to_string(levels) + "x, embedding";
                const auto embed = [s, levels] {
                    s->embedding = Deform::Embedding::Create(s->lattice.View(), s->lattice.positions, s->model.points,
                                                             Refined(levels));
                };
                embed();
                for (int n_threads : settings.ThreadCounts()) {
                    race.Add(
                        {.name = WithThreads(refined, n_threads),
                         .n_threads = n_threads,
                         .run = embed,
                         .work = model.n(),
                         .unit = "points",
                         .peers = n_threads > 1 ? std::vector{WithThreads(refined, 1)} : std::vector<std::string>{},
                         .kept_bytes = static_cast<double>(s->embedding->tables().Bytes())});
                }
            }
            race.Add({.name = name + ", deformer, first update, 1T",
                      .run =
                          [s] {
                              const Index first = 0;
                              s->deformer.emplace(*s->embedding);
                              s->deformer->Deform(s->control, s->points);
                              s->deformer->Update({&first, 1}, s->control, s->points);
                          },
                      .work = model.n(),
                      .unit = "points",
                      .clear = [s] { s->deformer.reset(); }});
        }
    }
    race.Run(settings.Turns(3));
    return race;
}

}  // namespace SolidSubdiv::Perf
