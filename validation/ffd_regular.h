// SPDX-License-Identifier: Apache-2.0
// Holds points deformed with a block of hexahedra to the tricubic B-spline, or to its trilinear pieces at a level.
#pragma once

#include <span>
#include <string>
#include <vector>

#include <solidsubdiv/apps/deform/embedding.h>

#include "ffd_oracle.h"
#include "findings.h"

namespace SolidSubdiv::Validation {

/// An affine image of a block of hexahedra of size 1, its control points moved at random, and points in it.
struct DeformedBlock {
    DeformedBlock(std::array<int, 3> n, std::uint32_t seed);

    ControlBlock rest, moved;
    std::vector<Index> hexes;                    ///< (n, 8)
    std::vector<std::array<double, 3>> places;   ///< in units of hexahedra: inside, on sides, edges and corners
    std::vector<double> control, moved_control;  ///< (n_control_points, 3)
    std::vector<double> points;                  ///< (n, 3): where the undeformed block has the places

    Far::TopologyDescriptor View() const;
};

/// What the library makes of the points.
std::vector<double> DeformPoints(const DeformedBlock& block, const Deform::EmbedOptions& options);

/// Errors: distances of deformed points from the spline's, or at a level from its trilinear pieces', over the size of
/// the moved block.
void CompareWithSpline(const DeformedBlock& block, std::span<const double> deformed, Findings& findings);
void CompareWithPieces(const DeformedBlock& block, int level, std::span<const double> deformed, Findings& findings);

}  // namespace SolidSubdiv::Validation
