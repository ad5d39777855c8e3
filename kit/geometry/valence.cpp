// SPDX-License-Identifier: Apache-2.0
// Histograms of valences and link sizes of a full level.
#include <solidsubdiv/kit/geometry/valence.h>

#include <algorithm>
#include <cassert>

#include <solidsubdiv/sdc/cells.h>

namespace SolidSubdiv::Geometry {

namespace {

void Count(Histogram& histogram, Offset value, Offset how_many = 1) {
    if (static_cast<Offset>(histogram.size()) <= value) histogram.resize(static_cast<std::size_t>(value) + 1, 0);
    histogram[value] += how_many;
}

}  // namespace

ValenceHistograms MeasureValences(const Vtr::Level& level) {
    assert(level.is_full);
    ValenceHistograms result;
    for (Index v = 0; v < level.n_vertices; ++v) {
        const auto edges = level.vertex_edges[v];
        const Offset n_edges = static_cast<Offset>(edges.size());
        Count(result.vertex_edges, n_edges);
        const Vtr::Tag tag = level.vertex_tags[v];
        if (tag.in_cell() && tag.rule() == Vtr::Rule::Solid) {
            const auto locals = level.vertex_octs.Locals(v);
            // Vertices 0 and 1 of an oct are the ends of its major diagonal.
            const auto n_diagonals = std::count_if(locals.begin(), locals.end(), [](Sdc::Local i) { return i < 2; });
            Count(result.solid_adjacent, n_edges + n_diagonals);
        } else if (tag.in_face()) {
            const auto on_surface = [&](Index e) {
                return level.edge_tags[e].in_face() && level.edge_tags[e].rule() != Vtr::Rule::Solid;
            };
            Count(result.surface_edges, std::count_if(edges.begin(), edges.end(), on_surface));
        }
    }
    for (Index e = 0; e < level.n_edges; ++e) {
        const Vtr::Tag tag = level.edge_tags[e];
        if (!tag.in_cell() || tag.rule() != Vtr::Rule::Solid) continue;
        // Around an inner edge there are as many cells as faces; an oct whose diagonal ends here is two tets, not one.
        const auto locals = level.edge_octs.Locals(e);
        const auto cut = [](Sdc::Local i) { return i < Sdc::Oct::kDiagonalEdges; };
        Count(result.links, level.edge_faces.Count(e) + std::count_if(locals.begin(), locals.end(), cut));
    }
    if (level.n_octs > 0) Count(result.links, 4, level.n_octs);
    return result;
}

}  // namespace SolidSubdiv::Geometry
