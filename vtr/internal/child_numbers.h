// SPDX-License-Identifier: Apache-2.0
// Where each group of children starts in the numbering of refinement.h.
#pragma once

#include <solidsubdiv/sdc/cell_split.h>
#include <solidsubdiv/vtr/level.h>

namespace SolidSubdiv::Vtr::Internal {

struct ChildNumbers {
    Index edge_point, centre;   ///< first vertex on an edge, at a centre
    Index face_edge, oct_edge;  ///< first edge on a face, in an oct
    Index tet_face, oct_face;   ///< first face in a tet, in an oct

    explicit ChildNumbers(const Level& parent)
        : edge_point(parent.n_vertices),
          centre(edge_point + parent.n_edges),
          face_edge(2 * parent.n_edges),
          oct_edge(face_edge + 3 * parent.n_faces),
          tet_face(4 * parent.n_faces),
          oct_face(tet_face + Sdc::CellSplit<Sdc::Tet>::kInnerFaces * parent.n_tets) {}
};

}  // namespace SolidSubdiv::Vtr::Internal
