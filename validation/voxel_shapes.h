// SPDX-License-Identifier: Apache-2.0
// Solids of hexahedra with boundary vertices on a ball, a torus and a box, and exact distances to these.
#pragma once

#include <array>
#include <string>
#include <vector>

#include <solidsubdiv/far/topology_refiner.h>

namespace SolidSubdiv::Validation {

/// A level of a solid with positions.
struct VoxelShape {
    std::string name;
    Far::TopologyRefiner refiner;
    int level;
    std::vector<double> positions;
};

/// A ball of radius 1, a torus of radii 1 and 0.4: a core of straight cells and curved ones around it, none of them
/// folded. A box of half sides 1, 0.7, 0.5 that is turned askew. @param n cells along a side of the core
VoxelShape MakeBall(int n);
VoxelShape MakeTorus(int n);
VoxelShape MakeTurnedBox(int n);

/// Signed distances to these shapes, negative inside.
double DistanceToBall(const std::array<double, 3>& p);
double DistanceToTorus(const std::array<double, 3>& p);
double DistanceToTurnedBox(const std::array<double, 3>& p);

}  // namespace SolidSubdiv::Validation
