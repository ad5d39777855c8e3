// SPDX-License-Identifier: Apache-2.0
// What `analyze` says of a list of places: a table, JSON, a plot.
#pragma once

#include <string>
#include <vector>

#include <solidsubdiv/apps/cli/common.h>
#include <solidsubdiv/kit/analysis/mesh_places.h>
#include <solidsubdiv/kit/analysis/place_report.h>

namespace SolidSubdiv::Cli {

struct AnalyzedPlace {
    std::string group;    ///< "vertices inside"
    std::string what;     ///< "24 tets, 14 neighbors"
    Index count = 0;      ///< of a mesh; 0: the place stands for itself
    std::string example;  ///< "vertex 17", or empty
    Analysis::PlaceReport report;
};

/// Place by place in parallel, with progress: example stars of a mesh's kinds, or stars made to order.
void AnalyzeAll(std::vector<AnalyzedPlace>& places, const std::vector<Analysis::Star>& stars, const Sdc::Scheme& scheme,
                const Progress& progress);

/// One line each, by group; of each group at most n_listed lines (0: all) and a word on the others. Where there are
/// counts, each group begins with how many places have which verdict.
std::string PlacesText(const std::vector<AnalyzedPlace>& places, std::size_t n_listed);

/// All of them.
Json PlacesJson(const std::vector<AnalyzedPlace>& places);

/// Eigenvalues, multiplicities, characteristic map and verdict of one.
Json ReportJson(const Analysis::PlaceReport& report);

/// An SVG of the moduli of eigenvalues against the powers of 1/2, a column for each place that PlacesText lists.
/// @throws UsageError where the program was built without pictures
std::string PlacesPlot(const std::vector<AnalyzedPlace>& places, std::size_t n_listed, const std::string& title);

}  // namespace SolidSubdiv::Cli
