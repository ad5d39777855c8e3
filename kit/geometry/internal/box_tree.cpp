// SPDX-License-Identifier: Apache-2.0
// Builds a packed hierarchy of boxes from below.
#include <solidsubdiv/kit/geometry/internal/box_tree.h>

#include <solidsubdiv/kit/geometry/internal/curve_order.h>
#include <solidsubdiv/sdc/parallel.h>

namespace SolidSubdiv::Geometry::Internal {

namespace {

constexpr Offset kGrain = 4096;
constexpr float kInfinity = std::numeric_limits<float>::infinity();

}  // namespace

BoxTree::BoxTree(std::span<const FloatBox> boxes) {
    if (boxes.empty()) return;
    const auto n = static_cast<Offset>(boxes.size());
    std::vector<std::uint32_t> keys(boxes.size());
    Sdc::ParallelFor(n, kGrain, [&](Offset begin, Offset end) {
        for (Offset i = begin; i < end; ++i) {
            const FloatBox& box = boxes[static_cast<std::size_t>(i)];
            float middle[3];
            for (int k = 0; k < 3; ++k) middle[k] = 0.5f * (box.low[k] + box.high[k]);
            keys[static_cast<std::size_t>(i)] = CurveKey(middle);
        }
    });
    order_ = OrderByKey(keys);

    Offset n_nodes = 0;
    for (Offset below = n; starts_.empty() || below > 1;) {
        starts_.push_back(n_nodes);
        below = (below + kWidth - 1) / kWidth;
        n_nodes += below;
    }
    nodes_.resize(static_cast<std::size_t>(n_nodes));
    const auto box_of_child = [&](int level, Offset child, Offset n_children) {
        FloatBox box{{kInfinity, kInfinity, kInfinity}, {-kInfinity, -kInfinity, -kInfinity}};
        if (child >= n_children) return box;
        if (level == 0) return boxes[static_cast<std::size_t>(order_[static_cast<std::size_t>(child)])];
        const Node& node = At(level - 1, static_cast<Index>(child));
        for (int k = 0; k < 3; ++k) {
            box.low[k] = *std::min_element(node.low[k], node.low[k] + kWidth);
            box.high[k] = *std::max_element(node.high[k], node.high[k] + kWidth);
        }
        return box;
    };
    Offset n_children = n;
    for (int level = 0; level < n_levels(); ++level) {
        const Offset n_here = (n_children + kWidth - 1) / kWidth;
        Sdc::ParallelFor(n_here, kGrain, [&](Offset begin, Offset end) {
            for (Offset j = begin; j < end; ++j) {
                Node& node = nodes_[static_cast<std::size_t>(starts_[level] + j)];
                for (int i = 0; i < kWidth; ++i) {
                    const FloatBox box = box_of_child(level, kWidth * j + i, n_children);
                    for (int k = 0; k < 3; ++k) {
                        node.low[k][i] = box.low[k];
                        node.high[k][i] = box.high[k];
                    }
                }
            }
        });
        n_children = n_here;
    }
}

}  // namespace SolidSubdiv::Geometry::Internal
