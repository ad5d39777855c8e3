// SPDX-License-Identifier: Apache-2.0
// Normals for smooth shading: one a triangle corner, so that creases stay sharp.
#pragma once

#include <span>
#include <vector>

#include <solidsubdiv/kit/picture/internal/vec3.h>
#include <solidsubdiv/sdc/types.h>

namespace SolidSubdiv::Picture::Internal {

/// Row 3t + i: the mean normal, weighted by angle, of the triangles at corner i of triangle t whose planes meet t's at
/// no more than crease_angle (degrees). Zero for triangles without area. Unit vectors otherwise.
std::vector<Vec3f> CornerNormals(std::span<const Vec3d> positions, std::span<const Index> triangles,
                                 double crease_angle);

}  // namespace SolidSubdiv::Picture::Internal
