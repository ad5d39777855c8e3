// SPDX-License-Identifier: Apache-2.0
// What is still sharp at a level, as a caller or a file wants it.
//
//     auto creases = Far::CreasesAt(refiner, Sdc::Loop{}, 2);   // edges (n, 2) and their sharpness, corners and theirs
#pragma once

#include <vector>

#include <solidsubdiv/far/topology_refiner.h>
#include <solidsubdiv/sdc/schemes.h>

namespace SolidSubdiv::Far {

/// Arrays as TopologyDescriptor takes them.
struct Creases {
    std::vector<Index> edges;             ///< (n, 2): ends
    std::vector<float> edge_sharpness;    ///< (n), above 0; 10 and more: for ever
    std::vector<Index> vertices;          ///< (n)
    std::vector<float> vertex_sharpness;  ///< (n)
};

/// Sharp edges and vertices of a level, with the sharpness that the scheme's creasing method leaves them.
/// @param level [0, max_level]; the level itself need not be full
Creases CreasesAt(const TopologyRefiner& refiner, const Sdc::Scheme& scheme, int level);

}  // namespace SolidSubdiv::Far
