// SPDX-License-Identifier: Apache-2.0
// Faces that one kept cell has to itself, found by bringing equal faces together; see cut.h.
#include <solidsubdiv/kit/picture/cut.h>
#include <solidsubdiv/kit/picture/internal/cell_shapes.h>
#include <solidsubdiv/sdc/parallel.h>

#include <algorithm>
#include <span>

namespace SolidSubdiv::Picture {
namespace {

/// A face of a cell: n corners from `first` on.
struct Face {
    std::size_t first, n;
    Index cell;
    CellKind kind;
    bool kept;
};

/// All faces of all cells.
struct CellSides {
    std::vector<Face> faces;
    std::vector<Index> corners;  // in order, from each face's lowest on
    std::vector<Index> keys;     // the same, ascending

    std::span<const Index> Corners(const Face& face) const { return std::span(corners).subspan(face.first, face.n); }
    std::span<const Index> Key(const Face& face) const { return std::span(keys).subspan(face.first, face.n); }
};

bool IsSame(std::span<const Index> a, std::span<const Index> b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end());
}
bool IsBefore(std::span<const Index> a, std::span<const Index> b) {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
}

void AppendEdges(std::span<const Index> vertices, std::vector<std::array<Index, 2>>& edges) {
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const Index a = vertices[i], b = vertices[(i + 1) % vertices.size()];
        edges.push_back({std::min(a, b), std::max(a, b)});
    }
}

/// A cell is kept if its centroid c has dot(normal, c - point) <= 0: always if the normal is zero.
CellSides SidesOfCells(const Io::Mesh& mesh, const Plane& plane) {
    CellSides sides;
    Index number = 0;
    Internal::ForEachCell(mesh.topology, [&](const Internal::CellFaces& cell) {
        double side = 0;
        for (Index v : cell.vertices()) {
            for (std::size_t k = 0; k < 3; ++k) {
                side += plane.normal[k] * (mesh.positions[3 * static_cast<std::size_t>(v) + k] - plane.point[k]);
            }
        }
        for (std::size_t i = 0; i < cell.n_faces(); ++i) {
            const auto face = cell.face(i);
            const std::size_t first = sides.corners.size();
            sides.faces.push_back({first, face.size(), number, cell.kind(), side <= 0});
            sides.corners.insert(sides.corners.end(), face.begin(), face.end());
            sides.keys.insert(sides.keys.end(), face.begin(), face.end());
            // From the lowest vertex, so that both cells cut a face into the same triangles.
            const auto begin = sides.corners.begin() + static_cast<std::ptrdiff_t>(first);
            std::rotate(begin, std::min_element(begin, sides.corners.end()), sides.corners.end());
            std::sort(sides.keys.begin() + static_cast<std::ptrdiff_t>(first), sides.keys.end());
        }
        ++number;
    });
    return sides;
}

/// Orders faces by key: first into one bucket a lowest vertex, then within the small buckets.
void BringTogether(CellSides& sides, Index n_vertices) {
    std::vector<Offset> start(static_cast<std::size_t>(n_vertices) + 1, 0);
    const auto lowest = [&](const Face& face) { return static_cast<std::size_t>(sides.keys[face.first]); };
    for (const Face& face : sides.faces) ++start[lowest(face)];
    Sdc::ScanLengths(start);
    std::vector<Offset> next(start.begin(), start.end() - 1);
    std::vector<Face> ordered(sides.faces.size());
    for (const Face& face : sides.faces) ordered[static_cast<std::size_t>(next[lowest(face)]++)] = face;
    Sdc::ParallelFor(n_vertices, 1024, [&](Offset begin, Offset end) {
        for (Offset v = begin; v < end; ++v) {
            std::sort(ordered.begin() + start[static_cast<std::size_t>(v)],
                      ordered.begin() + start[static_cast<std::size_t>(v) + 1], [&](const Face& a, const Face& b) {
                          if (!IsSame(sides.Key(a), sides.Key(b))) return IsBefore(sides.Key(a), sides.Key(b));
                          return IsBefore(sides.Corners(a), sides.Corners(b));
                      });
        }
    });
    sides.faces = std::move(ordered);
}

SolidFaces Visible(const Io::Mesh& mesh, const Plane& plane) {
    CellSides sides = SidesOfCells(mesh, plane);
    BringTogether(sides, mesh.topology.n_vertices);
    const std::vector<Face>& faces = sides.faces;
    SolidFaces out;
    std::vector<std::array<Index, 2>> edges;
    for (std::size_t i = 0; i < faces.size();) {
        std::size_t end = i, n_kept = 0, kept = i;
        for (; end < faces.size() && IsSame(sides.Key(faces[end]), sides.Key(faces[i])); ++end) {
            if (faces[end].kept) ++n_kept, kept = end;
        }
        if (n_kept == 1) {
            const Face& face = faces[kept];
            const auto corners = sides.Corners(face);
            const bool opened = end - i > 1;
            for (std::size_t t = 2; t < corners.size(); ++t) {
                out.triangles.insert(out.triangles.end(), {corners[0], corners[t - 1], corners[t]});
                out.kinds.push_back(face.kind);
                out.cells.push_back(face.cell);
                out.opened.push_back(opened ? 1 : 0);
            }
            if (opened) AppendEdges(corners, edges);
        }
        i = end;
    }
    out.edges = Internal::UniqueEdges(std::move(edges));
    return out;
}

}  // namespace

Color ColorOf(CellKind kind) {
    switch (kind) {
        case CellKind::Tet:
            return Palette::kTetrahedron;
        case CellKind::Oct:
            return Palette::kOctahedron;
        case CellKind::Hex:
            return Palette::kHexahedron;
        case CellKind::Wedge:
            return Palette::kWedge;
        case CellKind::Pyramid:
            return Palette::kPyramid;
        case CellKind::Polyhedron:
            return Palette::kPolyhedron;
    }
    return Palette::kSkin;
}

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
    Internal::CheckPlane(plane);
    return Visible(mesh, plane);
}

std::vector<Index> ElementEdges(const Io::Topology& topology) {
    std::vector<std::array<Index, 2>> edges;
    Internal::ForEachCell(topology, [&](const Internal::CellFaces& cell) {
        for (std::size_t i = 0; i < cell.n_faces(); ++i) AppendEdges(cell.face(i), edges);
    });
    const auto add_faces = [&](std::span<const Index> faces, std::size_t n) {
        for (std::size_t f = 0; f + n <= faces.size(); f += n) AppendEdges(faces.subspan(f, n), edges);
    };
    add_faces(topology.triangles, 3);
    add_faces(topology.quads, 4);
    for (std::size_t f = 0; f + 1 < topology.polygon_offsets.size(); ++f) {
        const auto begin = static_cast<std::size_t>(topology.polygon_offsets[f]);
        const auto end = static_cast<std::size_t>(topology.polygon_offsets[f + 1]);
        AppendEdges(std::span(topology.polygon_vertices).subspan(begin, end - begin), edges);
    }
    for (std::size_t e = 0; e + 2 <= topology.edges.size(); e += 2) {
        const Index a = topology.edges[e], b = topology.edges[e + 1];
        edges.push_back({std::min(a, b), std::max(a, b)});
    }
    return Internal::UniqueEdges(std::move(edges));
}

}  // namespace SolidSubdiv::Picture
