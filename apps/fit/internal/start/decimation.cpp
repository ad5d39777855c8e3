// SPDX-License-Identifier: Apache-2.0
// OpenMesh's decimater with a rule of ours for borders, and a few rounds of flips and smoothing after it.
#include <solidsubdiv/apps/fit/internal/start/decimation.h>

#include <algorithm>
#include <cstdlib>
#include <limits>

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/Utils/Property.hh>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModNormalFlippingT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>

namespace SolidSubdiv::Fit::Starting {

namespace {

struct Traits : OpenMesh::DefaultTraits {
    using Point = OpenMesh::Vec3d;
    using Normal = OpenMesh::Vec3d;
};
using Mesh = OpenMesh::TriMesh_ArrayKernelT<Traits>;
using Vertex = Mesh::VertexHandle;

/// Border vertices go along the border only, and as long as it does not turn by more than 45 degrees there: quadrics
/// of planes do not see it.
class ModBorder : public OpenMesh::Decimater::ModBaseT<Mesh> {
  public:
    explicit ModBorder(Mesh& mesh) : Base(mesh, true) {}
    DECIMATER_MODNAME(ModBorder)
    using Base = OpenMesh::Decimater::ModBaseT<Mesh>;

    float collapse_priority(const CollapseInfo& c) override {
        if (!Base::mesh().is_boundary(c.v0)) return LEGAL_COLLAPSE;
        if (!Base::mesh().is_boundary(Base::mesh().edge_handle(c.v0v1))) return ILLEGAL_COLLAPSE;
        for (const auto& h : Base::mesh().voh_range(c.v0)) {
            const Vertex other = Base::mesh().to_vertex_handle(h);
            if (other == c.v1 || !Base::mesh().is_boundary(Base::mesh().edge_handle(h))) continue;
            const auto before = (c.p0 - Base::mesh().point(other)).normalized();
            if ((before | (c.p1 - c.p0).normalized()) < std::sqrt(.5)) return ILLEGAL_COLLAPSE;
        }
        return LEGAL_COLLAPSE;
    }
};

Mesh MeshOf(std::span<const double> positions, std::span<const Index> triangles) {
    Mesh mesh;
    std::vector<Vertex> vertices;
    for (std::size_t i = 0; i < positions.size(); i += 3) {
        vertices.push_back(mesh.add_vertex({positions[i], positions[i + 1], positions[i + 2]}));
    }
    const auto at = [&](std::size_t i) { return vertices[static_cast<std::size_t>(triangles[i])]; };
    for (std::size_t t = 0; t < triangles.size(); t += 3) mesh.add_face(at(t), at(t + 1), at(t + 2));
    mesh.request_face_normals();
    mesh.update_face_normals();
    return mesh;
}

void Collapse(Mesh& mesh, std::size_t n_vertices) {
    OpenMesh::Decimater::DecimaterT<Mesh> decimater(mesh);
    OpenMesh::Decimater::ModQuadricT<Mesh>::Handle quadric;
    OpenMesh::Decimater::ModNormalFlippingT<Mesh>::Handle flipping;
    OpenMesh::Decimater::ModHandleT<ModBorder> border;
    decimater.add(quadric);
    decimater.add(flipping);
    decimater.add(border);
    decimater.module(quadric).unset_max_err();
    if (!decimater.initialize()) return;
    decimater.decimate_to(n_vertices);
    mesh.garbage_collection();
}

Mesh::Normal NormalOf(const Mesh& mesh, Vertex a, Vertex b, Vertex c) {
    return (mesh.point(b) - mesh.point(a)) % (mesh.point(c) - mesh.point(a));
}

/// Flips edges while valences get nearer to what is regular, and the two triangles are and stay nearly in a plane.
void FlipEdges(Mesh& mesh) {
    const double kNearlyFlat = std::cos(30 * 3.14159265358979323846 / 180);
    for (const auto& e : mesh.edges()) {
        if (mesh.is_boundary(e) || !mesh.is_flip_ok(e)) continue;
        const auto h = mesh.halfedge_handle(e, 0), o = mesh.halfedge_handle(e, 1);
        const Vertex a = mesh.from_vertex_handle(h), b = mesh.to_vertex_handle(h);
        const Vertex c = mesh.to_vertex_handle(mesh.next_halfedge_handle(h));
        const Vertex d = mesh.to_vertex_handle(mesh.next_halfedge_handle(o));
        const auto off = [&](Vertex v, int more) {
            const int n = static_cast<int>(mesh.valence(v)) + more - (mesh.is_boundary(v) ? 4 : 6);
            return n * n;
        };
        const int before = off(a, 0) + off(b, 0) + off(c, 0) + off(d, 0);
        if (off(a, -1) + off(b, -1) + off(c, 1) + off(d, 1) >= before) continue;
        const auto n = NormalOf(mesh, a, b, c).normalized();
        const auto is_along = [&](const Mesh::Normal& m) { return m.norm() > 0 && (m.normalized() | n) > kNearlyFlat; };
        if (!is_along(NormalOf(mesh, b, a, d)) || !is_along(NormalOf(mesh, c, d, b)) ||
            !is_along(NormalOf(mesh, d, c, a))) {
            continue;
        }
        mesh.flip(e);
    }
}

/// Where all triangles at it look nearly the same way: moving it there loses no edge of the shape.
bool IsSmooth(const Mesh& mesh, Vertex v, const Mesh::Normal& normal) {
    const double kNearlyFlat = std::cos(40 * 3.14159265358979323846 / 180);
    for (const auto& f : mesh.vf_range(v)) {
        if ((mesh.calc_face_normal(f) | normal) < kNearlyFlat) return false;
    }
    return true;
}

void EvenOut(Mesh& mesh, const std::function<std::vector<double>(std::span<const double>)>& nearest) {
    std::vector<Vertex> moved;
    std::vector<double> places;
    for (const auto& v : mesh.vertices()) {
        if (mesh.is_boundary(v)) continue;
        Mesh::Normal normal(0, 0, 0);
        Mesh::Point mean(0, 0, 0);
        for (const auto& f : mesh.vf_range(v)) normal += mesh.calc_face_normal(f);
        for (const auto& w : mesh.vv_range(v)) mean += mesh.point(w) / mesh.valence(v);
        if (!(normal.norm() > 0) || !IsSmooth(mesh, v, normal.normalized())) continue;
        normal.normalize();
        const Mesh::Point apart = mean - mesh.point(v),
                          place = mesh.point(v) + .5 * (apart - (apart | normal) * normal);
        moved.push_back(v);
        places.insert(places.end(), {place[0], place[1], place[2]});
    }
    places = nearest(places);
    for (std::size_t i = 0; i < moved.size(); ++i) {
        const Mesh::Point before = mesh.point(moved[i]);
        std::vector<Mesh::Normal> normals;
        for (const auto& f : mesh.vf_range(moved[i])) normals.push_back(mesh.calc_face_normal(f));
        mesh.set_point(moved[i], {places[3 * i], places[3 * i + 1], places[3 * i + 2]});
        // Back where a triangle turns: the nearest point may be on the other side of something thin.
        std::size_t k = 0;
        bool is_bad = false;
        for (const auto& f : mesh.vf_range(moved[i])) is_bad |= (mesh.calc_face_normal(f) | normals[k++]) < .5;
        if (is_bad) mesh.set_point(moved[i], before);
    }
}

}  // namespace

Decimated Decimate(std::span<const double> positions, std::span<const Index> triangles, std::size_t n_vertices,
                   const std::function<std::vector<double>(std::span<const double>)>& nearest) {
    Mesh mesh = MeshOf(positions, triangles);
    Collapse(mesh, n_vertices);
    constexpr int kRounds = 5;
    for (int round = 0; round < kRounds; ++round) {
        FlipEdges(mesh);
        EvenOut(mesh, nearest);
    }
    Decimated made;
    for (const auto& v : mesh.vertices()) {
        const auto& p = mesh.point(v);
        made.positions.insert(made.positions.end(), {p[0], p[1], p[2]});
    }
    for (const auto& f : mesh.faces()) {
        for (const auto& v : mesh.fv_range(f)) made.triangles.push_back(static_cast<Index>(v.idx()));
    }
    return made;
}

}  // namespace SolidSubdiv::Fit::Starting
