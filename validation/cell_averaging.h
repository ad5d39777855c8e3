// SPDX-License-Identifier: Apache-2.0
// Holds steps of the cell-averaging schemes to the plain program of cell_averaging_oracle.h: each level is made from
// ours of the level before.
#pragma once

#include <vector>

#include <solidsubdiv/far/stencil_table.h>
#include <solidsubdiv/far/topology_refiner.h>

#include "findings.h"

namespace SolidSubdiv::Validation {

/// Positions by a table's levels, over `size`, against averages over tets and octahedra, inside.
void CompareWithTetOctAverages(const Far::TopologyRefiner& refiner, const Far::StencilTable& table,
                               const std::vector<double>& positions, double size, Findings& findings);

/// The same against averages over polyhedra, inside and on the boundary. @param sharp the scheme's features
void CompareWithPolyhedralAverages(const Far::TopologyRefiner& refiner, const Far::StencilTable& table,
                                   const std::vector<double>& positions, double size, bool sharp, Findings& findings);

}  // namespace SolidSubdiv::Validation
