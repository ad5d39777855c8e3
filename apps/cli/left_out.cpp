// SPDX-License-Identifier: Apache-2.0
// Surface faces that are not written, and their vertices.
#include <solidsubdiv/apps/cli/left_out.h>

#include <algorithm>

#include <solidsubdiv/kit/geometry/compact_surface.h>

namespace SolidSubdiv::Cli {

namespace {

/// Which vertices of level 0 are ends of edges with one face.
std::vector<bool> FindBorder(const Far::TopologyRefiner& refiner) {
    const Vtr::EdgeGraph base = refiner.graph(0);
    std::vector<bool> is_on_border(static_cast<std::size_t>(base.n_vertices), false);
    for (Index e = 0; e < base.n_edges; ++e) {
        if (base.edge_faces.Count(e) != 1) continue;
        for (Index v : base.EdgeVertices(e)) is_on_border[v] = true;
    }
    return is_on_border;
}

std::span<const Index> VerticesOfBoundaryFace(const Far::TopologyRefiner& refiner, Index place) {
    if (refiner.is_polyhedral()) return refiner.polyhedral_level(0).BoundaryVertices(place);
    return refiner.level(0).BoundaryVertices(place);
}

/// The arrays of vertices of a mesh's elements.
template <class AnyTopology, class Body>
void ForIndexArrays(AnyTopology& t, Body&& body) {
    for (auto* indices : {&t.tets, &t.octs, &t.hexes, &t.wedges, &t.pyramids, &t.polyhedron_vertices, &t.triangles,
                          &t.quads, &t.polygon_vertices, &t.edges, &t.vertices}) {
        body(*indices);
    }
}

}  // namespace

std::vector<Index> TakeLeftOut(std::vector<FacePart>& parts, const FacesLeftOut& left_out,
                               const Far::TopologyRefiner& refiner) {
    std::vector<bool> is_on_border;
    if (left_out.border) is_on_border = FindBorder(refiner);
    std::vector<Index> places;
    std::erase_if(parts, [&](FacePart part) {
        const auto v = VerticesOfBoundaryFace(refiner, part.place);
        const bool is_left_out =
            std::binary_search(left_out.holes.begin(), left_out.holes.end(), part.row) ||
            (left_out.border && std::any_of(v.begin(), v.end(), [&](Index i) { return is_on_border[i]; }));
        if (is_left_out) places.push_back(part.place);
        return is_left_out;
    });
    return places;
}

std::vector<Index> VerticesInUse(const Io::Topology& topology, std::span<const Index> boundary_corners) {
    std::vector<bool> stays(static_cast<std::size_t>(topology.n_vertices), true);
    for (Index v : boundary_corners) stays[v] = false;
    ForIndexArrays(topology, [&](const std::vector<Index>& indices) {
        for (Index v : indices) stays[v] = true;
    });
    std::vector<Index> kept;
    for (Index v = 0; v < topology.n_vertices; ++v) {
        if (stays[v]) kept.push_back(v);
    }
    return kept;
}

std::vector<Index> NewNumbers(const std::vector<Index>& kept, Index n_vertices) {
    std::vector<Index> numbers(static_cast<std::size_t>(n_vertices), kNoIndex);
    for (std::size_t i = 0; i < kept.size(); ++i) numbers[kept[i]] = static_cast<Index>(i);
    return numbers;
}

void KeepVertices(Io::Mesh& mesh, const std::vector<Index>& kept) {
    const std::vector<Index> numbers = NewNumbers(kept, mesh.topology.n_vertices);
    ForIndexArrays(mesh.topology, [&](std::vector<Index>& indices) {
        for (Index& v : indices) v = numbers[v];
    });
    mesh.topology.n_vertices = static_cast<Index>(kept.size());
    mesh.positions = Geometry::GatherRows(mesh.positions, 3, kept);
    for (Io::Attribute& a : mesh.point_data) a.values = Geometry::GatherRows(a.values, a.width, kept);
}

}  // namespace SolidSubdiv::Cli
