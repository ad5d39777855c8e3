// SPDX-License-Identifier: Apache-2.0
// What a fit needs to know of a cloud of points: a closed surface near it, and which way its points look.
//
//     const Fit::CloudShape shape = Fit::ShapeOfCloud(points, {});
//     const Fit::ControlMesh lattice = Fit::MakeSolidStart({.positions = shape.positions, .triangles =
//     shape.triangles},
//                                                          {.n_control = 400});
//     const Fit::TargetSurface target{.positions = points, .normals = shape.normals};
//
// The surface is a closing: balls of one radius around all points, what they enclose filled, and then as much taken
// away again from outside as they added.
//
//      . . . .          ( balls )           what they enclose         less the radius
//     .       .   ->   (         )    ->    |###########|      ->       |#######|
//      . . . .          ( balls )           |###########|               |#######|
//
// The radius is the smallest of a few that seals the shape: with too small a one the inside is outside, and next to
// nothing is enclosed. So holes are bridged, by a surface of that radius at most. Single points far away come to
// nothing.
#pragma once

#include <span>
#include <vector>

#include <solidsubdiv/sdc/progress.h>
#include <solidsubdiv/sdc/types.h>

namespace SolidSubdiv::Fit {

struct CloudShape {
    std::vector<double> positions;  ///< (n, 3), of the closed surface
    std::vector<Index> triangles;   ///< (m, 3), counterclockwise from outside; none: no radius seals the cloud
    double radius = 0;              ///< of the balls
    double spacing = 0;             ///< median distance of neighbours
    /// (n_points, 3), of length 1 (0: unknown): those given, turned around if most look inwards; else those of planes
    /// through the twelve nearest points, looking as the surface does next to them.
    std::vector<double> normals;
    bool has_estimated_normals = false, has_turned_normals = false;
};

/// Normals (n_points, 3) or none. Deterministic, for any number of threads. Cost: some seconds at most for 100,000
/// points.
/// @throws InvalidInput where there are fewer than four points, one is not finite, or all coincide; Cancelled
CloudShape ShapeOfCloud(std::span<const double> points, std::span<const double> normals, const Progress& progress = {});

}  // namespace SolidSubdiv::Fit
