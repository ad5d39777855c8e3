// SPDX-License-Identifier: Apache-2.0
// Upward relations of a child level that follow from the parent's: places and items by arithmetic, nothing counted.
#pragma once

#include <solidsubdiv/vtr/level.h>

namespace SolidSubdiv::Vtr::Internal {

/// Edges at the vertices of the child of `parent`: what inverting its edge_vertices gives. @pre parent.is_full
Relation ChildVertexEdges(const Level& parent);

/// Faces at the edges of the child of `parent`: what inverting its face_edges gives. @pre parent.is_full, no cells
/// (faces inside cells come in the order of the cells, which edges on faces do not know)
Relation ChildEdgeFaces(const Level& parent);

}  // namespace SolidSubdiv::Vtr::Internal
