// SPDX-License-Identifier: Apache-2.0
// Holds level sets and fog of solids to OpenVDB's own, to exact distances, and to volumes.
#pragma once

#include <array>
#include <functional>

#include "findings.h"
#include "voxel_oracle.h"
#include "voxel_shapes.h"

namespace SolidSubdiv::Validation {

/// Faces of one cell, of cells cut into tets, counterclockwise from outside; and the volume within, by the divergence
/// theorem.
TriangleSurface BoundaryOf(const VoxelShape& shape);
double VolumeOf(const TriangleSurface& surface);
double AreaOf(const TriangleSurface& surface);

/// The framework's voxels around a shape: distances, and parts of voxels filled. @throws Unavailable
struct ShapeVoxels {
    VoxelBlock distances, fog;
};
ShapeVoxels VoxelizeShape(const VoxelShape& shape, double voxel_size, double half_width);

/// How often a closed surface winds around a point: 1 inside, 0 outside; by the solid angles of its triangles.
double WindingNumber(const TriangleSurface& surface, const std::array<double, 3>& p);

/// Errors: by how much distances differ by more than a tenth of a voxel where theirs are less than kExactBand.
/// Faults: other signs, where the winding number says that ours are wrong. (Theirs are at a few voxels: it takes the
/// nearest triangle's side, and edges and vertices have several.)
void CompareLevelSets(const VoxelBlock& ours, const VoxelBlock& theirs, const TriangleSurface& surface,
                      Findings& findings);

/// Beyond it theirs is approximate: its band grows from voxel to voxel, each trying the triangles that are nearest to
/// its neighbours. Measured: up to 4e-6 of a voxel within, up to 0.9 beyond.
inline constexpr double kExactBand = 1.5;

/// Errors, in voxels: by how much distances in the band differ from exact ones by more than `sagitta`, the largest
/// distance from the facets to the shape. Faults: other signs, where the shape is farther than that.
void CompareDistances(const VoxelBlock& ours, const std::function<double(const std::array<double, 3>&)>& exact,
                      double sagitta, Findings& findings);

/// How far the facets of a surface are from a shape at most, sampled.
double SagittaOf(const TriangleSurface& surface, const std::function<double(const std::array<double, 3>&)>& exact);

/// Errors: by how many layers of voxels on the boundary the volume of negative voxels, and that of fog, differ from the
/// surface's by more than kLayers.
void CompareVolumes(const ShapeVoxels& voxels, const TriangleSurface& surface, Findings& findings);

/// Voxels counted whole or by samples differ from what is covered either way, and cancel but where the boundary is
/// along the axes. Measured: 0.025 (the torus) and 0.004 (the box) at most.
inline constexpr double kLayersOfVoxels = 0.05, kLayersOfFog = 0.01;

}  // namespace SolidSubdiv::Validation
