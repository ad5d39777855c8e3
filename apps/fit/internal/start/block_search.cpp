// SPDX-License-Identifier: Apache-2.0
// First all grids are made and counted; of the best of those the distance between both surfaces is measured.
#include <solidsubdiv/apps/fit/internal/start/block_search.h>

#include <algorithm>
#include <numeric>
#include <optional>
#include <string>

#include <solidsubdiv/kit/geometry/compact_surface.h>
#include <solidsubdiv/sdc/errors.h>
#include <solidsubdiv/sdc/parallel.h>

namespace SolidSubdiv::Fit::Starting {

namespace {

/// What is wrong with a candidate, the worst first; less is better.
struct Faults {
    int off_count = 0;  ///< 0 within 15 %, else the difference in such steps
    Offset off_topology = 0;
    friend auto operator<=>(const Faults&, const Faults&) = default;
};

std::optional<Blocks> MakeBlocks(const InsideGrid& grid, const BlockChoice& choice, const BlockAim& aim) {
    Blocks blocks(grid, choice);
    if (!blocks.Repair()) return {};
    blocks.Trim(aim.topology.n_solids, aim.topology.n_cavities);
    if (blocks.Count().cubes == 0) return {};
    return blocks;
}

Faults FaultsOf(const Blocks& blocks, const BlockAim& aim) {
    const SolidTopology has = blocks.Topology();
    Faults faults;
    const double off = std::abs(1. * aim.count(blocks) / aim.n_control - 1);
    faults.off_count = static_cast<int>(off / .15);
    faults.off_topology = std::abs(has.n_solids - aim.topology.n_solids) +
                          std::abs(has.n_cavities - aim.topology.n_cavities) +
                          std::abs(has.euler - aim.topology.euler) / 2;
    return faults;
}

/// The size of cubes that gives the number, for one place of the grid: counts fall as cubes grow, but for ripples.
double SizeFor(const InsideGrid& grid, const BlockAim& aim) {
    double small = std::cbrt(grid.Volume() / (4. * aim.n_control)), large = 1;
    for (int i = 0; i < 20; ++i) {
        const double size = std::sqrt(small * large);
        const auto blocks = MakeBlocks(grid, {size, {0, 0, 0}, .4, .25}, aim);
        (blocks && aim.count(*blocks) > aim.n_control ? small : large) = size;
    }
    return large;
}

std::vector<BlockChoice> Choices(double size, Index n_control) {
    // Fine grids differ less by their place, and cost more.
    const int n_phases = n_control <= 600 ? 4 : 2;
    std::vector<BlockChoice> choices;
    for (int step = -5; step <= 5; ++step) {
        for (double threshold : {.5, .4, .3}) {
            for (double growth : {1., .25, .12}) {
                for (int p = 0; p < n_phases * n_phases * n_phases; ++p) {
                    const double x = p % n_phases, y = p / n_phases % n_phases, z = p / (n_phases * n_phases);
                    choices.push_back(
                        {size * std::pow(1.04, step), {x / n_phases, y / n_phases, z / n_phases}, threshold, growth});
                }
            }
        }
    }
    return choices;
}

/// The best n of the choices, measured by the points.
std::vector<BlockChoice> Nearest(const std::vector<BlockChoice>& choices, std::size_t n, const InsideGrid& grid,
                                 const BlockAim& aim, const Geometry::ClosestPoints& surface,
                                 std::span<const double> points, std::size_t stride) {
    std::vector<double> distances(choices.size());
    Sdc::ParallelFor(static_cast<Offset>(choices.size()), 1, [&](Offset begin, Offset end) {
        for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i) {
            const Blocks::Mesh mesh = MakeBlocks(grid, choices[i], aim)->MakeMesh();
            distances[i] = DistanceBetween(mesh.positions, mesh.quads, 4, surface, points, stride);
        }
    });
    std::vector<std::size_t> order(choices.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t i, std::size_t j) { return distances[i] < distances[j]; });
    std::vector<BlockChoice> nearest;
    for (std::size_t i : order) {
        if (nearest.size() < n) nearest.push_back(choices[i]);
    }
    return nearest;
}

}  // namespace

double DistanceBetween(std::span<const double> positions, std::span<const Index> faces, std::size_t n_corners,
                       const Geometry::ClosestPoints& surface, std::span<const double> surface_points,
                       std::size_t stride) {
    std::vector<Index> triangles;
    for (std::size_t f = 0; f < faces.size(); f += n_corners) {
        for (std::size_t k = 1; k + 1 < n_corners; ++k) {
            triangles.insert(triangles.end(), {faces[f], faces[f + k], faces[f + k + 1]});
        }
    }
    const Geometry::CompactSurface own =
        Geometry::MakeCompactSurface(triangles, static_cast<Index>(positions.size() / 3));
    const std::vector<double> corners = Geometry::GatherRows(positions, 3, own.vertices);
    const auto mean = [stride](const Geometry::ClosestPoints& to, std::span<const double> points) {
        std::vector<double> some;
        for (std::size_t i = 0; i < points.size(); i += 3 * stride) some.insert(some.end(), &points[i], &points[i] + 3);
        double sum = 0;
        for (const auto& n : to.Find(some)) sum += n.distance * n.distance * n.distance * n.distance;
        return sum / (static_cast<double>(some.size()) / 3);
    };
    return mean(Geometry::ClosestPoints(corners, own.corners), surface_points) + mean(surface, corners);
}

std::vector<Blocks> FindBlocks(const InsideGrid& grid, const Geometry::ClosestPoints& surface,
                               std::span<const double> surface_points, const BlockAim& aim, std::size_t n_best,
                               const Progress& progress) {
    const std::vector<BlockChoice> choices = Choices(SizeFor(grid, aim), aim.n_control);
    Report(progress, "start: grids", .1);
    std::vector<std::optional<Faults>> faults(choices.size());
    Sdc::ParallelFor(static_cast<Offset>(choices.size()), 1, [&](Offset begin, Offset end) {
        for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i) {
            if (const auto blocks = MakeBlocks(grid, choices[i], aim)) faults[i] = FaultsOf(*blocks, aim);
        }
    });
    Report(progress, "start: grids", .4);
    std::optional<Faults> least;
    for (const auto& f : faults) {
        if (f && (!least || *f < *least)) least = f;
    }
    if (!least) throw InvalidInput("no grid of cubes fits the target: it encloses too little, or too many pieces");
    std::vector<BlockChoice> best;
    for (std::size_t i = 0; i < choices.size(); ++i) {
        if (faults[i] == least) best.push_back(choices[i]);
    }
    // Few points tell which are worth a closer look.
    best = Nearest(best, 6 * n_best, grid, aim, surface, surface_points, 6);
    Report(progress, "start: grids", .6);
    best = Nearest(best, n_best, grid, aim, surface, surface_points, 1);
    Report(progress, "start: grids", .7);
    std::vector<Blocks> found;
    for (const BlockChoice& choice : best) found.push_back(*MakeBlocks(grid, choice, aim));
    return found;
}

}  // namespace SolidSubdiv::Fit::Starting
