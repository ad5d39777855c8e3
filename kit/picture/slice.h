// SPDX-License-Identifier: Apache-2.0
// A solid cut smoothly along a plane, as with a knife: shows what values it has inside.
//
//     const auto slice = Picture::SliceSolid(mesh, {.point = {0, 0, 0}, .normal = {0, 0, 1}}, density);
//     scene.Add(Picture::Surface{.positions = slice.positions, .triangles = slice.skin});
//     scene.Add(Picture::Surface{.positions = slice.positions, .triangles = slice.cap, .values = slice.values});
#pragma once

#include <span>
#include <vector>

#include <solidsubdiv/kit/picture/cut.h>

namespace SolidSubdiv::Picture {

/// What the knife leaves. Triangles are counterclockwise from outside.
struct SolidSlice {
    std::vector<double> positions;  ///< (n, 3): the vertices that are left and the points on the plane
    std::vector<double> values;     ///< (n): linear along edges; a cell's centre has the mean of its vertices. Or empty
    std::vector<Index> skin;        ///< (k, 3): the solid's own boundary, cut off at the plane
    std::vector<Index> cap;         ///< (m, 3): the cut
    std::vector<CellKind> cap_kinds;  ///< (m): the cell that each triangle of the cut lies in
    std::vector<Index> cap_edges;     ///< (e, 2): outlines of the cells on the cut

    std::vector<Color> CapColorsByKind() const;
};

/// `values`: one number a vertex, or none. Vertices on the plane itself stay.
/// @pre indices are in range. @throws InvalidInput for a plane without direction, or where values do not fit
SolidSlice SliceSolid(const Io::Mesh& mesh, const Plane& plane, std::span<const double> values = {});

}  // namespace SolidSubdiv::Picture
