// SPDX-License-Identifier: Apache-2.0
// The regular triangle lattice around one vertex that need not be regular, and the subdivision matrix there.
#pragma once

#include <array>
#include <vector>

#include "surface_levels.h"

namespace SolidSubdiv::Validation {

/// A place in a cone: p steps along the ray `sector` and q along the next one; on a ray q = 0, at the apex all are 0.
using ConePlace = std::array<int, 3>;

/// Sectors of the lattice around vertex 0, joined along rays. Open: a half disc of n triangles at the apex, on its
/// boundary; closed: a disc of n triangles, the apex inside.
struct Cone {
    int n_sectors = 0;
    bool is_closed = false;
    int n_rings = 0;
    std::vector<ConePlace> places;  ///< of the surface's vertices
    ControlSurface surface;         ///< in the plane z = 0, with rays of length n_rings at equal angles

    int n_rays() const { return n_sectors + (is_closed ? 0 : 1); }
    bool IsWithin(int vertex, int radius) const { return places[vertex][1] + places[vertex][2] <= radius; }
};

/// @pre n_sectors at least 1 (open) or 3 (closed)
Cone MakeCone(int n_sectors, bool is_closed, int n_rings);

/// Vertices of the next level by where they are in the finer lattice: place 2p, 2q for the child of place p, q.
/// @param control level 0 of a refinement of the cone, with its children
std::vector<ConePlace> PlacesOfChildren(const Cone& cone, const SurfaceLevel& control);

/// Rows of a step as the matrix that takes the vertices within the radius to those at the same places of the finer
/// lattice: (n, n), row-major, in the order of their numbers in the cone.
/// @param rows dense, one a vertex of the next level, over the vertices of the cone
/// @throws std::runtime_error if a row reaches beyond the radius
std::vector<double> SubdivisionMatrix(const Cone& cone, int radius, const std::vector<ConePlace>& places,
                                      const std::vector<std::vector<double>>& rows);

}  // namespace SolidSubdiv::Validation
