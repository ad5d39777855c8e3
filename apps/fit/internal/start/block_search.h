// SPDX-License-Identifier: Apache-2.0
// The grid whose cubes stand best for a solid, with about as many control points as asked for.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include <solidsubdiv/apps/fit/internal/start/blocks.h>
#include <solidsubdiv/kit/geometry/closest_point.h>
#include <solidsubdiv/sdc/progress.h>

namespace SolidSubdiv::Fit::Starting {

/// What is looked for. Not empty: the number of control points that cubes give.
struct BlockAim {
    Index n_control = 300;
    std::function<Index(const Blocks&)> count{};
    SolidTopology topology{};
};

/// Tries some thousand grids of different sizes and places. Among them: those within 15 % of the number before others,
/// then those with the topology, or the nearest to it, then the nearest surface.
/// @param surface_points points (n, 3) of the solid's surface, in [-1/2, 1/2]^3
/// @returns the best, the first of all, at most n_best
/// @throws InvalidInput where no grid does; Cancelled
std::vector<Blocks> FindBlocks(const InsideGrid& grid, const Geometry::ClosestPoints& surface,
                               std::span<const double> surface_points, const BlockAim& aim, std::size_t n_best,
                               const Progress& progress);

/// How far two surfaces are from each other: fourth powers of distances, so that a thin part that is missing weighs
/// more than a coarse fit elsewhere. Of a surface of faces with n_corners each, and one that is given by some points
/// and where it is nearest. Every stride-th point of either is asked.
double DistanceBetween(std::span<const double> positions, std::span<const Index> faces, std::size_t n_corners,
                       const Geometry::ClosestPoints& surface, std::span<const double> surface_points,
                       std::size_t stride = 1);

}  // namespace SolidSubdiv::Fit::Starting
