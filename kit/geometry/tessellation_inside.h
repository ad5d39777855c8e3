// SPDX-License-Identifier: Apache-2.0
// The inside of a solid's limit as tets that fit together: the cells of a refined level, cut, their vertices at their
// limits.
//
//     refiner.RefineUniform({.max_level = 2, .full_topology_in_last_level = true});
//     const auto inside = Geometry::TessellateInside(refiner, Sdc::BoxSpline{}, 2);
//     Osd::Evaluator eval(inside.table, Osd::Backend::Best());
//     eval.Evaluate(positions, vertices);  // again and again as control points move
//
// Cells are cut without new vertices. Octahedra become the four tets around their major diagonal. In every other cell
// the vertex of the lowest number is joined to the faces that do not have it, and faces of more than three corners are
// cut from their vertex of the lowest number: cells that share a face cut it alike. Hexahedra of a refined level become
// the six tets around the diagonal from their control cell's corner.
#pragma once

#include <vector>

#include <solidsubdiv/far/stencil_table.h>
#include <solidsubdiv/sdc/progress.h>
#include <solidsubdiv/sdc/schemes.h>

namespace SolidSubdiv::Geometry {

/// (n, 4) vertices of the level, the tets of each cell together, in the cells' order; positive where cells are (convex
/// ones; a folded cell makes negative tets too).
std::vector<Index> CutIntoTets(const Far::TopologyRefiner& refiner, int level);

struct InnerTessellation {
    std::vector<Index> tets;  ///< (n, 4)
    /// From the control vertices through the levels to the limits of the last one's vertices.
    Far::StencilTable table;
    std::vector<Index> without_limit;  ///< vertices of the level that the scheme gives no limit: they stay
};

/// @throws InvalidInput if the level has no full topology or the scheme can't refine the mesh
InnerTessellation TessellateInside(const Far::TopologyRefiner& refiner, const Sdc::Scheme& scheme, int level,
                                   const Progress& progress = {});

}  // namespace SolidSubdiv::Geometry
