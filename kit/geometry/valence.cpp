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

bool IsInside(Vtr::Tag tag) { return tag.in_cell() && tag.rule() == Vtr::Rule::Solid; }

/// What a split adds to edges and faces: n_diagonals(vertex) neighbours of a vertex inside, n_cut(edge) cells around an
/// edge inside.
template <class AnyLevel, class Diagonals, class Cut>
ValenceHistograms Measure(const AnyLevel& level, Diagonals&& n_diagonals, Cut&& n_cut) {
    assert(level.is_full);
    ValenceHistograms result;
    for (Index v = 0; v < level.n_vertices; ++v) {
        const auto edges = level.vertex_edges[v];
        const Offset n_edges = static_cast<Offset>(edges.size());
        Count(result.vertex_edges, n_edges);
        const Vtr::Tag tag = level.vertex_tags[v];
        if (IsInside(tag)) {
            Count(result.solid_adjacent, n_edges + n_diagonals(v));
        } else if (tag.in_face()) {
            const auto on_surface = [&](Index e) {
                return level.edge_tags[e].in_face() && level.edge_tags[e].rule() != Vtr::Rule::Solid;
            };
            Count(result.surface_edges, std::count_if(edges.begin(), edges.end(), on_surface));
        }
    }
    for (Index e = 0; e < level.n_edges; ++e) {
        // Around an inner edge there are as many cells as faces.
        if (IsInside(level.edge_tags[e])) Count(result.links, level.edge_faces.Count(e) + n_cut(e));
    }
    return result;
}

Offset CountBelow(std::span<const Sdc::Local> locals, int limit) {
    return std::count_if(locals.begin(), locals.end(), [&](Sdc::Local i) { return i < limit; });
}

}  // namespace

ValenceHistograms MeasureValences(const Vtr::Level& level) {
    // Vertices 0 and 1 of an oct are the ends of its major diagonal; where that ends on an edge, the oct is two tets
    // there.
    ValenceHistograms result = Measure(
        level, [&](Index v) { return CountBelow(level.vertex_octs.Locals(v), 2); },
        [&](Index e) { return CountBelow(level.edge_octs.Locals(e), Sdc::Oct::kDiagonalEdges); });
    if (level.n_octs > 0) Count(result.links, 4, level.n_octs);
    return result;
}

ValenceHistograms MeasureValences(const Vtr::PolyhedralLevel& level) {
    const auto none = [](Index) { return Offset{0}; };
    return Measure(level, none, none);
}

}  // namespace SolidSubdiv::Geometry
