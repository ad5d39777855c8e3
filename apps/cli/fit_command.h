// SPDX-License-Identifier: Apache-2.0
// What `fit` is asked for, and all of its work.
#pragma once

#include <string>

#include <solidsubdiv/apps/cli/common.h>
#include <solidsubdiv/apps/cli/fit_target.h>
#include <solidsubdiv/apps/cli/scheme_options.h>
#include <solidsubdiv/apps/fit/fit.h>

namespace SolidSubdiv::Cli {

struct FitCommandOptions {
    std::string input, folder;
    std::string model;          ///< "solid", "surface", "lattice"; empty: solid where the target is closed
    std::string template_file;  ///< of a lattice: the model that is carried to the target
    bool matched = false;       ///< its vertices and the target's correspond by number
    SchemeOptions scheme;
    int control = 400;    ///< about so many control points
    int max_control = 0;  ///< where a tolerance is not met, more of them, up to so many; 0: four times `control`
    double creases = -1;  ///< of cages, degrees; 0: none; -1: those of mechanical parts
    int levels = 3;       ///< of the refined solid that is written
    bool pictures = true;
    FitTargetOptions target;
    Fit::Options fit;
};

/// Does all of it. @throws UsageError, IoError, InvalidInput, SolverError, Cancelled
void RunFit(const FitCommandOptions& options, Session& session);

}  // namespace SolidSubdiv::Cli
