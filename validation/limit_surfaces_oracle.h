// SPDX-License-Identifier: Apache-2.0
// OpenSubdiv's limits of surfaces, as plain arrays. An oracle: it shares no code with the library.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "surface_levels.h"

namespace SolidSubdiv::Validation {

/// Where OpenSubdiv evaluates: a triangle of Loop's or a quad, at (s, t), its second vertex at (1, 0) and its last at
/// (0, 1). Of a face of another number of corners, the quad at a corner.
struct SurfacePlace {
    int face = 0, corner = 0;
    double s = 0, t = 0;
};

struct SurfaceLimits {
    std::vector<double> points;                      ///< (n, 3)
    std::array<std::vector<double>, 5> derivatives;  ///< s, t, ss, st, tt: (n, 3) each
    /// In a regular patch that stands above the last level, not in one that approximates: an end cap, or one where
    /// creases have yet to fade.
    std::vector<bool> is_exact;
    std::vector<int> depths;  ///< levels of refinement until there
};

/// By adaptive refinement and patches. OpenSubdiv 3.5 gives second derivatives in the triangles in the middle of split
/// ones the wrong sign, which is set right here. @throws std::runtime_error if OpenSubdiv refuses the surface
SurfaceLimits LimitsByOpenSubdiv(const ControlSurface& surface, std::span<const SurfacePlace> places);
SurfaceLimits LimitsByOpenSubdiv(const PolygonSurface& surface, std::span<const SurfacePlace> places);

struct VertexLimits {
    std::vector<double> points, normals;  ///< (n_vertices, 3); normals of any length
    std::vector<bool> is_dart;            ///< one sharp edge ends there
    std::vector<bool> is_smooth;          ///< the normal points outwards
    /// On a border where it is regular, and not alone in its face: there the normal may point to either side. At others
    /// OpenSubdiv's tangents across the border are not those that refinement leads to.
    std::vector<bool> is_smooth_border;
};

/// Of the control vertices, by limit masks. Semi-sharp ones are to have faded. Empty where surfaces meet in edges or
/// vertices: OpenSubdiv 3.5 writes beyond its arrays of weights where an edge has many faces.
VertexLimits VertexLimitsByOpenSubdiv(const ControlSurface& surface);
VertexLimits VertexLimitsByOpenSubdiv(const PolygonSurface& surface);

}  // namespace SolidSubdiv::Validation
