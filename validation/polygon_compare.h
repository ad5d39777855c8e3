// SPDX-License-Identifier: Apache-2.0
// Holds a refiner of polyhedra and its tables to OpenSubdiv's refinement of a surface of the mesh, as surface_compare.h
// does for triangles.
#pragma once

#include "surface_compare.h"

namespace SolidSubdiv::Validation {

struct PolygonSurfaceOfMesh {
    PolygonSurface surface;
    SurfaceOfMesh start;  ///< its vertices in the mesh; without triangles
};

/// The faces with vertices of their own. @param positions (n_vertices, 3) of the mesh; tags of its vertices
PolygonSurfaceOfMesh TakePolygons(const std::vector<Polygon>& faces, std::span<const double> positions,
                                  const SurfaceTags& tags = {});

/// Refines, makes the tables, compares faces, positions and rows.
/// @param mesh its creases and corners are set from our_tags
Findings CompareWithCatmark(const Far::TopologyDescriptor& mesh, const Sdc::Scheme& scheme,
                            const PolygonSurfaceOfMesh& surface, std::span<const double> positions,
                            const SurfaceTags& our_tags, const ComparedLevels& levels);

}  // namespace SolidSubdiv::Validation
