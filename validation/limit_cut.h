// SPDX-License-Identifier: Apache-2.0
// Cuts the neighbourhood of an element out of a refined level.
#pragma once

#include "limit_walk.h"

namespace SolidSubdiv::Validation {

struct CutOut {
    OwnedMesh mesh;
    std::vector<Index> vertices;    ///< of the level, for each of the mesh's
    std::vector<Index> number;      ///< of the mesh, for each of the level's vertices, or kNoIndex
    std::vector<bool> is_complete;  ///< of the mesh's vertices: whether all elements at it were kept
};

/// Elements that have all core vertices, and n_rings of elements around them.
/// @param is_mixed whether there are faces in no cell and edges in no face beside cells; the level is full then
CutOut CutAround(const Far::TopologyRefiner& refiner, int level, const std::vector<Index>& core, int n_rings,
                 bool is_mixed, const Far::Creases& creases);

}  // namespace SolidSubdiv::Validation
