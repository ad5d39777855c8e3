// SPDX-License-Identifier: Apache-2.0
// OpenSubdiv's refiners of surfaces, for the oracles that read its topology. Not for other files: it
// shows OpenSubdiv's types.
#pragma once

#include <opensubdiv/far/topologyRefiner.h>

#include <memory>

#include "surface_levels.h"

namespace SolidSubdiv::Validation {

/// Refined to max_level, with all relations in the last level too.
/// @throws std::runtime_error if OpenSubdiv refuses the surface
std::unique_ptr<OpenSubdiv::Far::TopologyRefiner> MakeOpenSubdivRefiner(const ControlSurface& surface, int max_level);

/// The same of a surface of polygons.
std::unique_ptr<OpenSubdiv::Far::TopologyRefiner> MakeOpenSubdivRefiner(const PolygonSurface& surface, int max_level);

/// Copies vertices, triangles or polygons, edges and, but for the last level, children.
/// @param has_face_points of Catmull-Clark's and the linear scheme: then faces go to `faces`, not to `triangles`
void CopyTopology(const OpenSubdiv::Far::TopologyLevel& from, bool is_last, SurfaceLevel& to,
                  bool has_face_points = false);

}  // namespace SolidSubdiv::Validation
