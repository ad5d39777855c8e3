// SPDX-License-Identifier: Apache-2.0
// A bounding hierarchy without pointers: boxes in the order of a curve, eight to a node, eight nodes to a node above.
//
// Node j of a level holds the boxes of the nodes 8j .. 8j + 7 of the level below (of boxes 8j .. in the lowest), as
// floats, axis by axis, so that one point is compared with eight boxes at a time. 27.4 bytes a box and 4 for the order.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include <solidsubdiv/sdc/types.h>

namespace SolidSubdiv::Geometry::Internal {

/// In coordinates in which everything lies in [-1, 1]^3.
struct FloatBox {
    float low[3], high[3];
};

class BoxTree {
  public:
    BoxTree() = default;
    /// Items are numbered as their boxes. Parallel but for the sort; the same for any number of threads.
    explicit BoxTree(std::span<const FloatBox> boxes);

    /// Calls visit(item) for every item whose box holds the point, in no particular order.
    template <class Visit>
    void ForEachHolding(const float point[3], Visit&& visit) const;

    /// Calls visit(item), which returns the distance beyond which nothing is wanted any more, for every item whose box
    /// comes nearer than that, by `slack` at least: nodes that come near first.
    template <class Visit>
    void ForEachNear(const std::array<double, 3>& point, double slack, Visit&& visit) const;

    Offset Bytes() const { return static_cast<Offset>(nodes_.size() * sizeof(Node) + order_.size() * sizeof(Index)); }

  private:
    static constexpr int kWidth = 8;
    /// Four floats or whole numbers at a time: compilers make branches of plain loops of comparisons.
    using Floats = float __attribute__((vector_size(16)));
    using Ints = int __attribute__((vector_size(16)));
    struct Node {
        alignas(16) float low[3][kWidth];
        alignas(16) float high[3][kWidth];

        /// Bit i: box i holds the point.
        unsigned BitsOfHolding(const float point[3]) const {
            Ints bits{};
            for (int half = 0; half < 2; ++half) {
                Ints holds{-1, -1, -1, -1};
                for (int k = 0; k < 3; ++k) {
                    const float x = point[k];
                    const Floats at{x, x, x, x};
                    const auto& lows = *reinterpret_cast<const Floats*>(low[k] + 4 * half);
                    const auto& highs = *reinterpret_cast<const Floats*>(high[k] + 4 * half);
                    holds &= (at >= lows) & (at <= highs);
                }
                bits |= holds & (Ints{1, 2, 4, 8} << 4 * half);
            }
            return static_cast<unsigned>(bits[0] | bits[1] | bits[2] | bits[3]);
        }
    };
    /// A node on the way: level (0 the lowest) and number in it.
    struct Step {
        int level;
        Index node;
        double distance;
    };
    static constexpr int kMostSteps = 12 * kWidth;  // 8^11 is more than 2^31

    const Node& At(int level, Index node) const { return nodes_[static_cast<std::size_t>(starts_[level] + node)]; }
    int n_levels() const { return static_cast<int>(starts_.size()); }

    Array<Node> nodes_;
    std::vector<Offset> starts_;  // of each level in nodes_
    std::vector<Index> order_;    // items along the curve
};

template <class Visit>
void BoxTree::ForEachHolding(const float point[3], Visit&& visit) const {
    if (order_.empty()) return;
    Step steps[kMostSteps];
    int n_steps = 0;
    steps[n_steps++] = {n_levels() - 1, 0, 0};
    while (n_steps > 0) {
        const Step step = steps[--n_steps];
        const Node& node = At(step.level, step.node);
        unsigned bits = node.BitsOfHolding(point);
        for (; bits != 0; bits &= bits - 1) {
            const Index child = kWidth * step.node + std::countr_zero(bits);
            if (step.level == 0) {
                visit(order_[static_cast<std::size_t>(child)]);
            } else {
                steps[n_steps++] = {step.level - 1, child, 0};
                const char* next = reinterpret_cast<const char*>(&At(step.level - 1, child));
                for (std::size_t k = 0; k < sizeof(Node); k += 64) __builtin_prefetch(next + k);
            }
        }
    }
}

template <class Visit>
void BoxTree::ForEachNear(const std::array<double, 3>& point, double slack, Visit&& visit) const {
    if (order_.empty()) return;
    Step steps[kMostSteps];
    int n_steps = 0;
    steps[n_steps++] = {n_levels() - 1, 0, 0};
    double most = std::numeric_limits<double>::infinity();
    while (n_steps > 0) {
        const Step step = steps[--n_steps];
        if (step.distance > most) continue;
        const Node& node = At(step.level, step.node);
        Step children[kWidth];
        int n_children = 0;
        for (int i = 0; i < kWidth; ++i) {
            if (!(node.low[0][i] <= node.high[0][i])) continue;
            double sum = 0;
            for (std::size_t k = 0; k < 3; ++k) {
                const double below = static_cast<double>(node.low[k][i]) - point[k],
                             above = point[k] - static_cast<double>(node.high[k][i]);
                const double gap = std::max({0.0, below, above});
                sum += gap * gap;
            }
            const double distance = std::sqrt(sum) - slack;
            if (!(distance <= most)) continue;
            int place = n_children++;  // the nearest last: it is taken first
            for (; place > 0 && children[place - 1].distance < distance; --place) children[place] = children[place - 1];
            children[place] = {step.level - 1, kWidth * step.node + i, distance};
        }
        for (int i = 0; i < n_children; ++i) {
            if (step.level > 0) {
                steps[n_steps++] = children[i];
            } else {
                const Step& child = children[n_children - 1 - i];
                if (child.distance <= most) most = visit(order_[static_cast<std::size_t>(child.node)]);
            }
        }
    }
}

}  // namespace SolidSubdiv::Geometry::Internal
