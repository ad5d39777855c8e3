// SPDX-License-Identifier: Apache-2.0
// Holds attributes in voxels to values evaluated directly in the cells that hold them.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "findings.h"
#include "voxel_shapes.h"

namespace SolidSubdiv::Validation {

/// What a number of voxels were given.
struct VoxelSamples {
    double voxel_size = 1;
    std::vector<std::array<int, 3>> voxels;
    std::vector<Index> cells;
    std::vector<double> numbers;  ///< (n)
    std::vector<double> vectors;  ///< (n, 3)
};

/// Attributes of vertices that no linear function of their positions gives, of size 1; `width` numbers a vertex.
std::vector<double> MakeValues(const VoxelShape& shape, int width);

/// Voxelizes a shape with MakeValues and draws n of its voxels, the same for the same seed. @throws Unavailable
VoxelSamples SampleVoxels(const VoxelShape& shape, double voxel_size, int n, unsigned seed);

/// Errors: by how much values differ from those evaluated here (the cell's coordinates by steps of Newton's in
/// hexahedra, else in the tet of the cell) by more than floats round, and from MakePlaceRows where the locator finds
/// the same cell, a tet, octahedron or hexahedron. Faults: cells that do not hold the voxel; less than nine in ten
/// located in the same cell.
void CompareSamples(const VoxelShape& shape, const VoxelSamples& samples, Findings& findings);

}  // namespace SolidSubdiv::Validation
