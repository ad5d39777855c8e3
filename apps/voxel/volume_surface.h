// SPDX-License-Identifier: Apache-2.0
// The surface of what a volume shows: of a label, or of all that is above a level.
//
//     const Geometry::Volume brain = Io::ReadVolume("labels.nii.gz");
//     const auto caudate = Voxel::SurfaceOfLabel(brain, 71);                                // smoothed by a voxel
//     const auto skull = Voxel::SurfaceOfLevel(scan, Voxel::OtsuThreshold(scan.values));   // of grey values
//
// The volume is cut in tetrahedra, six a cube of eight voxel centres, all around one of its diagonals; values are
// linear in each, and so the surface is flat in each. That makes it a closed manifold whatever the values, which
// marching cubes and dual contouring do not promise:
//
//        +-------+        o  a voxel inside
//       /|\     /|        \  the surface cuts each edge from inside to outside once: a tetrahedron holds no piece of
//      / | \   / |           it, a triangle, or two
//     o--+--\-+  |
//
// Where the object reaches the border of the volume, the surface is closed on the outer faces of the last voxels.
//
// Pieces and cavities of few voxels are noise as a rule: those of less than `least_piece` of the largest piece's voxels
// are left out and filled, and counted.
//
// Sources: doi1991efficient (tetrahedra), otsu1979threshold.
#pragma once

#include <span>
#include <vector>

#include <solidsubdiv/kit/geometry/volume.h>

namespace SolidSubdiv::Voxel {

struct VolumeSurfaceOptions {
    /// [0, 16], voxels: the standard deviation of the Gaussian that values are smoothed with before. Labels need about
    /// one, since their surface has a step at each voxel. It then lies where it has as many voxels inside as the label.
    double smooth = 0;
    double least_piece = 0.01;  ///< [0, 1], part of the largest piece's voxels

    /// @throws InvalidInput
    void Validate() const;
};

struct VolumeSurface {
    std::vector<double> positions;  ///< (n, 3), world coordinates
    std::vector<Index> triangles;   ///< (m, 3), counterclockwise from outside, in the world's own right-handed sense
    Offset n_pieces = 0;            ///< kept
    Offset n_dropped_pieces = 0, n_filled_cavities = 0;
    bool touches_border = false;  ///< of the volume: it was closed there
};

/// The surface of value >= level, linear between voxels. Deterministic. Cost: a few passes over the volume, 20 bytes a
/// voxel.
/// @throws InvalidInput where no value or each is at least `level`, naming the range; or there are more than 2^31 - 1
/// vertices
VolumeSurface SurfaceOfLevel(const Geometry::Volume& volume, double level, const VolumeSurfaceOptions& options = {});

/// The surface of all voxels of one value. @throws InvalidInput where there is no such voxel, naming those that are
VolumeSurface SurfaceOfLabel(const Geometry::Volume& volume, double label,
                             const VolumeSurfaceOptions& options = {.smooth = 1});

/// The level that parts values best in two: that of the least variance on both sides, from a histogram of 256 steps.
/// @throws InvalidInput where all are equal
double OtsuThreshold(std::span<const double> values);

}  // namespace SolidSubdiv::Voxel
