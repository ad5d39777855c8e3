// SPDX-License-Identifier: Apache-2.0
// Butterfly and modified butterfly surfaces on OpenSubdiv's topology. An oracle: it shares no code with the library.
//
// OpenSubdiv has no butterfly, but its Loop refinement splits triangles in the same way. This program walks its
// relations and makes the weights itself.
#pragma once

#include <vector>

#include "sparse_rows.h"
#include "surface_levels.h"

namespace SolidSubdiv::Validation {

/// New points of edges; vertices always stay.
///
/// - A crease edge takes the 4-point rule (-w, 1/2 + w, 1/2 + w, -w) along its curve, w = curve_tension. A curve ends
/// in
///   a corner and wherever other than two creases meet; at one end (1/2 - 2w, 1/2 + 4w, -2w), between two ends the
///   mean.
/// - Stencils do not look across creases: a wing that lies beyond the crease ac, seen from b, is a + c - b.
/// - The fan of an edge at its end is the triangles that are reached without crossing a crease: a sector between two
///   creases, or a closed ring. It is a ring too if both ways round come to the same crease (a dart).
struct ButterflyRule {
    enum class Kind {
        Plain,    ///< 8 points whatever the valences: 1/2 ends, 2 tension opposite, -tension wings
        Modified  ///< 10 points between regular ends (ring of 6, sector of 3), else masks of extraordinary ends
    };
    Kind kind = Kind::Modified;
    double tension =
        0;  ///< Plain: weight of the wings; Modified: of the two far points, where all ten points are there
    double curve_tension = 1.0 / 16;
    /// Whether a sector of three triangles is regular where curves end, too. If not it has its mask there, and slopes
    /// at such corners stay bounded (docs/butterfly-boundaries.md).
    bool has_regular_corners = true;

    static ButterflyRule Plain(double tension = 1.0 / 16) { return {Kind::Plain, tension}; }
    static ButterflyRule Modified(double tension = 0) { return {Kind::Modified, tension}; }
};

struct ButterflyRefinement {
    /// Levels 0 to max_level, in the form of the Loop oracle: its comparisons take them as they are.
    std::vector<SurfaceLevel> levels;
    /// steps[l]: the vertices of level l + 1 over those of level l.
    std::vector<SparseRows> steps;
};

/// Composite rows come with levels 1 to max_row_level. Vertices are numbered as OpenSubdiv does: match them by the
/// children of vertices and edges.
/// @param surface whose tags are infinitely sharp; edges with other than two triangles are creases without being named
/// @throws std::runtime_error if OpenSubdiv refuses the surface, or a tag is of another sharpness or names what is not
/// there
ButterflyRefinement RefineByButterflyOracle(const ControlSurface& surface, const ButterflyRule& rule, int max_level,
                                            int max_row_level = 0);

}  // namespace SolidSubdiv::Validation
