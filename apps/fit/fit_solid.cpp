// SPDX-License-Identifier: Apache-2.0
// Fits, and a look at the refined cells after each.
#include <solidsubdiv/apps/fit/fit_solid.h>

#include <algorithm>
#include <set>

#include <solidsubdiv/far/stencil_table.h>
#include <solidsubdiv/kit/geometry/cell_quality.h>
#include <solidsubdiv/kit/geometry/limits_of_vertices.h>
#include <solidsubdiv/osd/evaluator.h>
#include <solidsubdiv/sdc/errors.h>

namespace SolidSubdiv::Fit {

namespace {

/// The control cell that a refined one comes from (vtr/refinement.h, vtr/polyhedral_refinement.h).
/// @param n_tets of the control mesh
Index ControlCellOf(Index cell, Index n_tets, Index n_octs, bool is_hexahedral) {
    if (is_hexahedral) return cell >> (3 * kFoldLevel);
    std::vector<std::pair<Index, Index>> counts = {{n_tets, n_octs}};
    for (int level = 0; level < kFoldLevel; ++level) {
        const auto [tets, octs] = counts.back();
        counts.emplace_back(4 * tets + 8 * octs, tets + 6 * octs);
    }
    for (int level = kFoldLevel; level > 0; --level) {
        const Index tets = counts[static_cast<std::size_t>(level)].first;
        const auto [up_tets, up_octs] = counts[static_cast<std::size_t>(level - 1)];
        if (cell < tets) {
            cell = cell < 4 * up_tets ? cell / 4 : up_tets + (cell - 4 * up_tets) / 8;
        } else {
            const Index oct = cell - tets;
            cell = oct < up_tets ? oct : up_tets + (oct - up_tets) / 6;
        }
    }
    return cell;
}

}  // namespace

std::vector<Index> FoldedCells(const ControlMesh& mesh, const Sdc::Scheme& scheme) {
    const bool is_hexahedral = !mesh.hexes.empty();
    auto refiner =
        Far::TopologyRefiner::Create(mesh.View(), is_hexahedral ? Sdc::Split::Polyhedral : Sdc::Split::TetOct);
    refiner.RefineUniform({.max_level = kFoldLevel, .full_topology_in_last_level = true});
    const auto table = Far::StencilTable::Create(refiner, scheme);
    Osd::Evaluator refine(table, Osd::Backend::Best());
    std::vector<double> positions = mesh.positions;
    for (int level = 1; level <= kFoldLevel; ++level) {
        std::vector<double> refined(3 * static_cast<std::size_t>(refiner.n_vertices(level)));
        refine.EvaluateRange(level, Osd::BufferView<const double>(positions, 3), Osd::BufferView<double>(refined, 3), 0,
                             refiner.n_vertices(level));
        positions = std::move(refined);
    }
    Far::StencilRows<double> limits = Geometry::LimitsOfVertices(refiner, scheme, kFoldLevel).rows;
    const Index n_sources = limits.n_sources;
    std::vector<double> pushed(positions.size());
    const auto limit_table = Far::StencilTable::FromRows(n_sources, {std::move(limits)});
    Osd::Evaluator(limit_table, Osd::Backend::Best()).Evaluate(positions, pushed, 3);
    const auto cells = Geometry::MeasureQuality(refiner, kFoldLevel, pushed);
    std::vector<Index> folded;
    for (std::size_t c = 0; c < cells.size(); ++c) {
        if (cells[c].sign != Geometry::MinimumSign::Negative) continue;
        folded.push_back(ControlCellOf(static_cast<Index>(c), static_cast<Index>(mesh.tets.size() / 4),
                                       static_cast<Index>(mesh.octs.size() / 6), is_hexahedral));
    }
    return folded;
}

SolidFit FitSolid(const ControlMesh& start, const Sdc::Scheme& scheme, const TargetSurface& target,
                  const Options& options, int rate, int fine_rate) {
    if (!start.is_solid()) throw InvalidInput("fit: there are no cells to keep from folding");
    constexpr int kMostFits = 5;
    SolidFit fit{.problem = MakeProblem(start, scheme, target, rate, fine_rate, options.normals > 0), .result = {}};
    const std::size_t n_hex_corners = start.hexes.size(), n_tets = start.tets.size() / 4;
    const auto corners_of = [&](Index cell) -> std::pair<std::size_t, std::size_t> {
        const auto c = static_cast<std::size_t>(cell);
        if (n_hex_corners > 0) return {8 * c, 8};
        return c < n_tets ? std::pair(c, std::size_t{1}) : std::pair(n_tets + 4 * (c - n_tets), std::size_t{4});
    };
    std::vector<double> weights(fit.problem.corners.size(), 1.0);
    ControlMesh fitted = start;
    for (int i = 0; i < kMostFits; ++i) {
        fit.problem.corner_weights = weights;
        Result result = FitControlPoints(fit.problem, options);
        fitted.positions = result.control;
        const std::vector<Index> folded = FoldedCells(fitted, scheme);
        const auto n_folded = static_cast<Offset>(folded.size());
        const bool is_cancelled = result.stopped == "cancelled";
        if (i == 0 || n_folded < fit.n_folded) {
            fit.result = std::move(result);
            fit.n_folded = n_folded;
        }
        fit.n_fits = i + 1;
        if (n_folded == 0 || is_cancelled) break;
        for (Index cell : std::set<Index>(folded.begin(), folded.end())) {
            const auto [first, n] = corners_of(cell);
            for (std::size_t k = first; k < first + n; ++k) weights[k] *= 10;
        }
    }
    return fit;
}

}  // namespace SolidSubdiv::Fit
