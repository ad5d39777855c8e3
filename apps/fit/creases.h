// SPDX-License-Identifier: Apache-2.0
// Sharp edges of a target as creases of a control mesh.
//
//     Fit::ControlMesh cage = Fit::MakeCage(target, {.n_control = 300});
//     if (const double degrees = Fit::SharpAngle(target)) Fit::MarkCreases(cage, target, {.degrees = degrees});
//
// An edge of a control mesh's boundary becomes a crease where it runs along sharp edges of the target: all of it near
// them, and in their direction.
#pragma once

#include <solidsubdiv/apps/fit/control_mesh.h>

namespace SolidSubdiv::Fit {

struct CreaseOptions {
    double degrees = 50;  ///< (0, 180): between the normals of two triangles whose edge is sharp
    double near = 0.25;   ///< (0, 1]: how far an edge may lie from sharp ones, of its length

    /// @throws InvalidInput
    void Validate() const;
};

/// Pairs of vertices (n, 2) of a surface's edges between two triangles whose normals differ by more than so many
/// degrees.
std::vector<Index> SharpEdges(const TargetSurface& target, double degrees);

/// The angle from which on edges of the target are sharp: 50 where they are sharp or not, as in mechanical parts (of
/// those above 40 degrees most are above 70); 0 where they have angles of all sizes, as in scans, and where none is
/// sharp.
double SharpAngle(const TargetSurface& target);

/// Adds infinitely sharp creases. @return how many. @throws InvalidInput
Index MarkCreases(ControlMesh& mesh, const TargetSurface& target, const CreaseOptions& options);

}  // namespace SolidSubdiv::Fit
