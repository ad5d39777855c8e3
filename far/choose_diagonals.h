// SPDX-License-Identifier: Apache-2.0
// Chooses which diagonal the octahedron inside each tet gets (and which of its three an input octahedron has).
//
// A tet's choice is a pair of opposite edges, its B edges. Where two cells choose the same edge of their common face
// the refined mesh is the regular lattice across that face ("matched") and the box-spline scheme is smooth there.
// Source: rules.md section 1; chang2002boxspline, 4.2.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <solidsubdiv/far/topology_descriptor.h>

namespace SolidSubdiv::Far {

enum class DiagonalPolicy {
    Matched,   ///< as many matched faces as a deterministic search finds; topology alone
    Shortest,  ///< the shortest diagonal of each cell; needs positions
    First,     ///< as the cells are ordered
    Given      ///< as the caller says, cell by cell
};

struct DiagonalChoice {
    std::vector<Index> tets;              ///< (n, 4): the cells reordered so that the choice is their first pair
    std::vector<Index> octs;              ///< (n, 6)
    std::vector<std::uint8_t> diagonals;  ///< tets, then octs: the pair 0, 1 or 2 in the caller's order (see below)
    Offset n_inner_faces = 0;             ///< faces between two cells
    Offset n_matched_faces = 0;           ///< those that are matched

    /// Share of matched faces among inner ones, in [0, 1]; 1 if there are none.
    double MatchedShare() const {
        return n_inner_faces == 0 ? 1.0 : static_cast<double>(n_matched_faces) / static_cast<double>(n_inner_faces);
    }
};

/// Pairs of a tet: 0: 01|23, 1: 02|13, 2: 03|12; of an oct: its first, second, third pair of opposite vertices.
/// Reordering keeps orientation. `positions`, (n_vertices, 3), for Shortest; lengths within 1e-9 relative tie, to the
/// lowest pair. `given`, tets then octs, for Given.
/// @throws InvalidInput where cells are unusable (see Validate), or positions or given do not fit
DiagonalChoice ChooseDiagonals(const TopologyDescriptor& descriptor, DiagonalPolicy policy,
                               std::span<const double> positions = {}, std::span<const std::uint8_t> given = {});

/// The policy of a name on the command line (matched, shortest, first, given). @throws InvalidInput
DiagonalPolicy DiagonalPolicyOf(std::string_view name);

}  // namespace SolidSubdiv::Far
