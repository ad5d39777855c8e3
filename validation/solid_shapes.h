// SPDX-License-Identifier: Apache-2.0
// Small solids made by arithmetic, one for each feature that a complex of tets and octahedra can have.
#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "cells_oracle.h"

namespace SolidSubdiv::Validation {

struct SolidShape {
    std::string name;
    std::string feature;  ///< what it is there for
    Complex complex;
    std::vector<double> positions;  ///< (n_vertices, 3); shaken, so that no symmetry hides a mistake

    int n_vertices() const { return static_cast<int>(positions.size() / 3); }
};

/// Uniform numbers in [-1, 1], the same everywhere for the same seed.
class Shaker {
  public:
    explicit Shaker(std::uint32_t seed) : engine_(seed) {}
    double Next() { return 2.0 * (static_cast<double>(engine_()) / 4294967295.0) - 1.0; }
    /// A whole number in [0, n).
    int Below(int n) { return static_cast<int>(engine_() % static_cast<std::uint32_t>(n)); }

  private:
    std::mt19937 engine_;
};

/// Unit cubes of six tets each around their diagonals (1,1,1), on the BCC lattice: cube (x, y, z) is there where
/// layers[z][y][x] is '#'. All cells positive.
SolidShape VoxelSolid(std::string name, std::string feature, const std::vector<std::vector<std::string>>& layers);

/// k tets around one inner edge: its ends have k boundary neighbours. @pre k >= 3
SolidShape Spindle(int k);

/// One shape for every feature, all with a surface as boundary.
std::vector<SolidShape> ManifoldShapes();

/// Cells that meet in an edge or a vertex only.
std::vector<SolidShape> NonManifoldShapes();

/// A random piece of the lattice, in tets and octahedra: cubes come and go, so that cells meet in every possible way.
SolidShape RandomPiece(std::uint32_t seed);

}  // namespace SolidSubdiv::Validation
