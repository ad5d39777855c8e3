// SPDX-License-Identifier: Apache-2.0
// What a fit found, for people, programs and eyes.
#pragma once

#include <filesystem>
#include <string>

#include <solidsubdiv/apps/cli/common.h>
#include <solidsubdiv/apps/fit/fit.h>
#include <solidsubdiv/kit/io/mesh.h>

namespace SolidSubdiv::Cli {

struct FitSummary {
    const Fit::Result& result;
    const Fit::Problem& problem;
    double diagonal = 0;  ///< of the target's box
};

/// Rounds, distances both ways in the target's unit and in percent of its diagonal, folded corners, why it stopped.
Json FitJson(const FitSummary& summary);
std::string FitText(const FitSummary& summary, const Json& json);

/// @throws IoError
void WriteText(const std::filesystem::path& file, const std::string& text);

#ifdef SOLIDSUBDIV_HAS_PICTURES
/// Distances both ways, round after round.
void WriteConvergence(const std::filesystem::path& file, const FitSummary& summary);
/// Target, control mesh (of a solid its boundary) around the limit, and the limit with its distances from the target.
void WriteFitPicture(const std::filesystem::path& file, const FitSummary& summary, const Io::Mesh& control,
                     const Progress& progress);
#endif

}  // namespace SolidSubdiv::Cli
