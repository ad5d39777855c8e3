// SPDX-License-Identifier: Apache-2.0
// Which rule governs each edge and vertex of a complex of polyhedra, from the links of level 0.
#pragma once

#include <solidsubdiv/vtr/polyhedral_level.h>

namespace SolidSubdiv::Vtr::Internal {

/// Cells at the vertices, hexahedra first. @pre hexahedra and polyhedra have their vertices
Relation CellsAtVertices(const PolyhedralLevel& level);

/// Fills edge_tags and vertex_tags. @pre all tables and relations are there
/// Source: rules.md section 7 (chang2003interpolatory, "non-manifold").
void TagEdgesAndVertices(PolyhedralLevel& level);

}  // namespace SolidSubdiv::Vtr::Internal
