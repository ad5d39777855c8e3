// SPDX-License-Identifier: Apache-2.0
// A k-d tree over indices.
#include <solidsubdiv/apps/fit/internal/neighbors.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include <solidsubdiv/sdc/parallel.h>

namespace SolidSubdiv::Fit::Internal {

NeighborTree::NeighborTree(std::span<const double> positions) : positions_(positions), order_(positions.size() / 3) {
    std::iota(order_.begin(), order_.end(), 0);
    if (!order_.empty()) Build(0, order_.size());
}

std::size_t NeighborTree::Build(std::size_t begin, std::size_t end) {
    constexpr std::size_t kLeaf = 8;
    const std::size_t made = nodes_.size();
    nodes_.push_back({.begin = begin, .end = end});
    const auto coordinate = [this](Index p, std::size_t axis) {
        return positions_[3 * static_cast<std::size_t>(p) + axis];
    };
    std::size_t axis = 0;
    double longest = 0;
    for (std::size_t a = 0; a < 3; ++a) {
        const auto [low, high] = std::minmax_element(
            order_.begin() + static_cast<std::ptrdiff_t>(begin), order_.begin() + static_cast<std::ptrdiff_t>(end),
            [&](Index p, Index q) { return coordinate(p, a) < coordinate(q, a); });
        const double length = coordinate(*high, a) - coordinate(*low, a);
        if (length > longest) axis = a, longest = length;
    }
    if (end - begin <= kLeaf || !(longest > 0)) return made;
    const std::size_t middle = (begin + end) / 2;
    std::nth_element(
        order_.begin() + static_cast<std::ptrdiff_t>(begin), order_.begin() + static_cast<std::ptrdiff_t>(middle),
        order_.begin() + static_cast<std::ptrdiff_t>(end),
        [&](Index p, Index q) { return std::pair(coordinate(p, axis), p) < std::pair(coordinate(q, axis), q); });
    const double at = coordinate(order_[middle], axis);
    const std::size_t left = Build(begin, middle), right = Build(middle, end);
    nodes_[made].axis = axis, nodes_[made].at = at, nodes_[made].left = left, nodes_[made].right = right;
    return made;
}

void NeighborTree::Search(std::size_t node, const Vec3& place, std::size_t k, std::vector<Neighbor>& heap) const {
    const Node& n = nodes_[node];
    if (n.left == 0) {
        for (std::size_t i = n.begin; i < n.end; ++i) {
            const Vec3 d = PointAt(positions_, order_[i]) - place;
            const Neighbor neighbor{Dot(d, d), order_[i]};
            if (heap.size() == k && !(neighbor < heap.front())) continue;
            if (heap.size() == k) std::pop_heap(heap.begin(), heap.end()), heap.pop_back();
            heap.push_back(neighbor);
            std::push_heap(heap.begin(), heap.end());
        }
        return;
    }
    const double apart = place[n.axis] - n.at;
    Search(apart <= 0 ? n.left : n.right, place, k, heap);
    if (heap.size() < k || apart * apart <= heap.front().squared_distance) {
        Search(apart <= 0 ? n.right : n.left, place, k, heap);
    }
}

std::vector<NeighborTree::Neighbor> NeighborTree::Find(const Vec3& place, std::size_t k) const {
    std::vector<Neighbor> heap;
    if (!nodes_.empty() && k > 0) Search(0, place, k, heap);
    std::sort_heap(heap.begin(), heap.end());
    return heap;
}

double SpacingOf(std::span<const double> positions, const NeighborTree& tree) {
    constexpr double kPi = 3.14159265358979323846;
    constexpr std::size_t kSixth = 6;
    const auto n = static_cast<Offset>(positions.size() / 3);
    if (n < 2) return 0;
    std::vector<double> distances(static_cast<std::size_t>(n));
    Sdc::ParallelFor(n, 256, [&](Offset begin, Offset end) {
        for (Offset p = begin; p < end; ++p) {
            const auto near = tree.Find(PointAt(positions, static_cast<Index>(p)), kSixth + 1);
            distances[static_cast<std::size_t>(p)] = std::sqrt(near.back().squared_distance);
        }
    });
    const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(n / 2);
    std::nth_element(distances.begin(), middle, distances.end());
    return *middle / std::sqrt(kSixth / kPi);
}

}  // namespace SolidSubdiv::Fit::Internal
