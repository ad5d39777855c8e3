// SPDX-License-Identifier: Apache-2.0
// The limit's cells at some level of a lattice: which are folded, and corners of those as a problem's fine corners.
#pragma once

#include <array>
#include <set>
#include <span>
#include <vector>

#include <solidsubdiv/apps/fit/control_mesh.h>
#include <solidsubdiv/far/stencil_table.h>
#include <solidsubdiv/far/topology_refiner.h>
#include <solidsubdiv/sdc/schemes.h>

namespace SolidSubdiv::Fit::Internal {

/// Tables are made once; positions come and go.
class RefinedCells {
  public:
    /// @throws InvalidInput where the scheme can't refine the mesh
    RefinedCells(const ControlMesh& mesh, const Sdc::Scheme& scheme, int level);

    Offset n_cells() const;
    /// Numbers of cells of the level that are folded: hexahedra; or tets, then octahedra.
    std::vector<Index> FindFolded(std::span<const double> control) const;

    struct Corners {
        Far::StencilRows<double> places;  ///< over control points
        std::vector<std::array<Index, 4>> corners;
    };
    /// Of these cells.
    Corners CornersOf(const std::set<Index>& cells) const;

  private:
    Far::StencilRows<double> PlacesOf(const std::vector<Index>& vertices) const;

    Sdc::Scheme scheme_;
    int level_;
    Far::TopologyRefiner refiner_;
    Far::StencilTable levels_;         ///< from level to level
    Far::StencilRows<double> limits_;  ///< of the last level's vertices, over themselves
};

}  // namespace SolidSubdiv::Fit::Internal
