// SPDX-License-Identifier: Apache-2.0
// The determinants that tell whether cells are folded.
#pragma once

#include <array>
#include <span>
#include <vector>

#include <solidsubdiv/apps/fit/control_mesh.h>
#include <solidsubdiv/apps/fit/internal/vec3.h>

namespace SolidSubdiv::Fit::Internal {

/// A vertex of a cell and the ends of three edges from it, seen counterclockwise from them. Of hexahedra, which come
/// first, the eight corners of each; of each tet one; of each octahedron those of the four around the major diagonal.
std::vector<std::array<Index, 4>> CellCornersOf(const ControlMesh& mesh);

/// (b - a) x (c - a) . (d - a).
inline double CornerVolume(const std::array<Index, 4>& corner, std::span<const double> positions) {
    const Vec3 a = PointAt(positions, corner[0]);
    return Dot(PointAt(positions, corner[1]) - a,
               Cross(PointAt(positions, corner[2]) - a, PointAt(positions, corner[3]) - a));
}

}  // namespace SolidSubdiv::Fit::Internal
