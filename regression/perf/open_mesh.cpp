// SPDX-License-Identifier: Apache-2.0
// The only source that includes OpenMesh.
#include "perf/surface_peers.h"

#if SOLIDSUBDIV_HAS_OPENMESH

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/LoopT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/ModifiedButterFlyT.hh>
#include <memory>

namespace SolidSubdiv::Perf {

namespace {

using Mesh = OpenMesh::TriMesh_ArrayKernelT<>;  // floats

struct State {
    TestShapes::Shape shape;
    int n_levels;
    Mesh mesh{};
};

/// A mesh with room for its last level: subdividing grows no array.
Mesh MakeMesh(const TestShapes::Shape& shape, int n_levels) {
    Mesh mesh;
    const std::size_t n_faces = (shape.triangles.size() / 3) << (2 * n_levels), n_edges = 3 * n_faces / 2;
    mesh.reserve(n_edges - n_faces + 1, n_edges, n_faces);
    for (std::size_t i = 0; i < shape.positions.size(); i += 3) {
        const double* const p = &shape.positions[i];
        mesh.add_vertex({static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])});
    }
    for (std::size_t i = 0; i < shape.triangles.size(); i += 3) {
        mesh.add_face(Mesh::VertexHandle(shape.triangles[i]), Mesh::VertexHandle(shape.triangles[i + 1]),
                      Mesh::VertexHandle(shape.triangles[i + 2]));
    }
    return mesh;
}

template <class Subdivider>
SurfacePipeline MakePipeline(const std::shared_ptr<State>& state) {
    return {.name = "OpenMesh, float",
            .run =
                [state] {
                    state->mesh = MakeMesh(state->shape, state->n_levels);
                    Subdivider subdivider;
                    subdivider(state->mesh, static_cast<std::size_t>(state->n_levels));
                },
            .run_apart = {},
            .sums =
                [state] {
                    PointSums sums;
                    for (const auto v : state->mesh.vertices()) {
                        const auto& p = state->mesh.point(v);
                        sums.Add(p[0], p[1], p[2]);
                    }
                    sums.n_faces = static_cast<double>(state->mesh.n_faces());
                    return sums;
                },
            .clear = [state] { state->mesh = Mesh(); }};
}

}  // namespace

SurfacePeers OpenMeshPeers(const TestShapes::Shape& shape, int n_levels) {
    const auto state = std::make_shared<State>(State{shape, n_levels});
    using namespace OpenMesh::Subdivider::Uniform;
    return {.loop = {MakePipeline<LoopT<Mesh, float>>(state)},
            .butterfly = {MakePipeline<ModifiedButterflyT<Mesh, float>>(state)}};
}

}  // namespace SolidSubdiv::Perf

#else

namespace SolidSubdiv::Perf {
SurfacePeers OpenMeshPeers(const TestShapes::Shape&, int) { return {.missing = "OpenMesh was not there."}; }
}  // namespace SolidSubdiv::Perf

#endif
