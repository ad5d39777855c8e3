// SPDX-License-Identifier: Apache-2.0
// Rows of edges of surfaces that look no further than the two faces.
#pragma once

#include <solidsubdiv/sdc/masks.h>
#include <solidsubdiv/vtr/level.h>

namespace SolidSubdiv::Far::Internal {

/// Fills the row of a new point on an edge of the surface rule and returns its length.
template <class Surface, class Real>
int FillSurfaceEdge(const Vtr::Level& level, const Surface& surface, Index e, Index* indices, Real* weights) {
    const Sdc::EdgePairWeights w = surface.Edge();
    int n = 0;
    for (Index end : level.EdgeVertices(e)) {
        indices[n] = end;
        weights[n++] = static_cast<Real>(w.end);
    }
    const auto faces = level.edge_faces[e];
    for (Index f : faces) {
        if (faces.size() > 2 && !level.face_tags[f].is_boundary()) continue;  // two: they are the surface's
        indices[n] = level.ThirdVertex(f, e);
        weights[n++] = static_cast<Real>(w.opposite);
    }
    return n;
}

}  // namespace SolidSubdiv::Far::Internal
