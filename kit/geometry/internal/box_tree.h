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
#include <cstring>
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

    using Point = std::array<float, 3>;

    /// Calls visit(i, item) for every item whose box holds points[i], points in turn, items in no particular order. The
    /// upper nodes are met once for all points: give few at a time that lie near each other.
    template <class Visit>
    void ForEachHolding(std::span<const Point> points, Visit&& visit) const;

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

        static Floats Load(const float* four) {
            Floats loaded;
            std::memcpy(&loaded, four, sizeof loaded);
            return loaded;
        }
        /// Bit i: box i meets that from `from` to `to`.
        unsigned BitsOfMeeting(const Point& from, const Point& to) const {
            Ints bits{};
            for (int half = 0; half < 2; ++half) {
                Ints meets{-1, -1, -1, -1};
                for (std::size_t k = 0; k < 3; ++k) {
                    const Floats first{from[k], from[k], from[k], from[k]}, last{to[k], to[k], to[k], to[k]};
                    meets &= (last >= Load(low[k] + 4 * half)) & (first <= Load(high[k] + 4 * half));
                }
                bits |= meets & (Ints{1, 2, 4, 8} << 4 * half);
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
void BoxTree::ForEachHolding(std::span<const Point> points, Visit&& visit) const {
    if (order_.empty() || points.empty()) return;
    Point from = points[0], to = points[0];
    for (const Point& p : points) {
        for (std::size_t k = 0; k < 3; ++k) from[k] = std::min(from[k], p[k]), to[k] = std::max(to[k], p[k]);
    }
    // Down together as long as few nodes meet the box of the points.
    constexpr int kMostShared = 6;
    Index shared[kMostShared] = {0};
    int n_shared = 1, level = n_levels() - 1;
    while (level > 0) {
        Index below[kMostShared];
        int n_below = 0;
        for (int s = 0; s < n_shared && n_below <= kMostShared; ++s) {
            for (unsigned bits = At(level, shared[s]).BitsOfMeeting(from, to); bits != 0; bits &= bits - 1) {
                if (n_below++ == kMostShared) break;
                below[n_below - 1] = kWidth * shared[s] + std::countr_zero(bits);
            }
        }
        if (n_below > kMostShared) break;
        std::copy_n(below, n_below, shared);
        n_shared = n_below;
        --level;
    }

    Step steps[kMostSteps + kMostShared];
    for (std::size_t i = 0; i < points.size(); ++i) {
        int n_steps = 0;
        for (int s = 0; s < n_shared; ++s) steps[n_steps++] = {level, shared[s], 0};
        while (n_steps > 0) {
            const Step step = steps[--n_steps];
            unsigned bits = At(step.level, step.node).BitsOfMeeting(points[i], points[i]);
            for (; bits != 0; bits &= bits - 1) {
                const Index child = kWidth * step.node + std::countr_zero(bits);
                if (step.level == 0) {
                    visit(i, order_[static_cast<std::size_t>(child)]);
                } else {
                    steps[n_steps++] = {step.level - 1, child, 0};
                    const char* next = reinterpret_cast<const char*>(&At(step.level - 1, child));
                    for (std::size_t k = 0; k < sizeof(Node); k += 64) __builtin_prefetch(next + k);
                }
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
