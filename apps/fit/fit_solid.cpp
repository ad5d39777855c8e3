// SPDX-License-Identifier: Apache-2.0
// Fits, and a look at the refined cells after each.
#include <solidsubdiv/apps/fit/fit_solid.h>

#include <algorithm>
#include <map>
#include <set>

#include <solidsubdiv/apps/fit/internal/cell_volumes.h>
#include <solidsubdiv/far/stencil_table.h>
#include <solidsubdiv/far/topology_refiner.h>
#include <solidsubdiv/kit/geometry/cell_quality.h>
#include <solidsubdiv/kit/geometry/limits_of_vertices.h>
#include <solidsubdiv/osd/evaluator.h>
#include <solidsubdiv/sdc/errors.h>

namespace SolidSubdiv::Fit {

namespace {

Far::TopologyRefiner RefinerOf(const ControlMesh& mesh) {
    auto refiner =
        Far::TopologyRefiner::Create(mesh.View(), mesh.hexes.empty() ? Sdc::Split::TetOct : Sdc::Split::Polyhedral);
    refiner.RefineUniform({.max_level = kFoldLevel, .full_topology_in_last_level = true});
    return refiner;
}

/// Numbers of the limit's cells at kFoldLevel that are folded.
std::vector<Index> FoldedFineCells(const Far::TopologyRefiner& refiner, const Sdc::Scheme& scheme,
                                   std::vector<double> positions) {
    const auto table = Far::StencilTable::Create(refiner, scheme);
    Osd::Evaluator refine(table, Osd::Backend::Best());
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
        if (cells[c].sign == Geometry::MinimumSign::Negative) folded.push_back(static_cast<Index>(c));
    }
    return folded;
}

/// Limits of vertices of kFoldLevel over the control points.
Far::StencilRows<double> LimitsOverControl(const Far::TopologyRefiner& refiner, const Sdc::Scheme& scheme,
                                           const std::vector<Index>& vertices) {
    const Far::StencilRows<double> limits = Geometry::LimitsOfVertices(refiner, scheme, kFoldLevel).rows;
    std::set<Index> needed;
    for (Index v : vertices) {
        const auto row = limits.Indices(v);
        needed.insert(row.begin(), row.end());
    }
    const std::vector<Index> chosen(needed.begin(), needed.end());
    const auto table = Far::StencilTable::CreateComposite(refiner, scheme, {{.level = kFoldLevel, .vertices = chosen}});
    const Far::StencilRows<double>& fine = table.level(1);
    Far::StencilRows<double> rows;
    rows.n_sources = fine.n_sources;
    rows.offsets.assign(1, 0);
    for (Index v : vertices) {
        std::map<Index, double> sum;
        for (std::size_t k = 0; k < limits.Indices(v).size(); ++k) {
            const auto at = std::lower_bound(chosen.begin(), chosen.end(), limits.Indices(v)[k]) - chosen.begin();
            const auto row = static_cast<Index>(at);
            for (std::size_t i = 0; i < fine.Indices(row).size(); ++i) {
                sum[fine.Indices(row)[i]] += limits.Weights(v)[k] * fine.Weights(row)[i];
            }
        }
        for (const auto& [p, w] : sum) {
            rows.indices.push_back(p);
            rows.weights.push_back(w);
        }
        rows.offsets.push_back(static_cast<Offset>(rows.indices.size()));
    }
    return rows;
}

/// The barrier stands at corners of these cells of kFoldLevel from now on.
void KeepFromFolding(const std::set<Index>& cells, const Far::TopologyRefiner& refiner, const Sdc::Scheme& scheme,
                     bool is_hexahedral, Problem& problem) {
    ControlMesh fine;  // of these cells alone
    std::map<Index, Index> numbers;
    std::vector<Index> vertices;
    const auto add = [&](std::span<const Index> cell, std::vector<Index>& to) {
        for (Index v : cell) {
            const auto found = numbers.try_emplace(v, static_cast<Index>(vertices.size()));
            if (found.second) vertices.push_back(v);
            to.push_back(found.first->second);
        }
    };
    for (Index c : cells) {
        if (is_hexahedral) {
            add(refiner.polyhedral_level(kFoldLevel).CellVertices(c), fine.hexes);
        } else if (const Vtr::Level& level = refiner.level(kFoldLevel); c < level.n_tets) {
            add(level.TetVertices(c), fine.tets);
        } else {
            add(level.OctVertices(c - level.n_tets), fine.octs);
        }
    }
    problem.fine_corners = Internal::CellCornersOf(fine);
    problem.fine_places = LimitsOverControl(refiner, scheme, vertices);
}

}  // namespace

std::vector<Index> FoldedCells(const ControlMesh& mesh, const Sdc::Scheme& scheme) {
    return FoldedFineCells(RefinerOf(mesh), scheme, mesh.positions);
}

SolidFit FitSolid(const ControlMesh& start, const Sdc::Scheme& scheme, const TargetSurface& target,
                  const Options& options, int rate, int fine_rate) {
    if (!start.is_solid()) throw InvalidInput("fit: there are no cells to keep from folding");
    constexpr int kMostFits = 8;
    SolidFit fit{.problem = MakeProblem(start, scheme, target, rate, fine_rate, options.normals > 0), .result = {}};
    const Far::TopologyRefiner refiner = RefinerOf(start);
    std::set<Index> kept;  // cells of kFoldLevel that were folded once
    for (int i = 0; i < kMostFits; ++i) {
        Result result = FitControlPoints(fit.problem, options);
        const std::vector<Index> folded = FoldedFineCells(refiner, scheme, result.control);
        const auto n_folded = static_cast<Offset>(folded.size());
        const bool is_cancelled = result.stopped == "cancelled";
        if (i == 0 || n_folded < fit.n_folded) {
            fit.result = std::move(result);
            fit.n_folded = n_folded;
        }
        fit.n_fits = i + 1;
        if (n_folded == 0 || is_cancelled) break;
        kept.insert(folded.begin(), folded.end());
        KeepFromFolding(kept, refiner, scheme, !start.hexes.empty(), fit.problem);
    }
    return fit;
}

}  // namespace SolidSubdiv::Fit
