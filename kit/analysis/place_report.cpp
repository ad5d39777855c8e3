// SPDX-License-Identifier: Apache-2.0
// Eigenvalues first; the characteristic map where they don't decide.
#include <solidsubdiv/kit/analysis/place_report.h>

#include <solidsubdiv/kit/analysis/subdivision_matrix.h>

namespace SolidSubdiv::Analysis {

namespace {

Far::TopologyRefiner Refined(const Star& star, int n_levels) {
    auto refiner = Far::TopologyRefiner::Create(star.View(), star.split);
    refiner.RefineUniform({.max_level = n_levels});
    return refiner;
}

}  // namespace

Far::LocalMatrix MatrixOf(const Star& star, const Sdc::Scheme& scheme) {
    auto matrix = MatrixAround(Refined(SplitOnce(star), 3), 0, 0, scheme);
    if (!matrix)
        throw InvalidInput("the rows around a place of scheme " + std::string(Sdc::NameOf(scheme)) +
                           " reach beyond its star, or its levels don't look alike");
    return *std::move(matrix);
}

PlaceReport AnalyzeStar(const Star& star, const Sdc::Scheme& scheme) {
    return AnalyzeMatrix(MatrixOf(star, scheme), star, scheme);
}

PlaceReport AnalyzeMatrix(Far::LocalMatrix matrix, const Star& star, const Sdc::Scheme& scheme) {
    PlaceReport report;
    report.matrix = std::move(matrix);
    report.spectrum = SpectrumOf(report.matrix);
    const Separation separation = SeparationOf(report.spectrum, star.dimension);
    if (separation.is_separated || (separation.is_positive && star.is_on_edge)) {
        const Star split = SplitOnce(star);
        // Most schemes reach two rings far; where rows leave the star, a finer ring has more room and fewer samples.
        for (const MapLevels levels : {MapLevels{2, star.dimension == 2 ? 4 : 2}, MapLevels{3, 1}}) {
            if (report.map) break;
            report.map =
                MakeCharacteristicMap(Refined(split, levels.max_level()), split, scheme, report.spectrum, levels);
        }
    }
    report.verdict = VerdictOf(report.spectrum, star.dimension, report.map);
    return report;
}

}  // namespace SolidSubdiv::Analysis
