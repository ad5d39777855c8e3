// SPDX-License-Identifier: Apache-2.0
// Holds located places to points that were evaluated the plain way.
#pragma once

#include <span>
#include <string>
#include <vector>

#include <solidsubdiv/kit/geometry/locator.h>

#include "findings.h"

namespace SolidSubdiv::Validation {

/// A level of a solid with positions.
struct LocationShape {
    const Far::TopologyRefiner& refiner;
    int level;
    std::span<const double> positions;
};

/// n places drawn evenly over the cells and within them, the same for the same seed.
std::vector<Far::Place> DrawPlaces(const LocationShape& shape, int n, std::uint32_t seed);

/// The point of a place by the definition of its coordinates, nothing of the framework's but the cells' vertices.
std::vector<double> EvaluatePlainly(const LocationShape& shape, std::span<const Far::Place> places);

/// Errors: how far the points of located places are from `points`, those of `drawn`, over the largest coordinate.
/// Faults: points lost, coordinates out of their ranges, cells of higher numbers than those drawn.
void CompareLocation(const LocationShape& shape, std::span<const Far::Place> drawn, std::span<const double> points,
                     const Geometry::Location& found, Findings& findings);

}  // namespace SolidSubdiv::Validation
