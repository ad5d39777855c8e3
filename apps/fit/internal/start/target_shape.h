// SPDX-License-Identifier: Apache-2.0
// A target as starts see it: at the size of a unit, in the middle, checked.
#pragma once

#include <string>
#include <vector>

#include <solidsubdiv/apps/fit/control_mesh.h>
#include <solidsubdiv/apps/fit/internal/start/blocks.h>
#include <solidsubdiv/kit/geometry/surface_components.h>

namespace SolidSubdiv::Fit::Starting {

struct TargetShape {
    std::vector<double> positions;  ///< that triangles have, the longest side of their box from -1/2 to 1/2
    std::vector<Index> triangles;   ///< turned around where it is closed, its largest component inside out
    bool was_turned = false;
    Vec3 middle{};
    double scale = 1;                                      ///< a unit, in the target's units
    std::vector<Geometry::SurfaceComponent> components{};  ///< of the surface

    /// @throws InvalidInput where there is nothing, a position is not finite or beyond 1e75, a triangle names a point
    /// that is not there or one twice
    explicit TargetShape(const TargetSurface& target);

    /// Triangles that share an edge look to one side of the surface; then they do so from outside.
    bool IsOriented() const { return CountFlippedEdges() == 0; }
    Vec3 NormalOf(Index triangle) const;  ///< of length 1, or zero
    Offset CountBorderEdges() const;
    Offset CountFlippedEdges() const;
    Offset Euler() const;
    /// Components that enclose and components that are cavities of others, by the sign of what they enclose; where
    /// triangles are not oriented all enclose.
    SolidTopology Topology() const;
    /// Back to the target's units and place.
    void Restore(std::vector<double>& points) const;
};

}  // namespace SolidSubdiv::Fit::Starting
