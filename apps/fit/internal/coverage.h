// SPDX-License-Identifier: Apache-2.0
// Where a target says something: over the holes of a scan its nearest point is only the way to their border.
#pragma once

#include <array>
#include <vector>

#include <solidsubdiv/apps/fit/control_mesh.h>
#include <solidsubdiv/apps/fit/internal/vec3.h>
#include <solidsubdiv/kit/geometry/closest_point.h>

namespace SolidSubdiv::Fit::Internal {

class Coverage {
  public:
    /// The target must outlive this.
    explicit Coverage(const TargetSurface& target);

    /// Whether the nearest point of the target is no mere end of it: of an open surface one on its border, or one that
    /// looks more than 60 degrees elsewhere, as a neck does to what closes it; of points one that lies to the side of
    /// its normal, farther than its neighbours do.
    /// @param normal of the surface at the point, of any length
    bool Covers(const Geometry::ClosestPoint& nearest, const Vec3& point, const Vec3& normal) const;

  private:
    TargetSurface target_;
    double reach_ = 0;                            ///< of a cloud's points, across their normals
    std::vector<std::array<bool, 3>> is_border_;  ///< of each triangle's edges, from its corners on; none: closed
};

/// The target's normal at an element: of length 1, or 0 where there is none.
Vec3 NormalOf(const TargetSurface& target, Index element);

}  // namespace SolidSubdiv::Fit::Internal
