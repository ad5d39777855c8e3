// SPDX-License-Identifier: Apache-2.0
// Limits of all vertices of a level, those too where creases have yet to fade.
//
// Far::LimitStencilTable leaves vertices without a row where the level's rules still change from level to level. As
// corners of boundary faces their limits are known: places are followed down until creases there have faded.
#pragma once

#include <vector>

#include <solidsubdiv/far/stencil_table.h>
#include <solidsubdiv/sdc/schemes.h>

namespace SolidSubdiv::Geometry {

struct VertexLimits {
    Far::StencilRows<double> rows;     ///< (n_vertices) over the vertices of the level
    std::vector<Index> without_limit;  ///< vertices that the scheme gives none: their row is the vertex itself
};

/// @throws InvalidInput if the level has no full topology or the scheme can't refine the mesh
VertexLimits LimitsOfVertices(const Far::TopologyRefiner& refiner, const Sdc::Scheme& scheme, int level);

}  // namespace SolidSubdiv::Geometry
