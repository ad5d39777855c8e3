// SPDX-License-Identifier: Apache-2.0
// Starts of cubes: the grid is found, cubes become cells or faces, the boundary is drawn to the target.
#include <solidsubdiv/apps/fit/start.h>

#include <algorithm>
#include <string>
#include <utility>

#include <solidsubdiv/apps/fit/cloud.h>
#include <solidsubdiv/apps/fit/cut_creases.h>
#include <solidsubdiv/apps/fit/internal/start/block_meshes.h>
#include <solidsubdiv/apps/fit/internal/start/block_search.h>
#include <solidsubdiv/apps/fit/internal/start/decimation.h>
#include <solidsubdiv/apps/fit/internal/start/draw_to_target.h>
#include <solidsubdiv/apps/fit/internal/start/ellipsoid.h>
#include <solidsubdiv/apps/fit/internal/start/target_shape.h>
#include <solidsubdiv/far/topology_refiner.h>
#include <solidsubdiv/kit/geometry/cell_quality.h>
#include <solidsubdiv/sdc/parallel.h>

namespace SolidSubdiv::Fit {

using namespace Starting;

namespace {

void RequireClosed(const TargetShape& shape) {
    const Offset n_border = shape.CountBorderEdges();
    if (n_border == 0) return;
    throw InvalidInput("the target is open: " + std::to_string(n_border) +
                       " border edges; a start of cells or quadrilaterals needs a closed surface");
}

/// Corners of hexahedra may be positive although what lies between them is not.
Offset CountFolded(const ControlMesh& mesh) {
    if (mesh.hexes.empty()) return 0;
    const auto refiner = Far::TopologyRefiner::Create(mesh.View(), Sdc::Split::Polyhedral);
    const auto cells = Geometry::MeasureQuality(refiner, 0, mesh.positions);
    return std::count_if(cells.begin(), cells.end(),
                         [](const auto& c) { return c.sign != Geometry::MinimumSign::Positive; });
}

struct Candidate {
    ControlMesh mesh;
    StartReport report;
    double distance = 0;  ///< between its boundary and the target
};

/// The best first. @param made what is known of the target
std::vector<Candidate> MakeBlockStarts(const TargetShape& shape, BlockMeshKind kind, const StartOptions& options,
                                       const StartReport& made) {
    Report(options.progress, "start: inside", 0);
    // Some ten voxels and more across a cube; prefix sums count with 32 bits.
    const int n_voxels = options.n_control <= 2000 ? 128 : 256;
    const InsideGrid grid(shape.positions, shape.triangles, n_voxels, !shape.IsOriented());
    if (grid.IsEmpty()) {
        throw InvalidInput("the target encloses nothing that is thicker than 1/" + std::to_string(n_voxels) +
                           " of its longest side");
    }
    const SolidTopology topology = shape.Topology();
    const auto count = [kind](const Blocks& blocks) { return CountControlPoints(blocks, kind); };
    const Geometry::ClosestPoints target(shape.positions, shape.triangles);
    constexpr std::size_t kSurfacePoints = 600, kMostTried = 16;
    const std::vector<double> points = grid.SurfacePoints(kSurfacePoints);
    const std::vector<Blocks> found =
        FindBlocks(grid, target, points, {options.n_control, count, topology}, kMostTried, options.progress);
    const TargetSurface surface{.positions = shape.positions, .triangles = shape.triangles};
    std::vector<Candidate> candidates(found.size());
    Sdc::ParallelFor(static_cast<Offset>(found.size()), 1, [&](Offset begin, Offset end) {
        for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i) {
            Candidate& candidate = candidates[i];
            BlockMesh m = MakeBlockMesh(found[i], kind);
            StartReport& report = candidate.report = made;
            report.least_quality = DrawToTarget(m.mesh, m.boundary, m.n_corners, {shape, target}, found[i].size());
            report.n_folded = CountFolded(m.mesh);
            const SolidTopology has = found[i].Topology();
            report.n_components = has.n_solids + has.n_cavities;
            report.euler = has.euler;
            report.has_target_topology = has == topology;
            candidate.distance = DistanceBetween(m.mesh.positions, m.boundary, m.n_corners, target, points);
            candidate.mesh = std::move(m.mesh);
            if (options.creases > 0 && kind == BlockMeshKind::Tets)
                CutCreases(candidate.mesh, surface, options.creases);
        }
    });
    std::size_t best = 0;
    for (std::size_t i = 1; i < candidates.size(); ++i) {
        const Offset fewer = candidates[best].report.n_folded - candidates[i].report.n_folded;
        // As good but for rounding: the first. A target with symmetries has many.
        if (fewer > 0 || (fewer == 0 && candidates[i].distance < (1 - 1e-6) * candidates[best].distance)) best = i;
    }
    std::rotate(candidates.begin(), candidates.begin() + static_cast<std::ptrdiff_t>(best),
                candidates.begin() + static_cast<std::ptrdiff_t>(best) + 1);
    std::stable_sort(candidates.begin() + 1, candidates.end(), [](const Candidate& a, const Candidate& b) {
        return std::pair(a.report.n_folded, a.distance) < std::pair(b.report.n_folded, b.distance);
    });
    return candidates;
}

/// Cuts add control points, how many shows when they are made. Handles of the target count more than their number.
std::vector<Candidate> MakeCutStarts(const TargetShape& shape, const StartOptions& options, const StartReport& made) {
    constexpr double kUsual = 0.75, kTooMany = 1.35;
    const auto make = [&](double n_before) {
        StartOptions fewer = options;
        fewer.n_control = std::max(Index{8}, static_cast<Index>(n_before));
        return MakeBlockStarts(shape, BlockMeshKind::Tets, fewer, made);
    };
    std::vector<Candidate> candidates = make(kUsual * options.n_control);
    const double ratio = static_cast<double>(candidates.front().mesh.n_vertices()) / options.n_control;
    const bool has_topology = candidates.front().report.has_target_topology;
    if (has_topology && ratio <= kTooMany) return candidates;
    std::vector<Candidate> others = make(has_topology ? kUsual * options.n_control / ratio : options.n_control);
    return others.front().report.has_target_topology ? others : candidates;
}

ControlMesh MakeBlockStart(const TargetShape& shape, BlockMeshKind kind, const StartOptions& options,
                           StartReport& report) {
    std::vector<Candidate> candidates = MakeBlockStarts(shape, kind, options, report);
    report = candidates.front().report;
    return std::move(candidates.front().mesh);
}

void RequireManifold(const TargetShape& shape) {
    Offset n_edges = 0, n_vertices = 0;
    for (const auto& c : shape.components) {
        n_edges += c.n_non_manifold_edges;
        n_vertices += c.n_non_manifold_vertices;
    }
    const Offset n_flipped = shape.CountFlippedEdges();
    if (n_edges + n_vertices + n_flipped == 0) return;
    throw InvalidInput("the target is no oriented manifold: " + std::to_string(n_edges) +
                       " edges of more than two triangles, " + std::to_string(n_vertices) +
                       " vertices where several fans of triangles meet, " + std::to_string(n_flipped) +
                       " edges whose triangles look against each other; a cage of triangles needs one");
}

ControlMesh MakeDecimatedCage(const TargetShape& shape, const StartOptions& options, StartReport& report) {
    RequireManifold(shape);
    Report(options.progress, "start: decimation", 0);
    const Geometry::ClosestPoints surface(shape.positions, shape.triangles);
    const auto nearest = [&](std::span<const double> points) {
        std::vector<double> places;
        for (const auto& c : surface.Find(points)) places.insert(places.end(), c.position.begin(), c.position.end());
        return places;
    };
    Decimated made = Decimate(shape.positions, shape.triangles, static_cast<std::size_t>(options.n_control), nearest);
    ControlMesh mesh;
    mesh.positions = std::move(made.positions);
    mesh.triangles = std::move(made.triangles);
    const auto components = Geometry::SurfaceComponents(mesh.triangles, mesh.n_vertices());
    report.n_components = static_cast<Offset>(components.size());
    for (const auto& c : components) report.euler += c.EulerCharacteristic();
    report.has_target_topology = report.n_components == report.target_components && report.euler == report.target_euler;
    return mesh;
}

/// A surface that stands for points: their closing, or where nothing seals them an ellipsoid.
Ellipsoid SurfaceAround(const TargetSurface& cloud, const StartOptions& options) {
    if (cloud.positions.size() >= 12) {
        CloudShape shape = ShapeOfCloud(cloud.positions, {}, options.progress);
        if (!shape.triangles.empty()) return {std::move(shape.positions), std::move(shape.triangles)};
    }
    return MakeEllipsoid(cloud.positions, options.n_control);
}

StartReport ReportOn(const TargetShape& shape) {
    StartReport report;
    report.target_components = static_cast<Offset>(shape.components.size());
    report.target_euler = shape.Euler();
    return report;
}

}  // namespace

void StartOptions::Validate() const {
    if (n_control < 8 || n_control > 100000) {
        throw InvalidInput("n_control is " + std::to_string(n_control) + "; must be in [8, 100000]");
    }
    if (!(creases >= 0 && creases < 180)) {
        throw InvalidInput("creases is " + std::to_string(creases) + " degrees; it must be from 0 to below 180");
    }
}

bool LooksInwards(const TargetSurface& target) { return TargetShape(target).was_turned; }

std::vector<ControlMesh> MakeSolidStarts(const TargetSurface& target, const StartOptions& options, int n_most,
                                         std::vector<StartReport>* reports) {
    options.Validate();
    if (n_most < 1) throw InvalidInput("n_most is " + std::to_string(n_most) + "; it must be at least 1");
    const TargetShape shape(target);
    if (shape.triangles.empty()) {
        const Ellipsoid around = SurfaceAround(target, options);
        return MakeSolidStarts({.positions = around.positions, .triangles = around.triangles}, options, n_most,
                               reports);
    }
    RequireClosed(shape);
    const auto kind = options.tets ? BlockMeshKind::Tets : BlockMeshKind::Hexes;
    std::vector<Candidate> candidates = options.tets && options.creases > 0
                                            ? MakeCutStarts(shape, options, ReportOn(shape))
                                            : MakeBlockStarts(shape, kind, options, ReportOn(shape));
    std::vector<ControlMesh> starts;
    if (reports) reports->clear();
    for (Candidate& candidate : candidates) {
        if (static_cast<int>(starts.size()) == n_most) break;
        shape.Restore(candidate.mesh.positions);
        const auto is_same = [&](const ControlMesh& other) { return other.positions == candidate.mesh.positions; };
        if (std::any_of(starts.begin(), starts.end(), is_same)) continue;
        starts.push_back(std::move(candidate.mesh));
        if (reports) reports->push_back(candidate.report);
    }
    return starts;
}

ControlMesh MakeSolidStart(const TargetSurface& target, const StartOptions& options, StartReport* report) {
    std::vector<StartReport> reports;
    std::vector<ControlMesh> starts = MakeSolidStarts(target, options, 1, &reports);
    if (report) *report = reports.front();
    return std::move(starts.front());
}

ControlMesh MakeCage(const TargetSurface& target, const StartOptions& options, StartReport* report) {
    options.Validate();
    const TargetShape shape(target);
    if (shape.triangles.empty()) {
        const Ellipsoid around = SurfaceAround(target, options);
        return MakeCage({.positions = around.positions, .triangles = around.triangles}, options, report);
    }
    StartReport made = ReportOn(shape);
    ControlMesh mesh;
    if (options.quads) {
        RequireClosed(shape);
        mesh = MakeBlockStart(shape, BlockMeshKind::Quads, options, made);
    } else {
        mesh = MakeDecimatedCage(shape, options, made);
    }
    shape.Restore(mesh.positions);
    if (report) *report = made;
    return mesh;
}

}  // namespace SolidSubdiv::Fit
