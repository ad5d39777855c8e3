// SPDX-License-Identifier: Apache-2.0
// The places whose spectra tell what a scheme is like: the regular lattice, and edges with any number of cells.
#pragma once

#include <solidsubdiv/far/local_matrix.h>
#include <solidsubdiv/sdc/schemes.h>

namespace SolidSubdiv::Analysis {

/// The local matrix of an inner vertex of the regular lattice: of the octet truss or of cubes, on surfaces of valence 6
/// or 4.
Far::LocalMatrix RegularLocalMatrix(const Sdc::Scheme& scheme);

/// The local matrix of a vertex on an inner edge of n cells, regular everywhere else: hexahedra, or tets and octahedra
/// as a split of n tets around an edge leaves them. Their diagonals match: parallel to the edge, but for even n from 6
/// on, where no diagonal starts from the edge's middle (n = 4 and n = 6 are regular then).
/// @pre n >= 3 @throws InvalidInput for a scheme of surfaces
Far::LocalMatrix EdgeLocalMatrix(const Sdc::Scheme& scheme, int n);

}  // namespace SolidSubdiv::Analysis
