// SPDX-License-Identifier: Apache-2.0
// Level by level, then to the limit.
#include <solidsubdiv/apps/fit/internal/refined_cells.h>

#include <algorithm>
#include <map>

#include <solidsubdiv/apps/fit/fit.h>
#include <solidsubdiv/apps/fit/internal/cell_volumes.h>
#include <solidsubdiv/kit/geometry/cell_quality.h>
#include <solidsubdiv/kit/geometry/limits_of_vertices.h>
#include <solidsubdiv/osd/evaluator.h>

namespace SolidSubdiv::Fit::Internal {

namespace {

Far::TopologyRefiner Refine(const ControlMesh& mesh, int level) {
    auto refiner =
        Far::TopologyRefiner::Create(mesh.View(), mesh.hexes.empty() ? Sdc::Split::TetOct : Sdc::Split::Polyhedral);
    refiner.RefineUniform({.max_level = level, .full_topology_in_last_level = true});
    return refiner;
}

/// sum of weights[k] * rows[indices[k]], for each of `rows`
void AddRow(std::span<const Index> indices, std::span<const double> weights, const Far::StencilRows<double>& of,
            const std::vector<Index>& numbers, std::map<Index, double>& sum) {
    for (std::size_t k = 0; k < indices.size(); ++k) {
        const auto row =
            static_cast<Index>(std::lower_bound(numbers.begin(), numbers.end(), indices[k]) - numbers.begin());
        for (std::size_t i = 0; i < of.Indices(row).size(); ++i)
            sum[of.Indices(row)[i]] += weights[k] * of.Weights(row)[i];
    }
}

}  // namespace

RefinedCells::RefinedCells(const ControlMesh& mesh, const Sdc::Scheme& scheme, int level)
    : scheme_(scheme),
      level_(level),
      refiner_(Refine(mesh, level)),
      levels_(Far::StencilTable::Create(refiner_, scheme)),
      limits_(Geometry::LimitsOfVertices(refiner_, scheme, level).rows) {}

Offset RefinedCells::n_cells() const {
    if (refiner_.is_polyhedral()) return refiner_.polyhedral_level(level_).n_cells();
    const Vtr::Level& level = refiner_.level(level_);
    return Offset{level.n_tets} + level.n_octs;
}

std::vector<Index> RefinedCells::FindFolded(std::span<const double> control) const {
    std::vector<double> positions(control.begin(), control.end());
    Osd::Evaluator refine(levels_, Osd::Backend::Best());
    for (int level = 1; level <= level_; ++level) {
        std::vector<double> refined(3 * static_cast<std::size_t>(refiner_.n_vertices(level)));
        refine.EvaluateRange(level, Osd::BufferView<const double>(positions, 3), Osd::BufferView<double>(refined, 3), 0,
                             refiner_.n_vertices(level));
        positions = std::move(refined);
    }
    const std::vector<double> pushed = MovingSurface{limits_, {}}.Positions(positions);
    const auto cells = Geometry::MeasureQuality(refiner_, level_, pushed);
    std::vector<Index> folded;
    for (std::size_t c = 0; c < cells.size(); ++c) {
        if (cells[c].sign == Geometry::MinimumSign::Negative) folded.push_back(static_cast<Index>(c));
    }
    return folded;
}

Far::StencilRows<double> RefinedCells::PlacesOf(const std::vector<Index>& vertices) const {
    std::set<Index> needed;
    for (Index v : vertices) needed.insert(limits_.Indices(v).begin(), limits_.Indices(v).end());
    const std::vector<Index> chosen(needed.begin(), needed.end());
    const auto table = Far::StencilTable::CreateComposite(refiner_, scheme_, {{.level = level_, .vertices = chosen}});
    Far::StencilRows<double> rows;
    rows.n_sources = table.level(1).n_sources;
    rows.offsets.assign(1, 0);
    for (Index v : vertices) {
        std::map<Index, double> sum;
        AddRow(limits_.Indices(v), limits_.Weights(v), table.level(1), chosen, sum);
        for (const auto& [p, w] : sum) {
            rows.indices.push_back(p);
            rows.weights.push_back(w);
        }
        rows.offsets.push_back(static_cast<Offset>(rows.indices.size()));
    }
    return rows;
}

RefinedCells::Corners RefinedCells::CornersOf(const std::set<Index>& cells) const {
    ControlMesh mesh;  // of these cells alone
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
        if (refiner_.is_polyhedral()) {
            add(refiner_.polyhedral_level(level_).CellVertices(c), mesh.hexes);
        } else if (const Vtr::Level& level = refiner_.level(level_); c < level.n_tets) {
            add(level.TetVertices(c), mesh.tets);
        } else {
            add(level.OctVertices(c - level.n_tets), mesh.octs);
        }
    }
    return {PlacesOf(vertices), CellCornersOf(mesh)};
}

}  // namespace SolidSubdiv::Fit::Internal
