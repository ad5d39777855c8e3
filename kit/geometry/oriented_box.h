// SPDX-License-Identifier: Apache-2.0
// Boxes around points that lie as the points do: axis-aligned, along their principal components, or of little volume.
//
//     const Geometry::OrientedBox box = Geometry::MakeBox(positions, Geometry::BoxKind::Minimum);
//     const auto middle = box.At({.5 * box.lengths[0], .5 * box.lengths[1], .5 * box.lengths[2]});
//
// Of the 24 frames of a box the one is given that is nearest to the coordinate axes, so that a box that hardly turns
// keeps its names of sides. Boxes do not depend on the order of the points by a bit.
#pragma once

#include <array>
#include <span>
#include <string_view>

#include <solidsubdiv/kit/geometry/box.h>

namespace SolidSubdiv::Geometry {

/// The points corner + sum t[k] axes[k] with 0 <= t[k] <= lengths[k]. Points that it was made around lie in it up to
/// rounding of their coordinates.
struct OrientedBox {
    std::array<double, 3> corner{};
    std::array<std::array<double, 3>, 3> axes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};  ///< orthonormal and right-handed
    std::array<double, 3> lengths{};

    double Volume() const { return lengths[0] * lengths[1] * lengths[2]; }
    /// The point with these coordinates, in units of length from the corner.
    std::array<double, 3> At(const std::array<double, 3>& coordinates) const;
    /// Its inverse.
    std::array<double, 3> CoordinatesOf(std::span<const double, 3> point) const;
};

enum class BoxKind {
    AxisAligned,  ///< along the coordinate axes; exact
    /// Along the principal components of the points. Where two of them are equal (to a part in 1e6) they say nothing:
    /// the frame is then the one with the least rectangle across the third; where all are, that of Minimum.
    Oriented,
    /// The least volume that was found, not a proved minimum: never more than that of the other two. From 125 frames on
    /// (then from those around the best) each is turned about one of its axes after another to the least rectangle of
    /// the points as seen along it, until no turn helps.
    Minimum
};

/// "aabb", "obb" or "minimum". @throws InvalidInput
BoxKind BoxKindOf(std::string_view name);

/// A box around points, (n, 3); flat and collinear ones and single points have sides without length (or with one of
/// rounding). Cost: some passes over the points, for Minimum some tens more and a search among some 300 of them.
/// @throws InvalidInput where there is no point or one is not finite or beyond 1e75
OrientedBox MakeBox(std::span<const double> points, BoxKind kind);

}  // namespace SolidSubdiv::Geometry
