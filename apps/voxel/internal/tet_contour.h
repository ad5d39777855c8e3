// SPDX-License-Identifier: Apache-2.0
// Where a grid of signed values is zero, as triangles.
#pragma once

#include <array>
#include <vector>

#include <solidsubdiv/sdc/types.h>

namespace SolidSubdiv::Voxel::Internal {

/// Values at the points of a grid, the first axis fastest; 0 and more is inside.
struct SignedGrid {
    std::array<Offset, 3> dims{};
    std::vector<double> values;

    std::size_t At(Offset i, Offset j, Offset k) const {
        return static_cast<std::size_t>(i + dims[0] * (j + dims[1] * k));
    }
    bool IsInside(std::size_t at) const { return values[at] >= 0; }
};

struct Contour {
    std::vector<double> positions;  ///< (n, 3), in numbers of grid points
    std::vector<Index> triangles;   ///< (m, 3), counterclockwise from outside
};

/// @pre the outermost points are outside; then the contour is a closed manifold. @throws InvalidInput past 2^31 - 1
/// vertices
Contour ContourOf(const SignedGrid& grid);

/// Points of a grid that hang together inside, or outside, through the edges of the tetrahedra; so do their contours.
struct Pieces {
    std::vector<std::int32_t> of_point;  ///< the number of each point's piece
    std::vector<Offset> sizes;           ///< points of each
    std::vector<bool> is_inside;
};
Pieces PiecesOf(const SignedGrid& grid);

}  // namespace SolidSubdiv::Voxel::Internal
