// SPDX-License-Identifier: Apache-2.0
// The nearest points of a cloud, several at once.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include <solidsubdiv/apps/fit/internal/vec3.h>

namespace SolidSubdiv::Fit::Internal {

/// A tree of points, each node cut in half along its longest side.
class NeighborTree {
  public:
    /// Positions (n, 3) must outlive this, all finite.
    explicit NeighborTree(std::span<const double> positions);

    struct Neighbor {
        double squared_distance;
        Index point;
        friend auto operator<=>(const Neighbor&, const Neighbor&) = default;
    };
    /// The k points nearest to a place, fewer where there are fewer, nearest first; of equally near ones the lower
    /// numbers.
    std::vector<Neighbor> Find(const Vec3& place, std::size_t k) const;

  private:
    struct Node {
        std::size_t begin, end;  ///< of order_
        std::size_t axis = 0;
        double at = 0;                    ///< left of it, or on it, the first child's points
        std::size_t left = 0, right = 0;  ///< 0: a leaf
    };
    std::size_t Build(std::size_t begin, std::size_t end);
    void Search(std::size_t node, const Vec3& place, std::size_t k, std::vector<Neighbor>& heap) const;

    std::span<const double> positions_;
    std::vector<Index> order_;
    std::vector<Node> nodes_;
};

/// How far neighbours lie from each other: the median distance to the sixth nearest, by which a square grid of spacing
/// 1 has them at sqrt(6 / pi). 0 where most points coincide with others.
double SpacingOf(std::span<const double> positions, const NeighborTree& tree);

}  // namespace SolidSubdiv::Fit::Internal
