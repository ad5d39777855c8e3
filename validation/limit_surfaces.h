// SPDX-License-Identifier: Apache-2.0
// Holds limits of boundary faces, their derivatives and normals to OpenSubdiv's.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <solidsubdiv/far/limit_stencil_table.h>

#include "findings.h"
#include "limit_places.h"
#include "limit_surfaces_oracle.h"

namespace SolidSubdiv::Validation {

/// The boundary of a refiner's level 0 as OpenSubdiv takes it: face b is boundary face b, corner by corner.
struct BoundarySurface {
    BoundarySurface(const Far::TopologyRefiner& refiner, const std::vector<double>& positions, const SurfaceTags& tags);

    std::vector<Index> mesh_vertices;  ///< of the mesh, for each of the surface's
    bool is_triangular = false;
    ControlSurface triangles;  ///< one of the two
    PolygonSurface polygons;

    const std::vector<Polygon>& faces() const { return faces_; }
    SurfaceLimits LimitsAt(std::span<const SurfacePlace> places) const {
        return is_triangular ? LimitsByOpenSubdiv(triangles, places) : LimitsByOpenSubdiv(polygons, places);
    }
    VertexLimits LimitsOfVertices() const {
        return is_triangular ? VertexLimitsByOpenSubdiv(triangles) : VertexLimitsByOpenSubdiv(polygons);
    }

    /// Whether a face is a polygon, which has parts.
    bool HasParts(int face) const { return !is_triangular && faces_[static_cast<std::size_t>(face)].size() != 4; }
    Far::Place OurPlace(const SurfacePlace& place) const;
    std::vector<Far::Place> OurPlaces(std::span<const SurfacePlace> places) const;
    /// A place at each vertex, in one of its faces.
    std::vector<Far::Place> CornerPlaces() const;

  private:
    std::vector<Polygon> faces_;
};

/// Points and, in faces without parts, derivatives, where OpenSubdiv's patches are exact.
/// @param rows ours at the same places; size: of the shape
void CompareAtPlaces(const LimitRows& rows, const BoundarySurface& surface, std::span<const SurfacePlace> places,
                     const std::vector<double>& positions, Findings& findings);

/// Points of vertices, and directions of normals where there is a tangent plane.
/// @param corners rows at surface.CornerPlaces(), with tangents
void CompareAtVertices(const LimitRows& corners, const BoundarySurface& surface, const std::vector<double>& positions,
                       Findings& findings);

}  // namespace SolidSubdiv::Validation
