// SPDX-License-Identifier: Apache-2.0
// Validator fit-folded: where a fit says that no cell is folded, none is at random places.
#include "fit_folded.h"

#include <array>

#include <solidsubdiv/far/place.h>
#include <solidsubdiv/far/primvar_refiner.h>

#include "fit_shapes.h"
#include "points.h"
#include "solid_shapes.h"
#include "validators.h"

namespace SolidSubdiv::Validation {

namespace {

/// Four places at each of n: itself, and a little along each coordinate.
std::vector<Far::Place> PlacesOf(const FitLevels& levels, int level, int n) {
    Shaker shaker(1);
    const auto n_cells = static_cast<int>(levels.refiner.n_cells(level));
    const Index first_oct = levels.refiner.is_polyhedral() ? n_cells : levels.refiner.level(level).n_tets;
    constexpr double kStep = 1e-4;
    std::vector<Far::Place> places;
    for (int i = 0; i < n; ++i) {
        Far::Place place{.element = static_cast<Index>(shaker.Below(n_cells))};
        const auto uniform = [&] { return 0.5 + 0.499 * shaker.Next(); };
        // In tets and octants of octahedra coordinates sum to 1 at most.
        do place.at = {uniform(), uniform(), uniform()};
        while (place.at[0] + place.at[1] + place.at[2] > 0.999);
        for (double& x : place.at) x *= place.element >= first_oct && shaker.Next() < 0 ? -1 : 1;
        places.push_back(place);
        for (std::size_t c = 0; c < 3; ++c) {
            places.push_back(place);
            places.back().at[c] += kStep;
        }
    }
    return places;
}

/// Of the four points from the i-th on.
double Determinant(const std::vector<double>& points, std::size_t i) {
    const double* const p = &points[12 * i];
    std::array<std::array<double, 3>, 3> e{};
    for (std::size_t k = 0; k < 3; ++k) {
        for (std::size_t c = 0; c < 3; ++c) e[k][c] = p[3 * (k + 1) + c] - p[c];
    }
    return e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) + e[0][1] * (e[1][2] * e[2][0] - e[1][0] * e[2][2]) +
           e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0]);
}

void CheckFit(const FitCase& c, const FitTarget& target, int n_places, Findings& findings) {
    const Fit::Problem problem = Fit::MakeProblem(c.mesh, c.scheme, target.View(), 2);
    const Fit::Result result = FitControlPoints(problem, {.max_rounds = 8});
    const FitLevels levels(c.mesh, result.control, c.scheme, 2);
    std::string text = std::to_string(result.n_folded) + " corners folded; places folded in levels 0 to 2:";
    for (int level = 0; level <= 2; ++level) {
        const std::vector<Index> folded = FoldedCells(levels, level, n_places);
        const auto& positions = levels.after[static_cast<std::size_t>(level)];
        CompareVerdicts(Geometry::MeasureQuality(levels.refiner, level, positions), folded,
                        "level " + std::to_string(level), findings);
        // Of tets and octahedra corners say everything: there the fit's own count is a proof as well.
        if (level == 0 && c.mesh.hexes.empty() && result.n_folded == 0 && !folded.empty()) {
            findings.Fault("cell " + std::to_string(folded[0]) + " is folded, and the fit says that no corner is");
        }
        findings.n_compared += n_places;
        text += " " + std::to_string(folded.size());
    }
    findings.notes.push_back(text + " of " + std::to_string(n_places) + " each");
}

}  // namespace

FitLevels::FitLevels(const Fit::ControlMesh& at_rest, const std::vector<double>& fitted, const Sdc::Scheme& scheme,
                     int n_levels)
    : refiner(Far::TopologyRefiner::Create(at_rest.View(),
                                           at_rest.hexes.empty() ? Sdc::Split::TetOct : Sdc::Split::Polyhedral)),
      before{at_rest.positions},
      after{fitted} {
    refiner.RefineUniform({.max_level = n_levels});
    const Far::PrimvarRefiner primvars(refiner, scheme);
    for (int level = 1; level <= n_levels; ++level) {
        for (auto* positions : {&before, &after}) {
            std::vector<double> fine(3 * static_cast<std::size_t>(refiner.n_vertices(level)));
            primvars.Interpolate<double>(level, positions->back(), fine, 3);
            positions->push_back(std::move(fine));
        }
    }
}

std::vector<Index> FoldedCells(const FitLevels& levels, int level, int n_places) {
    const std::vector<Far::Place> places = PlacesOf(levels, level, n_places);
    const auto rows = Far::MakePlaceRows(levels.refiner, level, places);
    const auto l = static_cast<std::size_t>(level);
    const std::vector<double> here = Apply(rows, levels.before[l]), there = Apply(rows, levels.after[l]);
    std::vector<Index> folded;
    for (std::size_t i = 0; 4 * i < places.size(); ++i) {
        if (!(Determinant(here, i) * Determinant(there, i) > 0)) folded.push_back(places[4 * i].element);
    }
    return folded;
}

void CompareVerdicts(std::span<const Geometry::CellQuality> verdicts, std::span<const Index> folded,
                     const std::string& what, Findings& findings) {
    for (Index cell : folded) {
        if (verdicts[static_cast<std::size_t>(cell)].sign != Geometry::MinimumSign::Positive) continue;
        findings.Fault(what + ": cell " + std::to_string(cell) + " is folded, and proved not to be");
    }
}

Findings ValidateFitFolded(const Context& context) {
    Findings findings;
    const FitTarget ball = MakeFitBall(8), bunny = ReadFitBunny(context.shapes);
    const auto check = [&](const std::string& name, const FitTarget& target) {
        for (const FitCase& c : FitCasesAround(target.View(), context.is_quick ? 64 : 100)) {
            if (!c.mesh.is_solid()) continue;
            Findings found;
            CheckFit(c, target, context.is_quick ? 1000 : 30000, found);
            findings.Merge(found, c.name + " fitted to the " + name);
        }
    };
    check("ball", ball);
    check("bunny", bunny);
    return findings;
}

}  // namespace SolidSubdiv::Validation
