// SPDX-License-Identifier: Apache-2.0
// Faces that one kept cell has to itself, found by sorting; see cut.h.
#include <solidsubdiv/kit/picture/cut.h>
#include <solidsubdiv/sdc/cells.h>
#include <solidsubdiv/sdc/errors.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <string>

namespace SolidSubdiv::Picture {
namespace {

using LocalFace = std::array<int, 4>;  // the fourth is -1 in triangles; counterclockwise from outside

/// A kind of cell in VTK's vertex order (hexes, wedges, pyramids) or that of sdc/cells.h.
struct Shape {
    CellKind kind;
    std::size_t n_vertices;
    std::vector<LocalFace> faces;
};

template <class Cell>
Shape FromReferenceCell(CellKind kind) {
    Shape shape{kind, Cell::kVertices, {}};
    for (const auto& f : Cell::faces) shape.faces.push_back({f[0], f[1], f[2], -1});
    return shape;
}

const std::array<Shape, 5>& Shapes() {
    static const std::array<Shape, 5> shapes{
        FromReferenceCell<Sdc::Tet>(CellKind::Tet), FromReferenceCell<Sdc::Oct>(CellKind::Oct),
        Shape{CellKind::Hex, 8, {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}},
        Shape{CellKind::Wedge, 6, {{0, 1, 2, -1}, {3, 5, 4, -1}, {0, 3, 4, 1}, {1, 4, 5, 2}, {2, 5, 3, 0}}},
        Shape{CellKind::Pyramid, 5, {{0, 3, 2, 1}, {0, 1, 4, -1}, {1, 2, 4, -1}, {2, 3, 4, -1}, {3, 0, 4, -1}}}};
    return shapes;
}

std::span<const Index> CellsOf(const Io::Topology& t, CellKind kind) {
    switch (kind) {
        case CellKind::Tet:
            return t.tets;
        case CellKind::Oct:
            return t.octs;
        case CellKind::Hex:
            return t.hexes;
        case CellKind::Wedge:
            return t.wedges;
        case CellKind::Pyramid:
            return t.pyramids;
    }
    return {};
}

struct Face {
    std::array<Index, 4> key;       // sorted; the first is kNoIndex in triangles
    std::array<Index, 4> vertices;  // in order; the last is kNoIndex in triangles
    CellKind kind;
    bool kept;
};

void AppendEdges(std::span<const Index> vertices, std::vector<std::array<Index, 2>>& edges) {
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const Index a = vertices[i], b = vertices[(i + 1) % vertices.size()];
        edges.push_back({std::min(a, b), std::max(a, b)});
    }
}

std::vector<Index> Unique(std::vector<std::array<Index, 2>> edges) {
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    std::vector<Index> flat;
    flat.reserve(2 * edges.size());
    for (const auto& e : edges) flat.insert(flat.end(), e.begin(), e.end());
    return flat;
}

/// Keeps the cells whose centroid c has dot(normal, c - point) <= 0; all of them if the normal is zero.
SolidFaces Visible(const Io::Mesh& mesh, const Plane& plane) {
    if (mesh.topology.n_polyhedra() > 0) {
        throw InvalidInput("picture: the mesh has " + std::to_string(mesh.topology.n_polyhedra()) +
                           " general polyhedra; only tets, octs, hexes, wedges and pyramids can be shown");
    }
    std::vector<Face> faces;
    for (const Shape& shape : Shapes()) {
        const std::span<const Index> cells = CellsOf(mesh.topology, shape.kind);
        for (std::size_t c = 0; c + shape.n_vertices <= cells.size(); c += shape.n_vertices) {
            const std::span<const Index> cell = cells.subspan(c, shape.n_vertices);
            double side = 0;
            for (Index v : cell) {
                for (std::size_t k = 0; k < 3; ++k) {
                    side += plane.normal[k] * (mesh.positions[3 * static_cast<std::size_t>(v) + k] - plane.point[k]);
                }
            }
            for (const LocalFace& local : shape.faces) {
                Face face{{}, {}, shape.kind, side <= 0};
                for (std::size_t i = 0; i < 4; ++i) {
                    face.vertices[i] = local[i] < 0 ? kNoIndex : cell[static_cast<std::size_t>(local[i])];
                }
                face.key = face.vertices;
                std::sort(face.key.begin(), face.key.end());
                faces.push_back(face);
            }
        }
    }
    std::sort(faces.begin(), faces.end(),
              [](const Face& a, const Face& b) { return a.key != b.key ? a.key < b.key : a.vertices < b.vertices; });

    SolidFaces out;
    std::vector<std::array<Index, 2>> edges;
    for (std::size_t i = 0; i < faces.size();) {
        std::size_t end = i + 1, n_kept = faces[i].kept ? 1 : 0, kept = i;
        for (; end < faces.size() && faces[end].key == faces[i].key; ++end) {
            if (faces[end].kept) ++n_kept, kept = end;
        }
        if (n_kept == 1) {
            const Face& face = faces[kept];
            const bool opened = end - i > 1;
            const std::size_t n = face.vertices[3] == kNoIndex ? 3 : 4;
            for (std::size_t t = 2; t < n; ++t) {
                out.triangles.insert(out.triangles.end(), {face.vertices[0], face.vertices[t - 1], face.vertices[t]});
                out.kinds.push_back(face.kind);
                out.opened.push_back(opened ? 1 : 0);
            }
            if (opened) AppendEdges(std::span(face.vertices).first(n), edges);
        }
        i = end;
    }
    out.edges = Unique(std::move(edges));
    return out;
}

Color ColorOf(CellKind kind) {
    switch (kind) {
        case CellKind::Tet:
            return Palette::kTetrahedron;
        case CellKind::Oct:
            return Palette::kOctahedron;
        default:
            return Palette::kOtherCell;
    }
}

}  // namespace

std::vector<Color> SolidFaces::ColorsByKind() const {
    std::vector<Color> colors;
    for (CellKind kind : kinds) colors.push_back(ColorOf(kind));
    return colors;
}

std::vector<Color> SolidFaces::ColorsByKind(Color skin) const {
    std::vector<Color> colors = ColorsByKind();
    for (std::size_t i = 0; i < colors.size(); ++i) {
        if (!opened[i]) colors[i] = skin;
    }
    return colors;
}

SolidFaces SolidBoundary(const Io::Mesh& mesh) { return Visible(mesh, {.point = {}, .normal = {}}); }

SolidFaces CutSolid(const Io::Mesh& mesh, const Plane& plane) {
    const double length = std::hypot(plane.normal[0], plane.normal[1], plane.normal[2]);
    if (!(length > 0 && std::isfinite(length)))
        throw InvalidInput("picture: a cut plane's normal must be finite and not zero");
    return Visible(mesh, plane);
}

std::vector<Index> ElementEdges(const Io::Topology& topology) {
    std::vector<std::array<Index, 2>> edges;
    for (const Shape& shape : Shapes()) {
        const std::span<const Index> cells = CellsOf(topology, shape.kind);
        for (std::size_t c = 0; c + shape.n_vertices <= cells.size(); c += shape.n_vertices) {
            for (const LocalFace& local : shape.faces) {
                std::vector<Index> face;
                for (int i : local) {
                    if (i >= 0) face.push_back(cells[c + static_cast<std::size_t>(i)]);
                }
                AppendEdges(face, edges);
            }
        }
    }
    for (std::size_t f = 0; f + 3 <= topology.triangles.size(); f += 3) {
        AppendEdges(std::span(topology.triangles).subspan(f, 3), edges);
    }
    for (std::size_t f = 0; f + 4 <= topology.quads.size(); f += 4) {
        AppendEdges(std::span(topology.quads).subspan(f, 4), edges);
    }
    for (std::size_t f = 0; f + 1 < topology.polygon_offsets.size(); ++f) {
        const auto begin = static_cast<std::size_t>(topology.polygon_offsets[f]);
        const auto end = static_cast<std::size_t>(topology.polygon_offsets[f + 1]);
        AppendEdges(std::span(topology.polygon_vertices).subspan(begin, end - begin), edges);
    }
    for (std::size_t e = 0; e + 2 <= topology.edges.size(); e += 2) {
        edges.push_back(
            {std::min(topology.edges[e], topology.edges[e + 1]), std::max(topology.edges[e], topology.edges[e + 1])});
    }
    return Unique(std::move(edges));
}

}  // namespace SolidSubdiv::Picture
