// SPDX-License-Identifier: Apache-2.0
// Free-form deformation by a block of hexahedra in closed form, and how far control points reach. An oracle: it shares
// no code with the library.
//
// Along each axis a block is a curve of the points P0 .. Pn. Catmull-Clark solids leave a block's corners, follow its
// sharp edges as curves and its sides as surfaces. So along an axis, at every level,
//
//     old points become (Pi-1 + 6 Pi + Pi+1)/8, new ones are (Pi + Pi+1)/2, and the ends P0 and Pn stay.
//
// With P-1 = 2 P0 - P1 beyond the end, the first rule gives P0 there, and the new point beyond, (P-1 + P0)/2, is
// 2 P0 - (P0 + P1)/2 again: the end rule is the cubic B-spline's own with points beyond the ends by linear
// extrapolation, at all levels and so in the limit. Points in equal steps give the line through them.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace SolidSubdiv::Validation {

/// (n[0] + 1) (n[1] + 1) (n[2] + 1) control points, those along the first axis next to each other.
struct ControlBlock {
    using Steps = std::array<int, 3>;
    using Point = std::array<double, 3>;

    Steps n{1, 1, 1};  ///< hexahedra along each axis
    std::vector<Point> points;

    std::size_t NumberOf(const Steps& at) const {
        return static_cast<std::size_t>(at[0] + (n[0] + 1) * (at[1] + (n[1] + 1) * at[2]));
    }
    const Point& At(const Steps& at) const { return points[NumberOf(at)]; }
};

/// The tricubic B-spline at u, u[k] in [0, n[k]].
ControlBlock::Point SplineAt(const ControlBlock& block, const ControlBlock::Point& u);

/// The block of half the steps: the same spline.
ControlBlock InsertKnots(const ControlBlock& block);

/// The block's own hexahedra at u, trilinear in each.
ControlBlock::Point TrilinearAt(const ControlBlock& block, const ControlBlock::Point& u);

/// Of every control point, how many steps it is from one of them, a step from each to all that share a cell with it:
/// `dist` of ono2002ffd, section 3.1. -1: not to be reached. @param cells vertices of each
std::vector<int> StepsByCells(const std::vector<std::vector<int>>& cells, int n_points, int from);

}  // namespace SolidSubdiv::Validation
