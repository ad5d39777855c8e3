// SPDX-License-Identifier: Apache-2.0
// A lattice of cells fitted to a surface, with all of its refined cells unfolded if that can be.
//
//     Fit::ControlMesh lattice = Fit::FindSolidStart(target, scheme, {.n_control = 400});
//     const Fit::SolidFit fit = Fit::FitSolid(lattice, scheme, target, {});
//     lattice.positions = fit.result.control;
//
// Tets and octahedra are refined with the diagonals that their order gives (far/choose_diagonals.h reorders them).
//
// Corners of control cells may be well shaped although what they are refined into is folded. Where that is so, the
// barrier stands at the corners of those refined cells as well, and all is fitted again.
#pragma once

#include <solidsubdiv/apps/fit/fit.h>

namespace SolidSubdiv::Fit {

struct SolidFit {
    Problem problem;
    Result result;
    int n_fits = 0;
    int level = 0;        ///< at which the limit's cells were looked at: 3, of more than 4000 cells 2
    Offset n_folded = 0;  ///< of those cells, in the result
};

/// Numbers of the limit's cells at a level that are folded (hexahedra; or tets, then octahedra).
/// @throws InvalidInput where the scheme can't refine the mesh
std::vector<Index> FoldedCells(const ControlMesh& mesh, const Sdc::Scheme& scheme, int level);

/// Of all fits that were made the one with the fewest folded cells, among these the first.
/// @throws InvalidInput as MakeProblem, and where there are no cells; SolverError. What was found so far where progress
/// cancels.
SolidFit FitSolid(const ControlMesh& start, const Sdc::Scheme& scheme, const TargetSurface& target,
                  const Options& options, int rate = 4, int fine_rate = 0);

}  // namespace SolidSubdiv::Fit
