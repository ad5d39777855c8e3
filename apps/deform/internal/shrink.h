// SPDX-License-Identifier: Apache-2.0
// Control points where cells end move towards the model.
#pragma once

#include <algorithm>
#include <array>
#include <limits>
#include <span>
#include <vector>

#include <solidsubdiv/apps/deform/octree_lattices.h>

namespace SolidSubdiv::Deform::Internal {

/// From where to where the vertices of the model in a cell reach, in cells of its level from the box's corner.
struct Reach {
    static constexpr double kNone = std::numeric_limits<double>::infinity();
    std::array<double, 3> low{kNone, kNone, kNone}, high{-kNone, -kNone, -kNone};

    bool IsEmpty() const { return !(low[0] <= high[0]); }
    void Include(const Reach& other) {
        for (std::size_t k = 0; k < 3; ++k) {
            low[k] = std::min(low[k], other.low[k]);
            high[k] = std::max(high[k], other.high[k]);
        }
    }
};

/// As MakeOctreeLattices says, for one level; `reaches` are those of its cells, all empty ones alike.
void Shrink(const Geometry::OrientedBox& box, int level_number, std::span<const Reach> reaches, double offset,
            LatticeLevel& level);

}  // namespace SolidSubdiv::Deform::Internal
