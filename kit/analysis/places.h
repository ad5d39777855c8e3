// SPDX-License-Identifier: Apache-2.0
// The places whose spectra tell what a scheme is like, as stars of their own: the regular lattice, edges with any
// number of cells, faces between tets, vertices of surfaces with any number of faces.
#pragma once

#include <solidsubdiv/kit/analysis/star.h>
#include <solidsubdiv/sdc/schemes.h>

namespace SolidSubdiv::Analysis {

/// Whether a scheme's main rules are for solids: then its regular lattice is one of cells.
bool IsSolid(const Sdc::Scheme& scheme);

/// An inner vertex of the regular lattice: of the octet truss or of cubes, on surfaces of valence 6 or 4.
Star RegularStar(const Sdc::Scheme& scheme);

/// A vertex on an inner edge of n cells, regular everywhere else: hexahedra, or tets and octahedra as a split of n tets
/// around an edge leaves them. Their diagonals match: parallel to the edge, but for even n from 6 on, where no diagonal
/// starts from the edge's middle (n = 4 and n = 6 are regular then).
/// @throws InvalidInput for n < 3 and for a scheme of surfaces
Star EdgeStar(const Sdc::Scheme& scheme, int n);

/// A vertex inside the face of two tets, which choose the same of its edges for their B edges or not.
/// @throws InvalidInput for a scheme that does not refine tets
Star FaceStar(const Sdc::Scheme& scheme, bool is_matched);

/// A vertex inside a surface with n faces around it (triangles, or quadrilaterals where the scheme takes no others), or
/// one on the border of a surface with n faces. Schemes of solids: their boundary.
/// @throws InvalidInput for n < 3 inside, n < 1 on a border
Star SurfaceStar(const Sdc::Scheme& scheme, int n, bool is_on_border);

}  // namespace SolidSubdiv::Analysis
