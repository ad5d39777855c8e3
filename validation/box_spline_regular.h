// SPDX-License-Identifier: Apache-2.0
// Holds tables made on regular blocks of the octet truss to subdivision as a convolution and to the closed form of its
// limit. Places are matched by the refiner's parent-child relations.
#pragma once

#include <vector>

#include <solidsubdiv/far/limit_stencil_table.h>
#include <solidsubdiv/far/stencil_table.h>
#include <solidsubdiv/far/topology_refiner.h>

#include "findings.h"
#include "lattice_convolution.h"
#include "octet_truss.h"

namespace SolidSubdiv::Validation {

/// A block refined, and where every vertex of every level lies, in lattice units over 2^level.
struct RefinedBlock {
    TrussBlock block;
    Far::TopologyRefiner refiner;
    std::vector<std::vector<LatticePoint>> points;
};
RefinedBlock RefineBlock(const TrussBlock& block, int max_level);

/// Values at all levels by a cascaded table against convolution, wherever no boundary rule reaches.
/// @param control three numbers a vertex, at most 1 in size
void CompareValues(const RefinedBlock& refined, const Far::StencilTable& cascaded, const std::vector<double>& control,
                   Findings& findings);

/// Vertices of a level that no boundary rule reaches.
std::vector<Index> RegularVertices(const RefinedBlock& refined, int level);

/// Composite rows for these vertices of one level against rows of the convolution, weight by weight.
void CompareRows(const RefinedBlock& refined, const Far::StencilRows<double>& rows, int level,
                 const std::vector<Index>& vertices, Findings& findings);

/// The values of the last level, taken as control values of the finer lattice, have the same limit as the coarsest.
void CompareLimitOfValues(const RefinedBlock& refined, const Far::StencilTable& cascaded,
                          const std::vector<double>& control, Findings& findings);

/// Limits at the vertices of a level, by rows over that level's values, against the closed form at those places.
void CompareLimitRows(const RefinedBlock& refined, const Far::StencilTable& cascaded,
                      const Far::StencilRows<double>& limits, int level, const std::vector<double>& control,
                      Findings& findings);

}  // namespace SolidSubdiv::Validation
