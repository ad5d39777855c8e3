// SPDX-License-Identifier: Apache-2.0
// The start that a short fit brings nearest to the target.
//
//     Fit::ControlMesh lattice = Fit::FindSolidStart(target, Sdc::CatmullClarkSolid{}, {.n_control = 400});
//
// How near the cubes of a start lie to a target does not tell whether its cells can follow the shape without folding:
// of sixteen starts for a bunny, each about as near, fits that may not fold end 0.15 % to 0.5 % of its diagonal away.
#pragma once

#include <solidsubdiv/apps/fit/start.h>
#include <solidsubdiv/sdc/schemes.h>

namespace SolidSubdiv::Fit {

/// As MakeSolidStart, but several starts are tried by FitControlPoints: all for a few rounds, the nearest third for as
/// many as it takes. Deterministic, for any
/// number of threads. Cost: a few seconds for 500 control points, shared by the threads.
/// @param n_tried [1, 16]
/// @param trial what the short fits are made to, where that is not the target: a cloud, of the surface around it
/// @throws InvalidInput as MakeSolidStart and MakeProblem, and where n_tried is out of range; SolverError, Cancelled
ControlMesh FindSolidStart(const TargetSurface& target, const Sdc::Scheme& scheme, const StartOptions& options,
                           StartReport* report = nullptr, int n_tried = 12, const TargetSurface& trial = {});

}  // namespace SolidSubdiv::Fit
