// SPDX-License-Identifier: Apache-2.0
// Calls OpenMesh and copies its answers out.
#include "open_mesh_oracle.h"

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/ModifiedButterFlyT.hh>
#include <stdexcept>
#include <string>

#include "split_levels_oracle.h"

namespace SolidSubdiv::Validation {

namespace {

struct DoubleTraits : OpenMesh::DefaultTraits {
    using Point = OpenMesh::Vec3d;
};
using TheirMesh = OpenMesh::TriMesh_ArrayKernelT<DoubleTraits>;

TheirMesh MakeMesh(const ControlSurface& surface) {
    TheirMesh mesh;
    for (std::size_t v = 0; v < surface.positions.size(); v += 3) {
        mesh.add_vertex({surface.positions[v], surface.positions[v + 1], surface.positions[v + 2]});
    }
    ::omerr().disable();  // it prints what it refuses
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
        const Triangle& corners = surface.triangles[t];
        const auto face = mesh.add_face(mesh.vertex_handle(static_cast<unsigned>(corners[0])),
                                        mesh.vertex_handle(static_cast<unsigned>(corners[1])),
                                        mesh.vertex_handle(static_cast<unsigned>(corners[2])));
        if (!face.is_valid()) throw std::runtime_error("OpenMesh refuses triangle " + std::to_string(t));
    }
    return mesh;
}

SurfaceLevel CopyLevel(const TheirMesh& mesh) {
    SurfaceLevel level;
    level.n_vertices = static_cast<int>(mesh.n_vertices());
    for (const auto vertex : mesh.vertices()) {
        const auto& point = mesh.point(vertex);
        level.positions.insert(level.positions.end(), {point[0], point[1], point[2]});
    }
    for (const auto face : mesh.faces()) {
        Triangle corners{};
        std::size_t i = 0;
        for (const auto vertex : mesh.fv_range(face)) corners.at(i++) = vertex.idx();
        level.triangles.push_back(corners);
    }
    return level;
}

}  // namespace

std::vector<SurfaceLevel> RefineByOpenMesh(const ControlSurface& surface, int max_level) {
    TheirMesh mesh = MakeMesh(surface);
    std::vector<SurfaceLevel> levels = {CopyLevel(mesh)};
    OpenMesh::Subdivider::Uniform::ModifiedButterflyT<TheirMesh, double> subdivider;
    for (int l = 1; l <= max_level; ++l) {
        if (!subdivider.attach(mesh) || !subdivider(1)) throw std::runtime_error("OpenMesh does not subdivide");
        subdivider.detach();
        levels.push_back(CopyLevel(mesh));
        FindChildren(levels[l - 1], levels[l]);
    }
    return levels;
}

}  // namespace SolidSubdiv::Validation
