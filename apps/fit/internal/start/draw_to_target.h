// SPDX-License-Identifier: Apache-2.0
// Moves the boundary of a start to its target, little by little, without folding a cell.
#pragma once

#include <span>

#include <solidsubdiv/apps/fit/control_mesh.h>
#include <solidsubdiv/apps/fit/internal/start/target_shape.h>
#include <solidsubdiv/kit/geometry/closest_point.h>

namespace SolidSubdiv::Fit::Starting {

/// What is drawn to.
struct DrawingTarget {
    const TargetShape& shape;
    const Geometry::ClosestPoints& surface;  ///< of the shape's positions and triangles
};

/// Some rounds over the vertices. Of a solid each goes downhill by a step: of the mean distortion of the cells' corners
/// at it (brewer2003mesquite: the inverse mean ratio), which has no bound towards folds, and on the boundary of the
/// squared distance to the target too, which counts more from round to round. Those of a surface alone go half way to
/// the target and to the middle of their neighbours. Vertices look for the target from where they are and from some way
/// outside and inside of the boundary, and prefer what looks the same way: in something thin or beside a gap the
/// nearest may be the other side.
/// @param faces of the boundary, of `n_corners` each, counterclockwise from outside
/// @param size of the order of an edge's length
/// @returns the least quality of a corner; 0 of a surface. @pre it is positive in a solid; so it stays
double DrawToTarget(ControlMesh& mesh, std::span<const Index> faces, std::size_t n_corners, const DrawingTarget& target,
                    double size);

}  // namespace SolidSubdiv::Fit::Starting
