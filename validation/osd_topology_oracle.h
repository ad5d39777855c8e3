// SPDX-License-Identifier: Apache-2.0
// OpenSubdiv's Loop refiner of a triangle surface, for the oracles that read its topology. Not for other files: it
// shows OpenSubdiv's types.
#pragma once

#include <opensubdiv/far/topologyRefiner.h>

#include <memory>

#include "surface_levels.h"

namespace SolidSubdiv::Validation {

/// Refined to max_level, with all relations in the last level too.
/// @throws std::runtime_error if OpenSubdiv refuses the surface
std::unique_ptr<OpenSubdiv::Far::TopologyRefiner> MakeOpenSubdivRefiner(const ControlSurface& surface, int max_level);

/// Copies vertices, triangles, edges and, but for the last level, children.
void CopyTopology(const OpenSubdiv::Far::TopologyLevel& from, bool is_last, SurfaceLevel& to);

}  // namespace SolidSubdiv::Validation
