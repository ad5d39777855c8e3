// SPDX-License-Identifier: Apache-2.0
// Tets and octs of negative volume: found, and turned, refused or left.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include <solidsubdiv/sdc/types.h>

namespace SolidSubdiv::Geometry {

enum class OrientationPolicy {
    Repair,  ///< turn the cell: a tet by swapping v2 and v3, an oct v4 and v5; all pairs stay
    Keep,    ///< leave it
    Refuse   ///< InvalidInput
};

/// Which cells are not positive.
struct OrientationReport {
    std::vector<Index> inverted_tets;  ///< as they came
    std::vector<Index> inverted_octs;
    std::vector<Index> flat_tets;  ///< of no volume, up to rounding of the coordinates: no sign to repair, always left
    std::vector<Index> flat_octs;

    Offset n_inverted() const { return static_cast<Offset>(inverted_tets.size() + inverted_octs.size()); }
    Offset n_flat() const { return static_cast<Offset>(flat_tets.size() + flat_octs.size()); }
};

/// Finds inverted and flat cells. Tets are (n, 4), octs (n, 6), positions (vertices, 3). @pre indices are in range
OrientationReport FindInvertedCells(std::span<const Index> tets, std::span<const Index> octs,
                                    std::span<const double> positions);

/// FindInvertedCells, and does with inverted ones what the policy says. Because pairs stay, so do diagonals.
/// @throws InvalidInput with Refuse: names the first inverted cell and its volume, and their number
OrientationReport OrientCells(std::span<Index> tets, std::span<Index> octs, std::span<const double> positions,
                              OrientationPolicy policy);

/// The policy of a name on the command line (repair, keep, refuse). @throws InvalidInput
OrientationPolicy OrientationPolicyOf(std::string_view name);

}  // namespace SolidSubdiv::Geometry
