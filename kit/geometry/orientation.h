// SPDX-License-Identifier: Apache-2.0
// Cells of negative volume: found, and turned, refused or left.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include <solidsubdiv/sdc/types.h>

namespace SolidSubdiv::Geometry {

enum class OrientationPolicy {
    /// Turn the cell: a tet by swapping v2 and v3, an oct v4 and v5 (all pairs stay), a hexahedron and a wedge by
    /// exchanging bottom and top, a pyramid by swapping v1 and v3, a polyhedron by going round its faces the other way.
    Repair,
    Keep,   ///< leave it
    Refuse  ///< InvalidInput
};

/// Which cells are not positive.
struct OrientationReport {
    std::vector<Index> inverted_tets;  ///< as they came
    std::vector<Index> inverted_octs;
    std::vector<Index> flat_tets;  ///< of no volume, up to rounding of the coordinates: no sign to repair, always left
    std::vector<Index> flat_octs;

    Offset n_inverted_others = 0, n_flat_others = 0;  ///< hexahedra, wedges, pyramids and polyhedra

    Offset n_inverted() const {
        return static_cast<Offset>(inverted_tets.size() + inverted_octs.size()) + n_inverted_others;
    }
    Offset n_flat() const { return static_cast<Offset>(flat_tets.size() + flat_octs.size()) + n_flat_others; }
};

/// Cells other than tets and octs, as TopologyDescriptor has them.
struct OtherCells {
    std::span<Index> hexes{}, wedges{}, pyramids{};
    std::span<const Offset> polyhedron_offsets{}, polyhedron_face_offsets{};
    std::span<Index> polyhedron_vertices{};
};

/// Finds inverted and flat cells. Tets are (n, 4), octs (n, 6), positions (vertices, 3). @pre indices are in range
OrientationReport FindInvertedCells(std::span<const Index> tets, std::span<const Index> octs,
                                    std::span<const double> positions);

/// FindInvertedCells, and does with inverted ones what the policy says. Because pairs stay, so do diagonals.
/// @throws InvalidInput with Refuse: names the first inverted cell and its volume, and their number
OrientationReport OrientCells(std::span<Index> tets, std::span<Index> octs, std::span<const double> positions,
                              OrientationPolicy policy);

/// The same for other cells, by the volume that their faces enclose; adds their numbers to the report.
void OrientOtherCells(const OtherCells& cells, std::span<const double> positions, OrientationPolicy policy,
                      OrientationReport& report);

/// The policy of a name on the command line (repair, keep, refuse). @throws InvalidInput
OrientationPolicy OrientationPolicyOf(std::string_view name);

}  // namespace SolidSubdiv::Geometry
