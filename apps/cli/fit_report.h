// SPDX-License-Identifier: Apache-2.0
// What a fit found, for people, programs and eyes.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

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

/// Bytes of a text or a picture. @throws IoError
void WriteText(const std::filesystem::path& file, const std::string& text);

#ifdef SOLIDSUBDIV_HAS_PICTURES
/// Distances both ways, round after round, as SVG.
std::string ConvergencePlot(const FitSummary& summary);
/// Target, control mesh (of a solid its boundary) around the limit, and the limit with its distances from the target,
/// as a PNG file's bytes.
std::vector<std::uint8_t> FitPicture(const FitSummary& summary, const Io::Mesh& control, const Progress& progress);
/// All of it as a page. @param json of the whole run
std::string FitPage(const FitSummary& summary, const Io::Mesh& control, const Json& json, const std::string& text,
                    const std::string& plot, const std::vector<std::uint8_t>& picture);
#endif

}  // namespace SolidSubdiv::Cli
