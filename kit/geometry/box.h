// SPDX-License-Identifier: Apache-2.0
// Axis-aligned boxes around points.
#pragma once

#include <array>
#include <limits>
#include <span>

namespace SolidSubdiv::Geometry {

/// The points x with low <= x <= high in every coordinate; empty as made.
struct Box {
    static constexpr double kInfinity = std::numeric_limits<double>::infinity();
    std::array<double, 3> low{kInfinity, kInfinity, kInfinity};
    std::array<double, 3> high{-kInfinity, -kInfinity, -kInfinity};

    bool IsEmpty() const { return !(low[0] <= high[0]); }
    void Include(std::span<const double, 3> point);
    /// Length of a side; 0 for an empty box.
    double Extent(int axis) const { return IsEmpty() ? 0.0 : high[axis] - low[axis]; }
    /// Length of the diagonal; 0 for an empty box.
    double Diagonal() const;
};

/// The least box around points, (n, 3). @pre finite
Box BoundingBox(std::span<const double> positions);

}  // namespace SolidSubdiv::Geometry
