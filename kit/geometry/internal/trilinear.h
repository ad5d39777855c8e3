// SPDX-License-Identifier: Apache-2.0
// A trilinear map of the unit cube: eight corners, corner i at (bit 0, bit 1, bit 2) of i.
#pragma once

#include <array>
#include <span>

#include <solidsubdiv/kit/geometry/internal/vec3.h>
#include <solidsubdiv/sdc/cells.h>

namespace SolidSubdiv::Geometry::Internal {

/// The hexahedron's vertex (VTK's order) at corner i, and back.
inline constexpr std::array<std::size_t, 8> kHexVertexOfCorner{0, 1, 3, 2, 4, 5, 7, 6};

struct Trilinear {
    std::array<Vec3, 8> corners;

    Vec3 PointOf(const Vec3& at) const {
        const auto along = [](const Vec3& a, const Vec3& b, double t) { return a + t * (b - a); };
        const auto& c = corners;
        const Vec3 bottom = along(along(c[0], c[1], at.x), along(c[2], c[3], at.x), at.y);
        const Vec3 top = along(along(c[4], c[5], at.x), along(c[6], c[7], at.x), at.y);
        return along(bottom, top, at.z);
    }
    /// Derivatives of the point by the three coordinates.
    std::array<Vec3, 3> Jacobian(const Vec3& at) const {
        const double t[3] = {at.x, at.y, at.z};
        std::array<Vec3, 3> columns{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const std::size_t next = (axis + 1) % 3, last = (axis + 2) % 3;
            for (std::size_t k = 0; k < 4; ++k) {
                const std::size_t low = (k & 1) << next | (k >> 1) << last;
                const double weight = (k & 1 ? t[next] : 1 - t[next]) * (k & 2 ? t[last] : 1 - t[last]);
                columns[axis] = columns[axis] + weight * (corners[low | std::size_t{1} << axis] - corners[low]);
            }
        }
        return columns;
    }
};

/// A box of the cube, and the map of it.
struct TrilinearPart {
    Trilinear map;
    Vec3 low{0, 0, 0}, size{1, 1, 1};

    Vec3 Middle() const { return low + 0.5 * size; }
    /// The two halves across the axis along which the part's edges are longest.
    std::array<TrilinearPart, 2> Halves() const {
        double longest[3] = {};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            for (std::size_t i = 0; i < 8; ++i) {
                const Vec3 edge = map.corners[i | std::size_t{1} << axis] - map.corners[i];
                longest[axis] = std::max(longest[axis], Dot(edge, edge));
            }
        }
        const auto axis = static_cast<std::size_t>(std::max_element(longest, longest + 3) - longest);
        std::array<TrilinearPart, 2> halves{*this, *this};
        for (std::size_t i = 0; i < 8; ++i) {
            const std::size_t bit = std::size_t{1} << axis;
            if (i & bit) continue;
            const Vec3 middle = 0.5 * (map.corners[i] + map.corners[i | bit]);
            halves[0].map.corners[i | bit] = halves[1].map.corners[i] = middle;
        }
        double Vec3::*const coordinate = axis == 0 ? &Vec3::x : axis == 1 ? &Vec3::y : &Vec3::z;
        for (TrilinearPart& half : halves) half.size.*coordinate *= 0.5;
        halves[1].low.*coordinate += halves[1].size.*coordinate;
        return halves;
    }
};

}  // namespace SolidSubdiv::Geometry::Internal
