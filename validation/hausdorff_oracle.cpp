// SPDX-License-Identifier: Apache-2.0
// The only source of the validators that includes CGAL (GPL, slow to compile).
#include "hausdorff_oracle.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/distance.h>
#include <CGAL/Surface_mesh.h>

namespace SolidSubdiv::Validation {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

Mesh MakeMesh(std::span<const double> positions, std::span<const std::int32_t> triangles) {
    Mesh mesh;
    for (std::size_t i = 0; i < positions.size(); i += 3) {
        mesh.add_vertex({positions[i], positions[i + 1], positions[i + 2]});
    }
    const auto vertex = [&](std::size_t i) { return Mesh::Vertex_index(static_cast<Mesh::size_type>(triangles[i])); };
    for (std::size_t t = 0; t < triangles.size(); t += 3) mesh.add_face(vertex(t), vertex(t + 1), vertex(t + 2));
    return mesh;
}

}  // namespace

double HausdorffDistance(std::span<const double> a, std::span<const std::int32_t> a_triangles,
                         std::span<const double> b, std::span<const std::int32_t> b_triangles, double bound) {
    return CGAL::Polygon_mesh_processing::bounded_error_Hausdorff_distance<CGAL::Sequential_tag>(
        MakeMesh(a, a_triangles), MakeMesh(b, b_triangles), bound);
}

}  // namespace SolidSubdiv::Validation
