// SPDX-License-Identifier: Apache-2.0
// The matrix that takes the points around a vertex to the points around it one level on: for any scheme and any place,
// however far the scheme's stencils reach.
//
//     auto refiner = Far::TopologyRefiner::Create(descriptor, Sdc::Split::TetOct);
//     refiner.RefineUniform({.max_level = 3});
//     auto m = Analysis::MatrixAround(refiner, 0, vertex, Sdc::Interpolatory{});
//
// Far::MakeLocalMatrix is the quick form for schemes whose rows at a vertex and its neighbours use those alone.
#pragma once

#include <optional>

#include <solidsubdiv/far/local_matrix.h>
#include <solidsubdiv/far/topology_refiner.h>
#include <solidsubdiv/sdc/schemes.h>

namespace SolidSubdiv::Analysis {

/// The matrix around `vertex` of level `level`, from the rows between the refiner's last two levels: the smallest set
/// of points that holds the vertex and its neighbours and that the rows do not leave. `ring` names them at the last
/// level but one, the vertex first. Three levels after `level` keep the stencils of every scheme inside the vertex's
/// star (among polyhedra: one after a level whose faces at the vertex are quadrilaterals). None if they leave it, or
/// where levels don't look alike. Cost: the refiner's tables under the scheme, and a walk over the vertices of its
/// levels.
std::optional<Far::LocalMatrix> MatrixAround(const Far::TopologyRefiner& refiner, int level, Index vertex,
                                             const Sdc::Scheme& scheme);

}  // namespace SolidSubdiv::Analysis
