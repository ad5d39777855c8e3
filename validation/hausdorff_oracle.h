// SPDX-License-Identifier: Apache-2.0
// One-sided Hausdorff distances by CGAL.
#pragma once

#include <cstdint>
#include <span>

namespace SolidSubdiv::Validation {

/// The largest distance of any point of surface `a` from surface `b`, to within `bound`. Positions (n, 3), triangles
/// (n, 3). @pre both are manifolds. @throws Unavailable where CGAL was not found
/// Source: bounded_error_Hausdorff_distance of CGAL's Polygon_mesh_processing.
double HausdorffDistance(std::span<const double> a, std::span<const std::int32_t> a_triangles,
                         std::span<const double> b, std::span<const std::int32_t> b_triangles, double bound);

}  // namespace SolidSubdiv::Validation
