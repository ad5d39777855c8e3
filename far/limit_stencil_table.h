// SPDX-License-Identifier: Apache-2.0
// Limit positions of vertices as rows over the vertices of the same level.
//
//     refiner.RefineUniform({.max_level = 2, .full_topology_in_last_level = true});
//     auto limit = Far::LimitStencilTable::Create(refiner, Sdc::BoxSpline{}, {.level = 2});
//
// Inside solids of tets and octahedra: 2/5, 1/20, 1/30 where the lattice is regular (chang2002boxspline; rules.md
// section 2), elsewhere the left eigenvector of the local matrix. Boundary: Loop's limit; creases (1, 4, 1)/6; corners
// stay. Solids and surfaces of other cells: tensor products of (1, 4, 1)/6 where the mesh is regular, elsewhere the
// left eigenvector of the matrix one level on. Places between vertices and derivatives are not here yet.
#pragma once

#include <vector>

#include <solidsubdiv/far/stencil_table.h>

namespace SolidSubdiv::Far {

struct LimitStencilTableOptions {
    int level = -1;  ///< whose vertices; -1: the last. It must have full topology.
};

class LimitStencilTable {
  public:
    /// @throws InvalidInput if the level has no full topology or the scheme can't refine the mesh
    static LimitStencilTable Create(const TopologyRefiner& refiner, const Sdc::Scheme& scheme,
                                    const LimitStencilTableOptions& options = {});

    /// Row v: the limit of vertex v. Columns: the vertices of the level.
    const StencilRows<double>& rows() const { return rows_; }

    /// Vertices without a row: powers of their local matrix do not settle, or creases there have yet to fade (refine as
    /// often as the sharpest of them says).
    const std::vector<Index>& without_limit() const { return without_limit_; }

  private:
    StencilRows<double> rows_;
    std::vector<Index> without_limit_;
};

}  // namespace SolidSubdiv::Far
