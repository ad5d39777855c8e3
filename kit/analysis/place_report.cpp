// SPDX-License-Identifier: Apache-2.0
// Eigenvalues first; the characteristic map where they don't decide.
#include <solidsubdiv/kit/analysis/place_report.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include <solidsubdiv/kit/analysis/subdivision_matrix.h>

namespace SolidSubdiv::Analysis {

namespace {

Far::TopologyRefiner Refined(const Star& star, int n_levels) {
    auto refiner = Far::TopologyRefiner::Create(star.View(), star.split);
    refiner.RefineUniform({.max_level = n_levels});
    return refiner;
}

/// How far the sums of rows are from 1: then the matrix moves what it should only combine.
double ErrorOfSums(const Far::LocalMatrix& m) {
    const auto n = static_cast<std::size_t>(m.size());
    double error = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const auto row = m.weights.begin() + static_cast<std::ptrdiff_t>(i * n);
        error = std::max(error, std::abs(std::accumulate(row, row + m.size(), 0.0) - 1));
    }
    return error;
}

/// Of the eigenvalues after 1 if they stand above all others, or, on an edge, of those across it and along it.
std::optional<CharacteristicMap> MapOf(const Star& split, const Sdc::Scheme& scheme, const Spectrum& spectrum,
                                       bool sorts_edge) {
    const Separation separation = SeparationOf(spectrum, split.dimension);
    if (sorts_edge ? !separation.is_positive : !separation.is_separated) return std::nullopt;
    // Most schemes reach two rings far; where rows leave the star, a finer ring has more room and fewer samples.
    for (const MapLevels levels : {MapLevels{2, split.dimension == 2 ? 4 : 2}, MapLevels{3, 1}}) {
        const auto refiner = Refined(split, levels.max_level());
        if (auto map = MakeCharacteristicMap(refiner, split, scheme, spectrum, levels, sorts_edge)) return map;
    }
    return std::nullopt;
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
    if (const double error = ErrorOfSums(report.matrix); error > 1e-9) {  // round-off of hundreds of weights
        report.spectrum = SpectrumOf(report.matrix);
        report.verdict.text = "not affine: a row's weights are off the sum 1 by " + std::to_string(error);
        return report;
    }
    report.spectrum = SpectrumOf(report.matrix);
    const Star split = SplitOnce(star);
    report.map = MapOf(split, scheme, report.spectrum, false);
    if (report.map && report.map->is_defective) {  // or the eigenvalues are close and not equal
        const Spectrum fine = SpectrumOf(report.matrix, 1e-7);
        const auto map = MapOf(split, scheme, fine, false);
        if (map && !map->is_defective) report.spectrum = fine, report.map = map;
    }
    if (star.is_on_edge && !(report.map && report.map->is_regular())) {
        const auto map = MapOf(split, scheme, report.spectrum, true);
        if (map && map->is_regular()) report.map = map;
    }
    report.verdict = VerdictOf(report.spectrum, star.dimension, report.map);
    return report;
}

}  // namespace SolidSubdiv::Analysis
