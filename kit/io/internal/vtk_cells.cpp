// SPDX-License-Identifier: Apache-2.0
// VTK's numbered cell types <-> elements.
#include <solidsubdiv/kit/io/internal/vtk_cells.h>

#include <algorithm>
#include <array>
#include <string>

#include <solidsubdiv/kit/io/internal/octahedra.h>
#include <solidsubdiv/kit/io/internal/text.h>

namespace SolidSubdiv::Io::Internal {

namespace {

enum VtkType : std::int64_t {
    kEmpty = 0,
    kVertex = 1,
    kPolyVertex = 2,
    kLine = 3,
    kPolyLine = 4,
    kTriangle = 5,
    kTriangleStrip = 6,
    kPolygon = 7,
    kPixel = 8,
    kQuad = 9,
    kTetra = 10,
    kVoxel = 11,
    kHexahedron = 12,
    kWedge = 13,
    kPyramid = 14
};

std::string UnknownTypeName(std::int64_t type) {
    if (type == 15) return "a pentagonal prism";
    if (type == 16) return "a hexagonal prism";
    if (type >= 21 && type <= 37) return "a cell of second order";
    if (type == 41) return "a convex point set";
    if (type >= 68 && type <= 74) return "a Lagrange cell of higher order";
    if (type >= 75 && type <= 81) return "a Bezier cell of higher order";
    return "a cell of an unknown type";
}

struct FixedCell {
    std::int64_t type;
    ElementKind kind;
    std::array<std::size_t, 8> order;
};

constexpr std::array<FixedCell, 10> kFixedCells = {{{kVertex, ElementKind::Vertex, {0}},
                                                    {kLine, ElementKind::Edge, {0, 1}},
                                                    {kTriangle, ElementKind::Triangle, {0, 1, 2}},
                                                    {kPixel, ElementKind::Quad, {0, 1, 3, 2}},
                                                    {kQuad, ElementKind::Quad, {0, 1, 2, 3}},
                                                    {kTetra, ElementKind::Tet, {0, 1, 2, 3}},
                                                    {kVoxel, ElementKind::Hex, {0, 1, 3, 2, 4, 5, 7, 6}},
                                                    {kHexahedron, ElementKind::Hex, {0, 1, 2, 3, 4, 5, 6, 7}},
                                                    {kWedge, ElementKind::Wedge, {0, 1, 2, 3, 4, 5}},
                                                    {kPyramid, ElementKind::Pyramid, {0, 1, 2, 3, 4}}}};

std::uint8_t VtkTypeOf(ElementKind kind) {
    switch (kind) {
        case ElementKind::Tet:
            return kTetra;
        case ElementKind::Oct:
        case ElementKind::Polyhedron:
            return kVtkPolyhedron;
        case ElementKind::Hex:
            return kHexahedron;
        case ElementKind::Wedge:
            return kWedge;
        case ElementKind::Pyramid:
            return kPyramid;
        case ElementKind::Triangle:
            return kTriangle;
        case ElementKind::Quad:
            return kQuad;
        case ElementKind::Polygon:
            return kPolygon;
        case ElementKind::Edge:
            return kLine;
        case ElementKind::Vertex:
            break;
    }
    return kVertex;
}

}  // namespace

void AddVtkCell(MeshBuilder& builder, std::int64_t type, std::span<const std::int64_t> points,
                std::span<const std::int64_t> face_stream) {
    const Offset row = builder.NextRow();
    const auto add_fixed = [&](const FixedCell& cell) {
        const auto n = static_cast<std::size_t>(InfoOf(cell.kind).n_vertices);
        if (points.size() != n) {
            Fail(builder.file(), "cell " + std::to_string(row) + " is a " + std::string(InfoOf(cell.kind).name) +
                                     " with " + Counted(static_cast<Offset>(points.size()), "vertex", "vertices") +
                                     "; it needs " + std::to_string(n));
        }
        std::array<std::int64_t, 8> vertices;
        for (std::size_t i = 0; i < n; ++i) vertices[i] = points[cell.order[i]];
        builder.AddElement(cell.kind, {vertices.data(), n});
    };
    for (const FixedCell& cell : kFixedCells) {
        if (cell.type == type) return add_fixed(cell);
    }
    switch (type) {
        case kEmpty:
            return;
        case kPolygon:
            return builder.AddElement(ElementKind::Polygon, points);
        case kVtkPolyhedron:
            return builder.AddPolyhedron(points, face_stream);
        case kPolyVertex:
            for (const std::int64_t& v : points) builder.AddElement(ElementKind::Vertex, {&v, 1});
            return;
        case kPolyLine:
            for (std::size_t i = 1; i < points.size(); ++i)
                builder.AddElement(ElementKind::Edge, points.subspan(i - 1, 2));
            return;
        case kTriangleStrip:
            for (std::size_t i = 2; i < points.size(); ++i) {
                const std::size_t turn = i % 2;  // every other triangle of a strip is the other way round
                const std::array triangle = {points[i - 2 + turn], points[i - 1 - turn], points[i]};
                builder.AddElement(ElementKind::Triangle, triangle);
            }
            return;
        default:
            break;
    }
    Fail(builder.file(), "cell " + std::to_string(row) + " is " + UnknownTypeName(type) + " (VTK type " +
                             std::to_string(type) + "), which can't be used; convert it to linear cells");
}

VtkCells MakeVtkCells(const Topology& topology) {
    VtkCells cells;
    const auto n = static_cast<std::size_t>(topology.n_elements());
    cells.types.reserve(n);
    cells.ends.reserve(n);
    const bool with_polyhedra = topology.n_octs() + topology.n_polyhedra() > 0;

    std::vector<Index> listed;
    ForEachElement(topology, [&](ElementKind kind, Offset element) {
        cells.types.push_back(VtkTypeOf(kind));
        const std::size_t stream_begin = cells.face_streams.size();
        if (kind == ElementKind::Polyhedron) {
            const auto first_face = topology.polyhedron_offsets[static_cast<std::size_t>(element)];
            const auto last_face = topology.polyhedron_offsets[static_cast<std::size_t>(element) + 1];
            cells.face_streams.push_back(static_cast<Index>(last_face - first_face));
            listed.clear();
            for (auto face = static_cast<std::size_t>(first_face); face < static_cast<std::size_t>(last_face); ++face) {
                const Index* first = topology.polyhedron_vertices.data() + topology.polyhedron_face_offsets[face];
                const Index* last = topology.polyhedron_vertices.data() + topology.polyhedron_face_offsets[face + 1];
                cells.face_streams.push_back(static_cast<Index>(last - first));
                cells.face_streams.insert(cells.face_streams.end(), first, last);
                listed.insert(listed.end(), first, last);
            }
            std::sort(listed.begin(), listed.end());
            listed.erase(std::unique(listed.begin(), listed.end()), listed.end());
            cells.connectivity.insert(cells.connectivity.end(), listed.begin(), listed.end());
        } else {
            const std::span<const Index> vertices = ElementVertices(topology, kind, element);
            cells.connectivity.insert(cells.connectivity.end(), vertices.begin(), vertices.end());
            if (kind == ElementKind::Oct) {
                cells.face_streams.push_back(8);
                for (const std::array<Index, 3>& face : OctahedronFaces(vertices)) {
                    cells.face_streams.insert(cells.face_streams.end(), {3, face[0], face[1], face[2]});
                }
            }
        }
        cells.ends.push_back(static_cast<Offset>(cells.connectivity.size()));
        if (!with_polyhedra) return;
        const bool has_faces = cells.face_streams.size() > stream_begin;
        cells.stream_ends.push_back(has_faces ? static_cast<Offset>(cells.face_streams.size()) : Offset{-1});
    });
    return cells;
}

}  // namespace SolidSubdiv::Io::Internal
