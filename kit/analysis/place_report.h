// SPDX-License-Identifier: Apache-2.0
// All that is found out about one place: subdivision matrix, eigenvalues, characteristic map, verdict.
//
//     auto report = Analysis::AnalyzeStar(Analysis::EdgeStar(Sdc::Mlca{}, 5), Sdc::Mlca{});
//     report.verdict.text;   // "C1 uneven: shrinks by 0.5 to 0.549988, next 0.34006"
#pragma once

#include <optional>

#include <solidsubdiv/kit/analysis/characteristic_map.h>
#include <solidsubdiv/kit/analysis/star.h>
#include <solidsubdiv/kit/analysis/verdict.h>

namespace SolidSubdiv::Analysis {

struct PlaceReport {
    Far::LocalMatrix matrix;
    Spectrum spectrum;
    std::optional<CharacteristicMap> map;  ///< only where the eigenvalues leave the verdict to it
    Verdict verdict;
};

/// The matrix around the middle of a star: the smallest set of points that holds it and its neighbours and depends on
/// itself alone. @throws InvalidInput if the rows leave the star, which those of no scheme in Sdc::Scheme do
Far::LocalMatrix MatrixOf(const Star& star, const Sdc::Scheme& scheme);

/// Cost: three splits of the star and an eigenvalue problem of some tens of points; a fourth split and a linear system
/// of some hundreds for the map.
PlaceReport AnalyzeStar(const Star& star, const Sdc::Scheme& scheme);

/// The same of a matrix that was changed: a test's planted fault. The map is that of the scheme.
PlaceReport AnalyzeMatrix(Far::LocalMatrix matrix, const Star& star, const Sdc::Scheme& scheme);

}  // namespace SolidSubdiv::Analysis
