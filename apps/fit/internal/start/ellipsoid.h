// SPDX-License-Identifier: Apache-2.0
// A surface that stands for a cloud of points: the ellipsoid in their oriented box.
#pragma once

#include <span>
#include <vector>

#include <solidsubdiv/sdc/types.h>

namespace SolidSubdiv::Fit::Starting {

struct Ellipsoid {
    std::vector<double> positions;  ///< (n, 3)
    std::vector<Index> triangles;   ///< (m, 3), counterclockwise from outside
};

/// An octahedron whose faces are cut in four again and again, 4096 triangles at least and some ten a control point,
/// blown up to a sphere and scaled to the box. Sides shorter than a hundredth of the longest are widened to that.
/// @pre two different points. @throws InvalidInput as Geometry::MakeBox
Ellipsoid MakeEllipsoid(std::span<const double> points, Index n_control);

}  // namespace SolidSubdiv::Fit::Starting
