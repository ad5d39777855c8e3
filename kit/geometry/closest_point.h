// SPDX-License-Identifier: Apache-2.0
// The points of a surface, or of a cloud, that are nearest to points.
//
//     const Geometry::ClosestPoints surface(positions, triangles);   // once
//     const auto nearest = surface.Find(points);                     // as often as needed
//
// Surfaces are triangles that need not be closed, oriented or free of defects; without triangles the points themselves
// count. Where several are nearest, rounding decides which: always the same one for the same point.
#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include <solidsubdiv/sdc/types.h>

namespace SolidSubdiv::Geometry {

struct ClosestPoint {
    Index element = kNoIndex;         ///< the triangle, or the point
    std::array<double, 3> weights{};  ///< of the triangle's corners; (1, 0, 0) of a point
    std::array<double, 3> position{};
    double distance = 0;
};

class ClosestPoints {
  public:
    /// Positions (n, 3) and triangles (m, 3) must outlive this; no triangles: a cloud of points. Cost: a sort, about 32
    /// bytes an element.
    /// @throws InvalidInput where there is nothing, a position is not finite or beyond 1e75, or a triangle names a
    /// point that is not there
    ClosestPoints(std::span<const double> positions, std::span<const Index> triangles);
    ~ClosestPoints();
    ClosestPoints(ClosestPoints&&) noexcept;
    ClosestPoints& operator=(ClosestPoints&&) noexcept;

    /// Of points (k, 3). Parallel; the same bits for any number of threads.
    /// @throws InvalidInput naming a point that is not finite or beyond 1e75
    std::vector<ClosestPoint> Find(std::span<const double> points) const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace SolidSubdiv::Geometry
