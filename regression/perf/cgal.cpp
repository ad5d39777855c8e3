// SPDX-License-Identifier: Apache-2.0
// The only source that includes CGAL: slow to compile.
#include "perf/surface_peers.h"

#if SOLIDSUBDIV_HAS_CGAL

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/subdivision_method_3.h>

#include <memory>

namespace SolidSubdiv::Perf {

namespace {

using Point = CGAL::Simple_cartesian<float>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Vertex = Mesh::Vertex_index;

struct State {
    TestShapes::Shape shape;
    int n_levels;
    Mesh mesh{};
};

/// A mesh with room for its last level: subdividing grows no array.
void MakeMesh(const TestShapes::Shape& shape, int n_levels, Mesh& mesh) {
    const std::size_t n_faces = (shape.triangles.size() / 3) << (2 * n_levels), n_edges = 3 * n_faces / 2;
    const auto size = [](std::size_t n) { return static_cast<Mesh::size_type>(n); };
    mesh.reserve(size(n_edges - n_faces + 1), size(n_edges), size(n_faces));
    for (std::size_t i = 0; i < shape.positions.size(); i += 3) {
        const double* const p = &shape.positions[i];
        mesh.add_vertex(Point(static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])));
    }
    const auto vertex = [&](std::size_t i) { return Vertex(static_cast<Mesh::size_type>(shape.triangles[i])); };
    for (std::size_t i = 0; i < shape.triangles.size(); i += 3) {
        mesh.add_face(vertex(i), vertex(i + 1), vertex(i + 2));
    }
}

}  // namespace

SurfacePeers CgalPeers(const TestShapes::Shape& shape, int n_levels) {
    const auto state = std::make_shared<State>(State{shape, n_levels});
    SurfacePeers peers;
    peers.loop.push_back({.name = "CGAL, float",
                          .run =
                              [state] {
                                  MakeMesh(state->shape, state->n_levels, state->mesh);
                                  CGAL::Subdivision_method_3::Loop_subdivision(
                                      state->mesh, CGAL::parameters::number_of_iterations(state->n_levels));
                              },
                          .run_apart = {},
                          .sums =
                              [state] {
                                  PointSums sums;
                                  for (const Vertex v : state->mesh.vertices()) {
                                      const Point& p = state->mesh.point(v);
                                      sums.Add(static_cast<double>(p.x()), static_cast<double>(p.y()),
                                               static_cast<double>(p.z()));
                                  }
                                  sums.n_faces = static_cast<double>(state->mesh.number_of_faces());
                                  return sums;
                              },
                          .clear = [state] { state->mesh = Mesh(); }});
    return peers;
}

}  // namespace SolidSubdiv::Perf

#else

namespace SolidSubdiv::Perf {
SurfacePeers CgalPeers(const TestShapes::Shape&, int) { return {.missing = "CGAL was not there."}; }
}  // namespace SolidSubdiv::Perf

#endif
