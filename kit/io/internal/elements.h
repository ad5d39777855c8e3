// SPDX-License-Identifier: Apache-2.0
// The kinds of elements a mesh holds, in the order of its cell data, and their names.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

#include <solidsubdiv/kit/io/mesh.h>

namespace SolidSubdiv::Io::Internal {

enum class ElementKind : std::uint8_t {
    Tet,
    Oct,
    Hex,
    Wedge,
    Pyramid,
    Polyhedron,
    Triangle,
    Quad,
    Polygon,
    Edge,
    Vertex
};

inline constexpr int kElementKinds = 11;

struct ElementKindInfo {
    std::string_view name;
    std::string_view plural;
    int n_vertices;  ///< 0: any number
};

inline constexpr std::array<ElementKindInfo, kElementKinds> kElementInfo = {{{"tetrahedron", "tetrahedra", 4},
                                                                             {"octahedron", "octahedra", 6},
                                                                             {"hexahedron", "hexahedra", 8},
                                                                             {"wedge", "wedges", 6},
                                                                             {"pyramid", "pyramids", 5},
                                                                             {"polyhedron", "polyhedra", 0},
                                                                             {"triangle", "triangles", 3},
                                                                             {"quadrilateral", "quadrilaterals", 4},
                                                                             {"polygon", "polygons", 0},
                                                                             {"edge", "edges", 2},
                                                                             {"single vertex", "single vertices", 1}}};

inline const ElementKindInfo& InfoOf(ElementKind kind) { return kElementInfo[static_cast<std::size_t>(kind)]; }

/// Whether cell data `sharpness` makes it a crease or corner.
inline bool CanBeSharp(ElementKind kind) { return kind == ElementKind::Edge || kind == ElementKind::Vertex; }

inline constexpr std::array<ElementKind, kElementKinds> kAllElementKinds = {
    ElementKind::Tet,     ElementKind::Oct,        ElementKind::Hex,      ElementKind::Wedge,
    ElementKind::Pyramid, ElementKind::Polyhedron, ElementKind::Triangle, ElementKind::Quad,
    ElementKind::Polygon, ElementKind::Edge,       ElementKind::Vertex};

/// The vertices of all elements of a kind, one after another (polyhedra: face by face).
template <class AnyTopology>
auto& VerticesOf(AnyTopology& topology, ElementKind kind) {
    switch (kind) {
        case ElementKind::Tet:
            return topology.tets;
        case ElementKind::Oct:
            return topology.octs;
        case ElementKind::Hex:
            return topology.hexes;
        case ElementKind::Wedge:
            return topology.wedges;
        case ElementKind::Pyramid:
            return topology.pyramids;
        case ElementKind::Polyhedron:
            return topology.polyhedron_vertices;
        case ElementKind::Triangle:
            return topology.triangles;
        case ElementKind::Quad:
            return topology.quads;
        case ElementKind::Polygon:
            return topology.polygon_vertices;
        case ElementKind::Edge:
            return topology.edges;
        case ElementKind::Vertex:
            break;
    }
    return topology.vertices;
}

inline Offset CountOf(const Topology& topology, ElementKind kind) {
    if (kind == ElementKind::Polyhedron) return topology.n_polyhedra();
    if (kind == ElementKind::Polygon) return topology.n_polygons();
    return static_cast<Offset>(VerticesOf(topology, kind).size()) / InfoOf(kind).n_vertices;
}

/// The vertices of one element that is no polyhedron.
inline std::span<const Index> ElementVertices(const Topology& topology, ElementKind kind, Offset element) {
    const std::span<const Index> all = VerticesOf(topology, kind);
    if (kind == ElementKind::Polygon) {
        const auto first = static_cast<std::size_t>(topology.polygon_offsets[static_cast<std::size_t>(element)]);
        const auto last = static_cast<std::size_t>(topology.polygon_offsets[static_cast<std::size_t>(element) + 1]);
        return all.subspan(first, last - first);
    }
    const auto n = static_cast<std::size_t>(InfoOf(kind).n_vertices);
    return all.subspan(static_cast<std::size_t>(element) * n, n);
}

/// Calls visit(kind, element's number within its kind) for every element, in the order of the cell data.
template <class Visit>
void ForEachElement(const Topology& topology, Visit&& visit) {
    for (const ElementKind kind : kAllElementKinds) {
        const Offset n = CountOf(topology, kind);
        for (Offset i = 0; i < n; ++i) visit(kind, i);
    }
}

}  // namespace SolidSubdiv::Io::Internal
