// SPDX-License-Identifier: Apache-2.0
// Pairs of a point that moves with the control points and the point of the target that it is to meet.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include <solidsubdiv/apps/fit/fit.h>
#include <solidsubdiv/apps/fit/internal/coverage.h>
#include <solidsubdiv/apps/fit/internal/vec3.h>
#include <solidsubdiv/kit/geometry/closest_point.h>

namespace SolidSubdiv::Fit::Internal {

struct Pair {
    std::array<Index, 3> vertices;  ///< of the moving surface
    std::array<double, 3> weights;  ///< of these
    Vec3 partner;                   ///< on the target
    Vec3 normal{};                  ///< of the target there; 0: all directions count alike
    double distance = 0;
    double weight = 0;  ///< of the square of its distance
};

/// The root of the mean squared angle, by area, between the surface's normals at its vertices and those of the target
/// at the points nearest to them, in radians; 0 where the target has none.
double NormalRms(std::span<const double> vertices, std::span<const Index> triangles, const TargetSurface& target,
                 std::span<const Geometry::ClosestPoint> nearest);

/// A target with its nearest points.
class PairFinder {
  public:
    /// At most so many of the target's points are paired, spread evenly over their numbers. The problem must outlive
    /// this.
    PairFinder(const Problem& problem, Offset most_points);

    /// Pairs for the surface's vertices where they are now (n, 3): theirs first, then those of the target's points.
    /// Weights of each way sum to 1 but for what `robust` takes. Pairs whose surfaces look away from each other and
    /// vertices beyond an open border or over a hole of the target are left out.
    std::vector<Pair> Find(std::span<const double> vertices, double robust, Index& n_of_surface) const;

  private:
    void FindPoints(Offset most_points);

    const Problem& problem_;
    std::optional<Geometry::ClosestPoints> target_;  ///< where there are no partners
    std::optional<Coverage> coverage_;               ///< of the target, as well
    /// Those of the target's points that are paired, their normals (of length 1 or 0), and areas, which sum to 1.
    struct Points {
        std::vector<double> positions{};
        std::vector<Vec3> normals{};
        std::vector<double> areas{};
    };
    Points points_;
};

}  // namespace SolidSubdiv::Fit::Internal
