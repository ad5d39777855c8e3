// SPDX-License-Identifier: Apache-2.0
// Rings of elements, by passes over all of them.
#include "limit_cut.h"

#include <algorithm>
#include <span>

namespace SolidSubdiv::Validation {

namespace {

enum class Kind { Tet, Oct, Hex, Polyhedron, Face, Edge };
struct Element {
    Kind kind;
    Index number;
    std::span<const Index> vertices;  ///< of polyhedra those of all faces
};

void AddLooseParts(const Vtr::Level& l, std::vector<Element>& elements) {
    std::vector<bool> in_cell(static_cast<std::size_t>(l.n_faces)), in_face(static_cast<std::size_t>(l.n_edges));
    for (const auto* faces : {&l.tet_faces, &l.oct_faces}) {
        for (Index f : *faces) in_cell[static_cast<std::size_t>(f)] = true;
    }
    for (Index e : l.face_edges) in_face[static_cast<std::size_t>(e)] = true;
    for (Index b = 0; b < l.n_boundary_faces; ++b) {
        if (!in_cell[static_cast<std::size_t>(l.boundary_faces[b])]) {
            elements.push_back({Kind::Face, b, l.BoundaryVertices(b)});
        }
    }
    for (Index e = 0; e < l.n_edges; ++e) {
        if (!in_face[static_cast<std::size_t>(e)]) elements.push_back({Kind::Edge, e, l.EdgeVertices(e)});
    }
}

void AddLooseParts(const Vtr::PolyhedralLevel& l, std::vector<Element>& elements) {
    std::vector<bool> in_face(static_cast<std::size_t>(l.n_edges));
    for (Index e : l.face_edges) in_face[static_cast<std::size_t>(e)] = true;
    for (Index b = 0; b < l.n_boundary_faces; ++b) {
        if (l.NCells(l.boundary_faces[b]) == 0) elements.push_back({Kind::Face, b, l.BoundaryVertices(b)});
    }
    for (Index e = 0; e < l.n_edges; ++e) {
        if (!in_face[static_cast<std::size_t>(e)]) elements.push_back({Kind::Edge, e, l.EdgeVertices(e)});
    }
}

template <class AnyLevel>
void AddFaces(const AnyLevel& l, bool is_mixed, std::vector<Element>& elements) {
    if (is_mixed) return AddLooseParts(l, elements);
    if (l.n_cells() > 0) return;
    for (Index b = 0; b < l.n_boundary_faces; ++b) elements.push_back({Kind::Face, b, l.BoundaryVertices(b)});
}

std::vector<Element> ElementsOf(const Far::TopologyRefiner& refiner, int level, bool is_mixed) {
    std::vector<Element> elements;
    if (!refiner.is_polyhedral()) {
        const Vtr::Level& l = refiner.level(level);
        for (Index t = 0; t < l.n_tets; ++t) elements.push_back({Kind::Tet, t, l.TetVertices(t)});
        for (Index o = 0; o < l.n_octs; ++o) elements.push_back({Kind::Oct, o, l.OctVertices(o)});
        AddFaces(l, is_mixed, elements);
        return elements;
    }
    const Vtr::PolyhedralLevel& l = refiner.polyhedral_level(level);
    for (Index h = 0; h < l.n_hexes; ++h) {
        elements.push_back({Kind::Hex, h, {l.hex_vertices.data() + 8 * static_cast<std::size_t>(h), 8}});
    }
    const Vtr::Polyhedra& p = l.polyhedra;
    for (Index c = 0; c < p.size(); ++c) {
        const Offset begin = p.face_vertex_offsets[p.offsets[c]], end = p.face_vertex_offsets[p.offsets[c + 1]];
        elements.push_back(
            {Kind::Polyhedron, c, {p.face_vertices.data() + begin, static_cast<std::size_t>(end - begin)}});
    }
    AddFaces(l, is_mixed, elements);
    return elements;
}

void Append(std::vector<Index>& list, std::span<const Index> vertices, const std::vector<Index>& number) {
    for (Index v : vertices) list.push_back(number[static_cast<std::size_t>(v)]);
}

void AppendElement(const Far::TopologyRefiner& refiner, int level, const Element& e, const std::vector<Index>& number,
                   OwnedMesh& mesh) {
    switch (e.kind) {
        case Kind::Tet:
            return Append(mesh.tets, e.vertices, number);
        case Kind::Oct:
            return Append(mesh.octs, e.vertices, number);
        case Kind::Hex:
            return Append(mesh.hexes, e.vertices, number);
        case Kind::Edge:
            return Append(mesh.edges, e.vertices, number);
        case Kind::Face:
            if (!refiner.is_polyhedral()) return Append(mesh.triangles, e.vertices, number);
            Append(mesh.polygon_vertices, e.vertices, number);
            mesh.polygon_offsets.push_back(static_cast<Offset>(mesh.polygon_vertices.size()));
            return;
        case Kind::Polyhedron: {
            const Vtr::Polyhedra& p = refiner.polyhedral_level(level).polyhedra;
            const Offset start = mesh.polyhedron_face_offsets.back() - p.face_vertex_offsets[p.offsets[e.number]];
            for (Offset f = p.offsets[e.number]; f < p.offsets[e.number + 1]; ++f) {
                mesh.polyhedron_face_offsets.push_back(start + p.face_vertex_offsets[f + 1]);
            }
            Append(mesh.polyhedron_vertices, e.vertices, number);
            mesh.polyhedron_offsets.push_back(static_cast<Offset>(mesh.polyhedron_face_offsets.size()) - 1);
        }
    }
}

}  // namespace

CutOut CutAround(const Far::TopologyRefiner& refiner, int level, const std::vector<Index>& core, int n_rings,
                 bool is_mixed, const Far::Creases& creases) {
    const std::vector<Element> elements = ElementsOf(refiner, level, is_mixed);
    std::vector<bool> is_kept(elements.size()), is_reached(static_cast<std::size_t>(refiner.n_vertices(level)));
    std::vector<bool> is_complete;
    const auto keep = [&](auto&& wanted) {
        std::vector<bool> next = is_reached;
        for (std::size_t i = 0; i < elements.size(); ++i) {
            if (!is_kept[i] && !wanted(elements[i].vertices)) continue;
            is_kept[i] = true;
            for (Index v : elements[i].vertices) next[static_cast<std::size_t>(v)] = true;
        }
        is_complete = std::exchange(is_reached, next);
    };
    keep([&](std::span<const Index> vertices) {
        return std::all_of(core.begin(), core.end(),
                           [&](Index v) { return std::find(vertices.begin(), vertices.end(), v) != vertices.end(); });
    });
    for (int ring = 0; ring < n_rings; ++ring) {
        keep([&](std::span<const Index> vertices) {
            return std::any_of(vertices.begin(), vertices.end(),
                               [&](Index v) { return is_reached[static_cast<std::size_t>(v)]; });
        });
    }

    CutOut cut;
    cut.number.assign(is_reached.size(), kNoIndex);
    for (std::size_t v = 0; v < is_reached.size(); ++v) {
        if (!is_reached[v]) continue;
        cut.number[v] = cut.mesh.n_vertices++;
        cut.vertices.push_back(static_cast<Index>(v));
        cut.is_complete.push_back(is_complete[v]);
    }
    for (std::size_t i = 0; i < elements.size(); ++i) {
        if (is_kept[i]) AppendElement(refiner, level, elements[i], cut.number, cut.mesh);
    }
    const auto number = [&](Index v) { return cut.number[static_cast<std::size_t>(v)]; };
    Far::Creases& kept = cut.mesh.creases;
    for (std::size_t i = 0; i < creases.edge_sharpness.size(); ++i) {
        const Index a = number(creases.edges[2 * i]), b = number(creases.edges[2 * i + 1]);
        if (a == kNoIndex || b == kNoIndex) continue;
        kept.edges.insert(kept.edges.end(), {a, b});
        kept.edge_sharpness.push_back(creases.edge_sharpness[i]);
    }
    for (std::size_t i = 0; i < creases.vertices.size(); ++i) {
        if (number(creases.vertices[i]) == kNoIndex) continue;
        kept.vertices.push_back(number(creases.vertices[i]));
        kept.vertex_sharpness.push_back(creases.vertex_sharpness[i]);
    }
    return cut;
}

}  // namespace SolidSubdiv::Validation
