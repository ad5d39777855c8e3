// SPDX-License-Identifier: Apache-2.0
// Laws of free-form deformation that hold in any lattice, and how far a control point may reach.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include <solidsubdiv/apps/deform/control_lattice.h>
#include <solidsubdiv/apps/deform/deformer.h>

#include "findings.h"

namespace SolidSubdiv::Validation {

/// A control lattice and points in it. What the view is of must live as long.
struct FfdShape {
    std::string name;
    Far::TopologyDescriptor lattice;
    std::vector<double> control;  ///< (n_control_points, 3)
    std::vector<double> points;   ///< (n, 3)
    /// Of lattices of hexahedra only: vertices of each, and the one that each point was found in. Otherwise empty.
    std::vector<std::vector<int>> cells{};
    std::vector<int> homes{};
};

/// n points drawn within the lattice's cells.
FfdShape DrawFfdShape(std::string name, const Far::TopologyDescriptor& lattice, std::vector<double> control, int n,
                      std::uint32_t seed);

/// Points in a lattice whose cells are boxes along the axes. @throws InvalidInput naming a point that no box holds
FfdShape InBoxes(std::string name, const Deform::ControlLattice& lattice, std::vector<double> points);

/// An affine map of points, (n, 3), far from orthogonal.
std::vector<double> MapAffinely(std::span<const double> points);

/// Errors: distances over `size`.
void ComparePoints(std::span<const double> expected, std::span<const double> found, double size,
                   const std::string& what, Findings& findings);

/// Faults: tables or deformed points that differ by a bit.
void CompareBits(const Deform::Embedding& a, const Deform::Embedding& b, std::span<const double> control,
                 Findings& findings);

/// A control point has moved: points before, after an update, and after all were deformed; which the library says an
/// update wrote, and which it can touch.
struct FfdMove {
    Index control_point = 0;
    std::vector<double> before, updated, deformed;
    std::vector<Index> written, affected;
};
FfdMove MoveOne(const Deform::Embedding& embedding, std::span<const double> control, Index control_point);

/// Faults: an affected set other than that of the rows over the control points, points in it that an update leaves out,
/// others that change by a bit, updates that are not what deforming all gives, and, if `is_near` (Catmull-Clark solids
/// on hexahedra), affected points in cells that are not in N_p,3 of ono2002ffd.
/// @return of affected points, the most steps from the control point to a vertex of their cell
int CheckMove(const FfdShape& shape, const Far::StencilRows<double>& rows, const FfdMove& move, bool is_near,
              Findings& findings);

}  // namespace SolidSubdiv::Validation
