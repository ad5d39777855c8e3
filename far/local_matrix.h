// SPDX-License-Identifier: Apache-2.0
// The subdivision matrix around one vertex: how the vertex and its neighbours move in one refinement.
//
// Neighbours are the vertices that the scheme's rules at the vertex see. The new neighbours are the points on the same
// edges (and in the same octahedra), so the matrix is square, the same at every level, and its powers say where the
// vertex goes: the left eigenvector of the eigenvalue 1 is the limit mask, the other eigenvalues tell smoothness.
#pragma once

#include <optional>
#include <vector>

#include <solidsubdiv/far/topology_refiner.h>
#include <solidsubdiv/sdc/schemes.h>

namespace SolidSubdiv::Far {

struct LocalMatrix {
    std::vector<Index> ring;      ///< the vertex itself, then its neighbours (n numbers)
    std::vector<double> weights;  ///< (n, n), row-major: row i makes ring[i]'s successor from the ring

    int size() const { return static_cast<int>(ring.size()); }
};

/// @pre level.is_full. Nothing where the rules reach beyond the ring (a complex that meets itself).
std::optional<LocalMatrix> MakeLocalMatrix(const Level& level, const Sdc::Scheme& scheme, Index vertex);

/// The same of a vertex among polyhedra, where all that is around the vertex moves together: from the first split on,
/// the vertex and the points on its edges, in its faces and in its cells. `ring` counts points of the vertex's star,
/// split alone: 0 is the vertex. Creases are left out.
std::optional<LocalMatrix> MakeLocalMatrix(const Vtr::PolyhedralLevel& level, const Sdc::Scheme& scheme, Index vertex);

/// The limit of the vertex as weights of the ring: the row of ring[0] in high powers of the matrix. Empty if they do
/// not settle (the vertex has no limit).
std::vector<double> LimitMaskOf(const LocalMatrix& matrix);

}  // namespace SolidSubdiv::Far
