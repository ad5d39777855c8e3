// SPDX-License-Identifier: Apache-2.0
// The places of a mesh for `analyze FILE`.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include <solidsubdiv/apps/cli/analyze_report.h>
#include <solidsubdiv/apps/cli/scheme_options.h>

namespace SolidSubdiv::Cli {

struct FilePlaces {
    Sdc::Scheme scheme;
    std::vector<AnalyzedPlace> places;
    std::string left_out;  ///< lines on what is not analyzed; may be empty
    Json json;             ///< of the mesh: counts and what is left out
};

/// Reads, orients, chooses diagonals, sorts the places into kinds and analyzes one of each: of each type of place at
/// most the kMostKinds most frequent, unless wants_all.
/// @throws InvalidInput about the file where the scheme does not take it or where there is no place
inline constexpr Index kMostKinds = 2000;
FilePlaces AnalyzeFile(const std::string& file, const SchemeOptions& options, bool wants_all, Session& session);

}  // namespace SolidSubdiv::Cli
