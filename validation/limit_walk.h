// SPDX-License-Identifier: Apache-2.0
// Limits at a place the plain way: refine by the library's stencils, keep what is around the place, start anew from
// that, a dozen times. Uses none of the library's limits; where a place goes in a split is told from its vertices'
// numbers (docs/concepts.md) and the coordinates of far/place.h alone.
#pragma once

#include <array>
#include <vector>

#include <solidsubdiv/far/creases.h>
#include <solidsubdiv/far/place.h>
#include <solidsubdiv/far/stencil_table.h>
#include <solidsubdiv/far/topology_refiner.h>

namespace SolidSubdiv::Validation {

/// A complex that owns its arrays. Other cells than tets and octahedra stand by their faces; hexahedra too, if at all.
struct OwnedMesh {
    Index n_vertices = 0;
    std::vector<Index> tets, octs, hexes, triangles, edges;
    std::vector<Offset> polyhedron_offsets{0}, polyhedron_face_offsets{0}, polygon_offsets{0};
    std::vector<Index> polyhedron_vertices, polygon_vertices;
    Far::Creases creases;

    /// Sees this; valid while it lives.
    Far::TopologyDescriptor Descriptor() const;
};

using Vector3 = std::array<double, 3>;

/// What a place's point and its derivatives by the place's coordinates are, as in Far::LimitStencilTable: u, v(, w),
/// uu, uv, ...
struct LimitEstimate {
    Vector3 point{};
    std::vector<Vector3> slopes, curvatures;
};

/// Estimates from one level after another, for each of the schemes. The last ones are the best: points by fits of third
/// order in the size of elements, first derivatives of second, second ones of first order where the limit is smooth.
/// @param positions (n_vertices, 3)
/// @param schemes of the mesh's split, with one creasing method
using Estimates = std::vector<std::vector<LimitEstimate>>;
Estimates WalkToPlace(const OwnedMesh& mesh, Sdc::Split split, const std::vector<Sdc::Scheme>& schemes,
                      const std::vector<double>& positions, const Far::Place& place, Far::Elements elements,
                      int n_levels);

}  // namespace SolidSubdiv::Validation
