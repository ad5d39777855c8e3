// SPDX-License-Identifier: Apache-2.0
// A surface of triangles with most of its vertices taken away.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include <solidsubdiv/apps/fit/internal/vec3.h>

namespace SolidSubdiv::Fit::Starting {

using namespace Internal;

struct Decimated {
    std::vector<double> positions;  ///< (n, 3)
    std::vector<Index> triangles;   ///< (m, 3)
};

/// Edges are collapsed, one end into the other, in the order of the error that quadrics say (garland1997quadrics),
/// while triangles do not turn by more than a right angle and the surface stays the manifold that it was. Borders go
/// along themselves only. Then edges are flipped where that brings valences nearer to 6 (4 on borders) without a bend,
/// and vertices evened out in their tangent plane and put back by `nearest`.
/// @param nearest of points (n, 3) those on the surface
/// @pre a manifold, oriented
Decimated Decimate(std::span<const double> positions, std::span<const Index> triangles, std::size_t n_vertices,
                   const std::function<std::vector<double>(std::span<const double>)>& nearest);

}  // namespace SolidSubdiv::Fit::Starting
