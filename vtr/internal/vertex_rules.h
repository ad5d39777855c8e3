// SPDX-License-Identifier: Apache-2.0
// Which rule governs each edge and vertex of a complex of mixed dimension, from the links of level 0.
#pragma once

#include <solidsubdiv/vtr/level.h>

namespace SolidSubdiv::Vtr::Internal {

/// Fills edge_tags and vertex_tags. @pre all downward and upward relations and face_tags are there
/// Source: rules.md section 7 (chang2003interpolatory, "non-manifold").
void TagEdgesAndVertices(Level& level);

}  // namespace SolidSubdiv::Vtr::Internal
