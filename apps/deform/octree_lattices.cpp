// SPDX-License-Identifier: Apache-2.0
// The box of a model, the cells of its finest grid, and the lattices of all grids from them.
#include <solidsubdiv/apps/deform/octree_lattices.h>

#include <algorithm>
#include <cmath>
#include <string>

#include <solidsubdiv/apps/deform/internal/grid_lattice.h>
#include <solidsubdiv/apps/deform/internal/octree_cells.h>
#include <solidsubdiv/apps/deform/internal/shrink.h>
#include <solidsubdiv/sdc/parallel.h>

namespace SolidSubdiv::Deform {

namespace {

using namespace Internal;

constexpr int kMostLevels = 10;
constexpr double kLargestCoordinate = 1e75;
constexpr double kThinnest = .01;       // side of a box, of the longest
constexpr double kLeastLongest = 1e-6;  // longest side, of the largest coordinate

void CheckModel(std::span<const double> points, std::span<const Index> triangles) {
    if (points.size() % 3 != 0 || triangles.size() % 3 != 0) {
        throw InvalidInput(std::to_string(points.size()) + " numbers for points and " +
                           std::to_string(triangles.size()) + " for triangles; must be three each");
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (std::abs(points[i]) <= kLargestCoordinate) continue;
        throw InvalidInput("point " + std::to_string(i / 3) + ": coordinate " + std::to_string(i % 3) + " is " +
                           std::to_string(points[i]) + ", not finite or beyond 1e75");
    }
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        if (triangles[i] >= 0 && static_cast<std::size_t>(triangles[i]) < points.size() / 3) continue;
        throw InvalidInput("triangle " + std::to_string(i / 3) + " names point " + std::to_string(triangles[i]) +
                           " of " + std::to_string(points.size() / 3));
    }
}

/// The points that are meant, in the order given.
std::vector<double> PointsIn(const Geometry::Box& region, std::span<const double> points) {
    std::vector<double> in;
    for (std::size_t i = 0; i < points.size(); i += 3) {
        bool is_in = true;
        for (std::size_t k = 0; k < 3; ++k) {
            is_in = is_in && region.low[k] <= points[i + k] && points[i + k] <= region.high[k];
        }
        if (is_in)
            in.insert(in.end(), points.begin() + static_cast<std::ptrdiff_t>(i),
                      points.begin() + static_cast<std::ptrdiff_t>(i) + 3);
    }
    return in;
}

/// The triangles whose own boxes meet the region.
std::vector<Index> TrianglesNear(const Geometry::Box& region, std::span<const double> points,
                                 std::span<const Index> triangles) {
    std::vector<Index> near;
    for (std::size_t t = 0; t < triangles.size(); t += 3) {
        Geometry::Box box;
        for (std::size_t k = 0; k < 3; ++k) {
            box.Include(points.subspan(3 * static_cast<std::size_t>(triangles[t + k])).first<3>());
        }
        bool meets = true;
        for (std::size_t k = 0; k < 3; ++k)
            meets = meets && box.low[k] <= region.high[k] && region.low[k] <= box.high[k];
        if (meets)
            near.insert(near.end(), triangles.begin() + static_cast<std::ptrdiff_t>(t),
                        triangles.begin() + static_cast<std::ptrdiff_t>(t) + 3);
    }
    return near;
}

/// With padding, and with sides of some length.
Geometry::OrientedBox Widened(Geometry::OrientedBox box, double padding) {
    double longest = std::max({box.lengths[0], box.lengths[1], box.lengths[2]});
    const double reach =
        std::max({std::abs(box.corner[0]), std::abs(box.corner[1]), std::abs(box.corner[2])}) + longest;
    if (!(longest > 0)) longest = 1;
    longest = std::max(longest, kLeastLongest * reach);
    // Middle by middle: a point becomes a cube, anything else keeps its longest side.
    const bool is_point = std::max({box.lengths[0], box.lengths[1], box.lengths[2]}) < kLeastLongest * longest;
    const double least = is_point ? longest : kThinnest * longest;
    std::array<double, 3> before;
    for (std::size_t k = 0; k < 3; ++k) {
        const double length = std::max(box.lengths[k], least) + 2 * padding * longest;
        before[k] = .5 * (box.lengths[k] - length);
        box.lengths[k] = length;
    }
    box.corner = box.At(before);
    return box;
}

Geometry::OrientedBox BoxOf(std::span<const double> points, const OctreeOptions& options) {
    Geometry::OrientedBox box;
    if (options.region && options.box == Geometry::BoxKind::AxisAligned) {
        box.corner = options.region->low;
        for (int k = 0; k < 3; ++k) box.lengths[static_cast<std::size_t>(k)] = options.region->Extent(k);
    } else {
        box = Geometry::MakeBox(points, options.box);
    }
    return Widened(box, options.padding);
}

void RequireBytes(const std::vector<Offset>& n_cells, Offset most) {
    Offset bytes = 0;
    for (std::size_t i = 0; i < n_cells.size(); ++i) {
        const Offset side = (Offset{1} << i) + 1;
        bytes += EstimateBytes(n_cells[i], std::min(side * side * side, 8 * n_cells[i]));
    }
    if (bytes <= most) return;
    throw InvalidInput("lattices to level " + std::to_string(n_cells.size() - 1) + ", with " +
                       std::to_string(n_cells.back()) + " cells, would take " + Far::BytesText(bytes) + " (" +
                       std::to_string(bytes) + " bytes), more than max_bytes; take fewer levels or cut cells");
}

/// Places on the curve of the cells of all levels, from those of the finest.
std::vector<std::vector<std::uint32_t>> PlacesOfLevels(const RankedBits& finest, int levels) {
    std::vector<std::vector<std::uint32_t>> places(static_cast<std::size_t>(levels) + 1);
    finest.ForEach([&](std::uint64_t place) { places.back().push_back(static_cast<std::uint32_t>(place)); });
    for (std::size_t i = places.size() - 1; i > 0; --i) {
        for (std::uint32_t place : places[i]) {
            auto& coarser = places[i - 1];
            if (coarser.empty() || coarser.back() != place / 8) coarser.push_back(place / 8);
        }
    }
    return places;
}

/// The reaches of the vertices in the cells of a level. `parents` and reaches in cells of the next finer level.
std::vector<Reach> Coarser(std::span<const Reach> finer, std::span<const Index> parents, std::size_t n_cells) {
    std::vector<Reach> reaches(n_cells);
    for (std::size_t c = 0; c < finer.size(); ++c) reaches[static_cast<std::size_t>(parents[c])].Include(finer[c]);
    for (Reach& reach : reaches) {
        for (std::size_t k = 0; k < 3; ++k) {
            reach.low[k] *= .5;
            reach.high[k] *= .5;
        }
    }
    return reaches;
}

}  // namespace

Cut CutOf(std::string_view name) {
    if (name == "none") return Cut::None;
    if (name == "vertices") return Cut::Vertices;
    if (name == "triangles") return Cut::Triangles;
    if (name == "outside") return Cut::Outside;
    throw InvalidInput("there is no cut '" + std::string(name) + "'; there are none, vertices, triangles, outside");
}

void OctreeOptions::Validate() const {
    if (levels < 0 || levels > kMostLevels) {
        throw InvalidInput("levels is " + std::to_string(levels) + ", not in [0, " + std::to_string(kMostLevels) + "]");
    }
    if (!(padding >= 0 && padding <= 1e3)) {
        throw InvalidInput("padding is " + std::to_string(padding) + ", not in [0, 1000]");
    }
    if (!(offset >= 0 && offset <= kLargestCoordinate)) {
        throw InvalidInput("offset is " + std::to_string(offset) + ", not in [0, 1e75]");
    }
    if (!region) return;
    for (std::size_t k = 0; k < 3; ++k) {
        const double low = region->low[k], high = region->high[k];
        if (low <= high && low >= -kLargestCoordinate && high <= kLargestCoordinate) continue;
        throw InvalidInput("the region goes from " + std::to_string(low) + " to " + std::to_string(high) +
                           " along axis " + std::to_string(k) + "; must be ascending and within 1e75");
    }
}

LatticeHierarchy MakeOctreeLattices(std::span<const double> points, std::span<const Index> triangles,
                                    const OctreeOptions& options) {
    options.Validate();
    CheckModel(points, triangles);
    const std::size_t n_levels = static_cast<std::size_t>(options.levels) + 1;
    if (options.cut == Cut::None) {
        std::vector<Offset> n_cells(n_levels);
        for (std::size_t i = 0; i < n_levels; ++i) n_cells[i] = Offset{1} << 3 * i;
        RequireBytes(n_cells, options.max_bytes);
    }
    Report(options.progress, "box", 0);
    std::vector<double> points_in;
    std::span<const double> meant = points;
    if (options.region) meant = points_in = PointsIn(*options.region, points);
    if (meant.empty()) throw InvalidInput(options.region ? "no point lies in the region" : "there is no point");
    LatticeHierarchy hierarchy{.box = BoxOf(meant, options), .levels = std::vector<LatticeLevel>(n_levels)};

    Report(options.progress, "cells", .2);
    const Grid grid(hierarchy.box, options.levels);
    const auto in_grid = [&](std::span<const double> some) {
        std::vector<GridPoint> at(some.size() / 3);
        Sdc::ParallelFor(static_cast<Offset>(at.size()), 4096, [&](Offset begin, Offset end) {
            for (Offset i = begin; i < end; ++i) {
                at[static_cast<std::size_t>(i)] = grid.At(some.subspan(3 * static_cast<std::size_t>(i)).first<3>());
            }
        });
        return at;
    };
    const std::vector<GridPoint> vertices = in_grid(meant);
    RankedBits finest(grid.n_cells());
    if (options.cut == Cut::None) {
        for (std::uint64_t i = 0; i < grid.n_cells(); ++i) finest.Insert(i);
    } else {
        InsertPoints(grid, vertices, finest);
    }
    if ((options.cut == Cut::Triangles || options.cut == Cut::Outside) && !triangles.empty()) {
        double largest = 0;
        for (double x : points) largest = std::max(largest, std::abs(x));
        GridPoint tolerance;
        for (std::size_t k = 0; k < 3; ++k) {
            // 64 units of rounding, as points are located with (geometry/locator.h).
            tolerance[k] = 64 * std::numeric_limits<double>::epsilon() * largest / hierarchy.box.lengths[k] * grid.n();
        }
        if (options.region) {
            InsertTriangles(grid, in_grid(points), TrianglesNear(*options.region, points, triangles), tolerance,
                            finest);
        } else {
            InsertTriangles(grid, vertices, triangles, tolerance, finest);
        }
    }
    if (options.cut == Cut::Outside) {
        Report(options.progress, "enclosed cells", .4);
        InsertEnclosed(grid, finest);
    }
    std::vector<Offset> n_cells(n_levels);
    n_cells.back() = finest.Number();
    RequireBytes(n_cells, options.max_bytes);  // before there are as many of anything
    const auto places = PlacesOfLevels(finest, options.levels);
    for (std::size_t i = 0; i < n_levels; ++i) n_cells[i] = static_cast<Offset>(places[i].size());
    RequireBytes(n_cells, options.max_bytes);

    Report(options.progress, "lattices", .6);
    std::optional<GridCorners> before;  // of the level before
    for (std::size_t i = 0; i < n_levels; ++i) {
        LatticeLevel& level = hierarchy.levels[i];
        for (std::uint32_t place : places[i]) level.cells.push_back(CellAt(place));
        Index parent = 0;
        for (std::size_t c = 0; i > 0 && c < places[i].size(); ++c) {
            while (places[i - 1][static_cast<std::size_t>(parent)] != places[i][c] / 8) ++parent;
            level.parents.push_back(parent);
        }
        GridCorners corners(level.cells, static_cast<int>(i));
        level.lattice = MakeGridLattice(hierarchy.box, static_cast<int>(i), level.cells, corners);
        if (before) level.octree_rule = OctreeRule(corners, *before);
        before = std::move(corners);
    }
    if (!options.shrink) return hierarchy;

    Report(options.progress, "shrink", .8);
    std::vector<Reach> reaches(hierarchy.levels.back().cells.size());
    for (const GridPoint& point : vertices) {
        reaches[static_cast<std::size_t>(finest.RankOf(CurvePlace(grid.CellOf(point))))].Include({point, point});
    }
    for (std::size_t i = n_levels; i-- > 0;) {
        Shrink(hierarchy.box, static_cast<int>(i), reaches, options.offset, hierarchy.levels[i]);
        if (i > 0) reaches = Coarser(reaches, hierarchy.levels[i].parents, hierarchy.levels[i - 1].cells.size());
    }
    return hierarchy;
}

}  // namespace SolidSubdiv::Deform
