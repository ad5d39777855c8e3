// SPDX-License-Identifier: Apache-2.0
// Rows of surface vertices and edges that sharpness changes: blends of the rules of their level and of the next.
#pragma once

#include <solidsubdiv/far/internal/row_entries.h>
#include <solidsubdiv/far/internal/sharpness.h>

namespace SolidSubdiv::Far::Internal {

template <class Surface, class Curve, class Real>
void FillSharpVertex(const Level& level, const Sharpness& sharpness, const SharpRules& sharp, const Surface& surface,
                     const Curve& curve, Index v, RowEntries<Real>& row) {
    const Vtr::EdgeGraph graph(level);
    const auto other_end = [&](Index e) {
        const auto ends = level.EdgeVertices(e);
        return ends[0] + ends[1] - v;
    };
    if constexpr (Surface::kVerticesStay || Curve::kVerticesStay) {
        row.Add(v, 1);
    } else {
        for (const SharpRules::Part& part : sharp.VertexParts(v)) {
            if (part.share == 0) continue;
            switch (part.rule) {
                case Sdc::SharpRule::Corner:
                    row.Add(v, part.share);
                    break;
                case Sdc::SharpRule::Crease: {
                    const Sdc::RingWeights w = curve.Vertex();
                    row.Add(v, part.share * w.self);
                    for (Index e : part.crease) row.Add(other_end(e), part.share * w.neighbor);
                    break;
                }
                default: {
                    int n = 0;
                    ForSurfaceEdges(graph, sharpness, v, [&](Index, float) { ++n; });
                    const Sdc::RingWeights w = surface.Vertex(n);
                    row.Add(v, part.share * w.self);
                    ForSurfaceEdges(graph, sharpness, v,
                                    [&](Index e, float) { row.Add(other_end(e), part.share * w.neighbor); });
                }
            }
        }
    }
}

template <class Surface, class Curve, class Real>
void FillSharpEdge(const Level& level, const SharpRules& sharp, const Surface& surface, const Curve& curve, Index e,
                   RowEntries<Real>& row) {
    const double crease = sharp.CreaseShare(e), smooth = 1 - crease;
    const Sdc::EdgePairWeights w = surface.Edge();
    for (Index end : level.EdgeVertices(e)) row.Add(end, crease * curve.EdgeEnd() + smooth * w.end);
    if (smooth * w.opposite == 0) return;
    for (Index f : level.edge_faces[e]) {
        if (level.face_tags[f].is_boundary()) row.Add(level.ThirdVertex(f, e), smooth * w.opposite);
    }
}

}  // namespace SolidSubdiv::Far::Internal
