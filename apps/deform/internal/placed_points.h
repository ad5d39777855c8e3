// SPDX-License-Identifier: Apache-2.0
// Where the points of a model are in a refined lattice, and which of those outside move: what an embedding is made of.
#pragma once

#include <span>
#include <vector>

#include <solidsubdiv/apps/deform/embedding.h>
#include <solidsubdiv/far/topology_refiner.h>

namespace SolidSubdiv::Deform::Internal {

/// A lattice refined to its last level, where it is.
struct RefinedLattice {
    const Far::TopologyRefiner& refiner;
    std::span<const double> positions;  ///< of the last level
    double mean_edge;                   ///< length, of the control lattice's edges

    int level() const { return refiner.max_level(); }
};

/// A point in a cell. Cells are hexahedra of the last level; or tets: t, or n_tets + 4 o + quadrant of an octahedron o.
struct InCell {
    Index cell;
    Index point;
    std::array<double, 3> at;
};

/// Corners of such a tet.
std::array<Index, 4> TetCorners(const Far::Level& level, Index tet);

/// All points that move stand in one of the first three.
struct PlacedPoints {
    std::vector<InCell> in_hexes, in_tets;  ///< ascending by cell, then by point
    std::vector<Index> row_points;          ///< ascending
    Far::StencilRows<double> rows;          ///< of row_points over the vertices of the last level
    std::vector<OutsidePoint> outside;      ///< without their constants
};

/// @throws InvalidInput as Geometry::Locator and LimitLocator, Cancelled
PlacedPoints Place(const RefinedLattice& lattice, std::span<const double> points, const EmbedOptions& options);

}  // namespace SolidSubdiv::Deform::Internal
