// SPDX-License-Identifier: Apache-2.0
// A surface taken out of a larger mesh: its triangles over its own vertices alone, and the way back.
#pragma once

#include <span>
#include <vector>

#include <solidsubdiv/vtr/level.h>
#include <solidsubdiv/vtr/polyhedral_level.h>

namespace SolidSubdiv::Geometry {

struct CompactSurface {
    std::vector<Index> vertices;  ///< (n), ascending: the mesh's vertex of each vertex of the surface
    std::vector<Index> corners;   ///< of the faces in the order given, over [0, n): triangles (m, 3) or as they came
};

/// @pre indices of the faces' corners are in [0, n_vertices). Cost: linear.
CompactSurface MakeCompactSurface(std::span<const Index> corners, Index n_vertices);

/// A surface with its faces told apart.
struct BoundarySurface : CompactSurface {
    Vtr::RowOffsets rows;  ///< of `corners`: a face's are one row
};

/// The boundary faces of a level, its solids' counterclockwise from outside and its surface elements, but for those
/// that `is_left_out` marks. @pre that is empty or has one entry a boundary face
BoundarySurface ExtractBoundary(const Vtr::Level& level, const std::vector<bool>& is_left_out = {});
BoundarySurface ExtractBoundary(const Vtr::PolyhedralLevel& level, const std::vector<bool>& is_left_out = {});

/// Rows of `width` numbers at chosen vertices: positions or data of a compact surface. @pre indices are in range
std::vector<double> GatherRows(std::span<const double> rows, int width, std::span<const Index> vertices);

}  // namespace SolidSubdiv::Geometry
