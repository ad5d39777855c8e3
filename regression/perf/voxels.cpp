// SPDX-License-Identifier: Apache-2.0
// The race of voxels: level sets of solids, of which the inside is known as well, beside OpenVDB's of their boundary
// alone; and attributes inside, alone. Control meshes are chosen for 110,000 triangles.
#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include <solidsubdiv/apps/voxel/voxelize.h>
#include <solidsubdiv/far/primvar_refiner.h>
#include <solidsubdiv/kit/geometry/box.h>

#include "perf/hex_meshes.h"
#include "perf/meshes.h"
#include "perf/open_vdb.h"
#include "perf/races.h"

namespace SolidSubdiv::Perf {

namespace {

constexpr double kHalfWidth = 3;

/// A solid at its last level.
struct VoxelRace {
    std::string name;
    Far::TopologyRefiner refiner;
    std::vector<double> positions{};
    std::unique_ptr<OpenVdbPeer> peer{};
    std::optional<Voxel::Grids> grids{};

    int level() const { return refiner.max_level(); }

    void Refine(const Sdc::Scheme& scheme, int n_levels, std::vector<double> control) {
        refiner.RefineUniform({.max_level = n_levels});
        const Far::PrimvarRefiner primvars(refiner, scheme);
        positions = std::move(control);
        for (int l = 1; l <= n_levels; ++l) {
            std::vector<double> fine(3 * static_cast<std::size_t>(refiner.n_vertices(l)));
            primvars.Interpolate<double>(l, positions, fine, 3);
            positions = std::move(fine);
        }
    }
    /// The boundary, quadrilaterals cut in two.
    std::vector<Index> Triangles() const {
        std::vector<Index> triangles;
        const auto add = [&](std::span<const Index> face) {
            for (std::size_t k = 2; k < face.size(); ++k) {
                triangles.insert(triangles.end(), {face[0], face[k - 1], face[k]});
            }
        };
        if (refiner.is_polyhedral()) {
            const auto& l = refiner.polyhedral_level(level());
            for (Index f = 0; f < l.n_boundary_faces; ++f) add(l.BoundaryVertices(f));
        } else {
            const auto& l = refiner.level(level());
            for (Index f = 0; f < l.n_boundary_faces; ++f) add(l.BoundaryVertices(f));
        }
        return triangles;
    }
    double LongestSide() const {
        const Geometry::Box box = Geometry::BoundingBox(positions);
        return std::max({box.Extent(0), box.Extent(1), box.Extent(2)});
    }
};

void AddSolid(Race& race, const RaceSettings& settings, const std::shared_ptr<VoxelRace>& s) {
    const std::vector<Index> triangles = s->Triangles();
    s->peer = std::make_unique<OpenVdbPeer>(s->positions, triangles);
    race.notes.push_back(s->name + ": " + std::to_string(s->refiner.n_cells(s->level())) + " cells, " +
                         std::to_string(triangles.size() / 3) + " triangles around them.");
    for (const int resolution : settings.is_quick ? std::vector{64} : std::vector{256, 512}) {
        const double size = s->LongestSide() / resolution;
        const auto ours = [s, size] {
            s->grids =
                Voxel::Voxelize(s->refiner, s->level(), s->positions, {.voxel_size = size, .half_width = kHalfWidth});
        };
        ours();
        const Voxel::GridInfo info = s->grids->Describe()[0];
        s->grids.reset();
        for (const int n_threads : settings.ThreadCounts()) {
            const std::string box = s->name + ", " + std::to_string(resolution) + "^3";
            const auto name = [&](const char* what, int n) {
                return box + ": " + what + ", " + std::to_string(n) + "T";
            };
            std::vector<std::string> peers{name("meshToLevelSet", n_threads)};
            if (n_threads > 1) peers.push_back(name("ours", 1));
            const auto work = static_cast<double>(info.active_voxels);
            race.Add({.name = name("ours", n_threads),
                      .n_threads = n_threads,
                      .run = ours,
                      .work = work,
                      .unit = "voxels",
                      .peers = peers,
                      .kept_bytes = static_cast<double>(info.bytes),
                      .clear = [s] { s->grids.reset(); }});
            race.Add({.name = name("meshToLevelSet", n_threads),
                      .n_threads = n_threads,
                      .run = [s, size, n_threads] { s->peer->MeshToLevelSet(size, kHalfWidth, n_threads); },
                      .work = work,
                      .unit = "voxels",
                      .clear = [s] { s->peer->Clear(); }});
        }
    }
    // What is inside, alone: one attribute of one number.
    const auto values = std::make_shared<std::vector<double>>();
    for (std::size_t i = 0; i < s->positions.size(); i += 3) values->push_back(s->positions[i]);
    for (const int resolution : settings.is_quick ? std::vector{64} : std::vector{256, 512}) {
        const double size = s->LongestSide() / resolution;
        const auto inside = [s, size, values] {
            s->grids = Voxel::Voxelize(
                s->refiner, s->level(), s->positions,
                {.voxel_size = size, .kind = Voxel::Kind::None, .attributes = {{.name = "x", .values = *values}}});
        };
        inside();
        const Voxel::GridInfo info = s->grids->Describe()[0];
        s->grids.reset();
        race.notes.push_back(s->name + ", " + std::to_string(resolution) + "^3: " + std::to_string(info.active_voxels) +
                             " voxels inside, " + std::to_string(info.active_voxels / s->refiner.n_cells(s->level())) +
                             " a cell.");
        for (const int n_threads : settings.ThreadCounts()) {
            race.Add({.name = s->name + ", " + std::to_string(resolution) + "^3: an attribute alone, " +
                              std::to_string(n_threads) + "T",
                      .n_threads = n_threads,
                      .run = inside,
                      .work = static_cast<double>(info.active_voxels),
                      .unit = "voxels inside",
                      .kept_bytes = static_cast<double>(info.bytes),
                      .clear = [s] { s->grids.reset(); }});
        }
    }
}

}  // namespace

Race RaceVoxels(const RaceSettings& settings) {
    Race race("voxels");
    race.notes.push_back("Level sets of half-width 3. OpenVDB's meshToLevelSet takes the boundary alone.");
    const Io::Mesh ball = HexBall(6, 1);
    const auto hexes = std::make_shared<VoxelRace>(
        VoxelRace{"hexes", Far::TopologyRefiner::Create(ball.topology, Sdc::Split::Polyhedral)});
    hexes->Refine(Sdc::CatmullClarkSolid{}, settings.is_quick ? 2 : 4, ball.positions);
    AddSolid(race, settings, hexes);

    TestShapes::Shape block = TestShapes::KuhnBlock(settings.is_quick ? 3 : 12);
    TestShapes::Jitter(block, 0.1, 1);
    const auto tets = std::make_shared<VoxelRace>(
        VoxelRace{"tets", Far::TopologyRefiner::Create(Describe(block), Sdc::Split::TetOct)});
    tets->Refine(Sdc::BoxSpline{}, settings.is_quick ? 2 : 3, block.positions);
    AddSolid(race, settings, tets);

    race.Run(settings.Turns(3));
    return race;
}

}  // namespace SolidSubdiv::Perf
