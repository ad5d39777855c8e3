// SPDX-License-Identifier: Apache-2.0
// Regular blocks of the octet truss (the BCC complex) as plain arrays, for the validators and the tests.
#pragma once

#include <array>
#include <vector>

namespace SolidSubdiv::Validation {

/// A point of the lattice Z^3, or the difference of two. Multiples of 1/2^level are written as integers times 2^level.
using LatticePoint = std::array<int, 3>;

/// u1..u4. They sum to 0; any three of them span Z^3.
inline constexpr std::array<LatticePoint, 4> kDirections = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, -1, -1}}};

/// The fourteen neighbours of a vertex lie along A edges (+-u_k, eight; six tets around each) and B edges (u_i + u_j,
/// six; four tets around each).
enum class EdgeKind { A, B, None };
EdgeKind ClassifyEdge(const LatticePoint& a, const LatticePoint& b);

/// Which of the B edges inside the block are hidden, that is: the major diagonal of an octahedron made of the four tets
/// around it. No choice changes the tetrahedral view, so the box-spline scheme gives the same points for all of them.
enum class TrussCells {
    Tets,               ///< none: six tets per unit cube
    ParallelDiagonals,  ///< all of one direction: the octet truss. Half octahedra at two sides of the block stay tets.
    RefinedOnce,  ///< what splitting the block of half the size made of tets gives: one octahedron per tet, four tets
                  ///< at its corners
};

struct TrussBlock {
    LatticePoint size{};                   ///< unit cubes along each axis; vertices at 0..size
    std::vector<LatticePoint> vertices;    ///< x fastest, then y, then z
    std::vector<std::array<int, 4>> tets;  ///< positive, ordered so that v0v1 and v2v3 are the two B edges
    std::vector<std::array<int, 6>> octs;  ///< (v0 v1 | v2 v3 | v4 v5) positive, v0v1 the major diagonal, of kind B

    /// Number of the vertex at p. @pre 0 <= p <= size
    int VertexAt(const LatticePoint& p) const;
    /// Whether a lattice point lies in the block.
    bool Contains(const LatticePoint& p) const;
};

/// @param size at least 1 along each axis; all even for RefinedOnce.
/// @param diagonal_axis for ParallelDiagonals: the diagonals are (1,1,1) - e_axis, axis 0, 1 or 2.
/// @throws std::invalid_argument if a size or the axis is not as said.
TrussBlock MakeTrussBlock(const LatticePoint& size, TrussCells cells, int diagonal_axis = 2);

/// The tetrahedral view: the tets, then each octahedron cut into four tets around its major diagonal, all ordered as in
/// TrussBlock.
std::vector<std::array<int, 4>> TetrahedralView(const TrussBlock& block);

/// Six times the signed volume of the tet.
int SixVolumes(const LatticePoint& v0, const LatticePoint& v1, const LatticePoint& v2, const LatticePoint& v3);

/// Where the lattice becomes the body-centred cubic one: u1..u4 go to (1,1,1), (1,-1,-1), (-1,1,-1), (-1,-1,1). Keeps
/// orientation.
std::array<double, 3> BccPosition(const std::array<double, 3>& p);

}  // namespace SolidSubdiv::Validation
