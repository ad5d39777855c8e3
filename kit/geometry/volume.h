// SPDX-License-Identifier: Apache-2.0
// A volume: numbers on a regular grid of voxels (an image, a map of labels), and where the voxels lie in space.
//
//     const Geometry::Volume volume = Io::ReadVolume("brain.nii.gz");
//     const std::array<double, 3> at = Geometry::Apply(Geometry::Inverse(volume.voxel_to_world), point);
//     const double value = volume.Value(at);
//
// Two systems of coordinates are in use, as every volume format has them. In *voxel coordinates* the centre of voxel
// (i, j, k) is the point (i, j, k), so that the grid reaches from -1/2 to dims - 1/2. *World coordinates* are the
// physical ones of the file; an affine map leads there. Some formats count them to the left and the back (LPS), some to
// the right and the front (RAS): they are kept as the file has them.
#pragma once

#include <array>
#include <string>
#include <vector>

#include <solidsubdiv/kit/geometry/box.h>
#include <solidsubdiv/sdc/types.h>

namespace SolidSubdiv::Geometry {

/// y = A x + b, as the rows (A | b) of a (3, 4) matrix, row-major.
using AffineMap = std::array<double, 12>;

std::array<double, 3> Apply(const AffineMap& map, const std::array<double, 3>& point);

/// Whether the map flattens space: the determinant of the directions of its columns is below 1e-6, which the 32-bit
/// numbers of some headers can't tell from 0, or a number isn't finite.
bool IsSingular(const AffineMap& map);

/// The map back. @throws InvalidInput if the map is singular
AffineMap Inverse(const AffineMap& map);

/// One number a voxel. Values are doubles, twice the memory of floats (a gigabyte for 512^3 voxels), so that every
/// label up to 2^53 and every scaled value of a file is exact.
struct Volume {
    std::array<Offset, 3> dims{};  ///< voxels along the three axes
    std::vector<double> values;    ///< (dims[2], dims[1], dims[0]), row-major: the first axis fastest; all finite
    AffineMap voxel_to_world{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};

    std::vector<std::string> notes{};  ///< what the reader did that the user should know, a line each

    Offset n_voxels() const { return dims[0] * dims[1] * dims[2]; }
    double At(Offset i, Offset j, Offset k) const {
        return values[static_cast<std::size_t>(i + dims[0] * (j + dims[1] * k))];
    }
    std::array<double, 3> ToWorld(const std::array<double, 3>& voxel) const { return Apply(voxel_to_world, voxel); }
    /// Distances between the centres of neighbours along the three axes, in the world.
    std::array<double, 3> Spacing() const;

    /// Trilinear between the centres of voxels, beyond the outermost ones the value at the nearest point of their box.
    /// Exact at centres, and where all eight are equal. @pre at least one voxel, a finite point
    double Value(const std::array<double, 3>& voxel) const;
};

/// The least box in the world around the centres of all voxels.
Box BoundingBox(const Volume& volume);

/// The labels of a map of labels: its distinct values in ascending order; empty if one is no integer.
std::vector<double> LabelsOf(const Volume& volume);

}  // namespace SolidSubdiv::Geometry
