// SPDX-License-Identifier: Apache-2.0
// Fits, and a look at the refined cells after each.
#include <solidsubdiv/apps/fit/fit_solid.h>

#include <algorithm>
#include <set>

#include <solidsubdiv/apps/fit/internal/refined_cells.h>
#include <solidsubdiv/sdc/errors.h>

namespace SolidSubdiv::Fit {

namespace {

/// As deep as cells are written by default, unless there are too many of them.
int FoldLevelOf(const ControlMesh& mesh) {
    constexpr std::size_t kFew = 4000;
    const std::size_t n_cells = mesh.tets.size() / 4 + mesh.octs.size() / 6 + mesh.hexes.size() / 8;
    return n_cells <= kFew ? 3 : 2;
}

}  // namespace

std::vector<Index> FoldedCells(const ControlMesh& mesh, const Sdc::Scheme& scheme, int level) {
    return Internal::RefinedCells(mesh, scheme, level).FindFolded(mesh.positions);
}

SolidFit FitSolid(const ControlMesh& start, const Sdc::Scheme& scheme, const TargetSurface& target,
                  const Options& options, int rate, int fine_rate) {
    if (!start.is_solid()) throw InvalidInput("fit: there are no cells to keep from folding");
    constexpr int kMostFits = 12, kMostInVain = 4, kFew = 3;
    constexpr double kMany = 0.005;  // of the cells: after so few fits they won't unfold, and each fit takes long
    SolidFit fit{.problem = MakeProblem(start, scheme, target, rate, fine_rate, options.normals > 0), .result = {}};
    fit.level = FoldLevelOf(start);
    const Internal::RefinedCells cells(start, scheme, fit.level);
    int best = 0;
    std::set<Index> kept;  // cells that were folded once
    Options how = options;
    how.is_measured = false;
    for (int i = 0; i < kMostFits; ++i) {
        Result result = FitControlPoints(fit.problem, how);
        const std::vector<Index> folded = cells.FindFolded(result.control);
        const auto n_folded = static_cast<Offset>(folded.size());
        const bool is_cancelled = result.stopped == "cancelled";
        if (i == 0 || n_folded < fit.n_folded) {
            best = i;
            fit.result = std::move(result);
            fit.n_folded = n_folded;
        }
        fit.n_fits = i + 1;
        if (n_folded == 0 || is_cancelled || i - best >= kMostInVain) break;
        if (fit.n_fits >= kFew && static_cast<double>(n_folded) > kMany * static_cast<double>(cells.n_cells())) break;
        const std::size_t n_before = kept.size();
        kept.insert(folded.begin(), folded.end());
        if (kept.size() == n_before) {
            how.barrier *= 10;  // those that fold are kept from it already
            continue;
        }
        auto fine = cells.CornersOf(kept);
        fit.problem.fine_places = std::move(fine.places);
        fit.problem.fine_corners = std::move(fine.corners);
    }
    if (options.is_measured) Measure(fit.problem, fit.result);
    return fit;
}

}  // namespace SolidSubdiv::Fit
