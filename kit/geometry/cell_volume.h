// SPDX-License-Identifier: Apache-2.0
// Signed volumes of cells: positive for cells that are oriented as sdc/cells.h (tets, octs) or VTK (the others) say.
//
// Faces of more than three vertices are taken as fans around the mean of their vertices; for a quad that is the volume
// under its bilinear patch. So the volumes of the cells of a closed complex add up to that of its boundary.
#pragma once

#include <span>
#include <vector>

#include <solidsubdiv/far/topology_descriptor.h>

namespace SolidSubdiv::Geometry {

/// `positions` are (n, 3); vertices index its rows.
double TetVolume(std::span<const double> positions, std::span<const Index, 4> tet);
/// The same however the octahedron is cut.
double OctVolume(std::span<const double> positions, std::span<const Index, 6> oct);

/// Volumes of all cells: tets, octs, hexes, wedges, pyramids, polyhedra, in this order. @pre indices are in range
std::vector<double> CellVolumes(const Far::TopologyDescriptor& topology, std::span<const double> positions);

/// Below this, the sign of a cell's volume says nothing: rounding of its coordinates alone can make as much.
double VolumeRoundoff(std::span<const double> positions, std::span<const Index> cell);

}  // namespace SolidSubdiv::Geometry
