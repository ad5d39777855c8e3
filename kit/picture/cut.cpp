// SPDX-License-Identifier: Apache-2.0
// Faces that one kept cell has to itself, found by bringing equal faces together; see cut.h.
#include <solidsubdiv/kit/picture/cut.h>
#include <solidsubdiv/kit/picture/internal/cell_shapes.h>
#include <solidsubdiv/sdc/parallel.h>

#include <algorithm>
#include <span>

namespace SolidSubdiv::Picture {
namespace {

using Internal::CellShape;

struct Face {
    std::array<Index, 4> key;       // ascending; the first is kNoIndex in triangles
    std::array<Index, 4> vertices;  // in order; the last is kNoIndex in triangles
    CellKind kind;
    bool kept;

    std::size_t LowestVertex() const { return static_cast<std::size_t>(key[0] == kNoIndex ? key[1] : key[0]); }
};

void AppendEdges(std::span<const Index> vertices, std::vector<std::array<Index, 2>>& edges) {
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const Index a = vertices[i], b = vertices[(i + 1) % vertices.size()];
        edges.push_back({std::min(a, b), std::max(a, b)});
    }
}

/// Faces of all cells. A cell is kept if its centroid c has dot(normal, c - point) <= 0: always if the normal is zero.
std::vector<Face> FacesOfCells(const Io::Mesh& mesh, const Plane& plane) {
    std::vector<Face> faces;
    Internal::ForEachCell(mesh.topology, [&](const CellShape& shape, std::span<const Index> cell) {
        double side = 0;
        for (Index v : cell) {
            for (std::size_t k = 0; k < 3; ++k) {
                side += plane.normal[k] * (mesh.positions[3 * static_cast<std::size_t>(v) + k] - plane.point[k]);
            }
        }
        for (const Internal::LocalFace& local : shape.faces) {
            Face face{{}, {}, shape.kind, side <= 0};
            for (std::size_t i = 0; i < 4; ++i) {
                face.vertices[i] = local[i] < 0 ? kNoIndex : cell[static_cast<std::size_t>(local[i])];
            }
            // From the lowest vertex, so that both cells cut a quad into the same triangles.
            const auto last = face.vertices.begin() + (face.vertices[3] == kNoIndex ? 3 : 4);
            std::rotate(face.vertices.begin(), std::min_element(face.vertices.begin(), last), last);
            face.key = face.vertices;
            std::sort(face.key.begin(), face.key.end());
            faces.push_back(face);
        }
    });
    return faces;
}

/// Orders faces by key: first into one bucket a lowest vertex, then within the small buckets.
std::vector<Face> BringTogether(const std::vector<Face>& faces, Index n_vertices) {
    std::vector<Offset> start(static_cast<std::size_t>(n_vertices) + 1, 0);
    for (const Face& face : faces) ++start[face.LowestVertex()];
    Sdc::ScanLengths(start);
    std::vector<Offset> next(start.begin(), start.end() - 1);
    std::vector<Face> ordered(faces.size());
    for (const Face& face : faces) ordered[static_cast<std::size_t>(next[face.LowestVertex()]++)] = face;
    Sdc::ParallelFor(n_vertices, 1024, [&](Offset begin, Offset end) {
        for (Offset v = begin; v < end; ++v) {
            std::sort(ordered.begin() + start[static_cast<std::size_t>(v)],
                      ordered.begin() + start[static_cast<std::size_t>(v) + 1], [](const Face& a, const Face& b) {
                          return a.key != b.key ? a.key < b.key : a.vertices < b.vertices;
                      });
        }
    });
    return ordered;
}

SolidFaces Visible(const Io::Mesh& mesh, const Plane& plane) {
    Internal::RefusePolyhedra(mesh.topology);
    const std::vector<Face> faces = BringTogether(FacesOfCells(mesh, plane), mesh.topology.n_vertices);
    SolidFaces out;
    std::vector<std::array<Index, 2>> edges;
    for (std::size_t i = 0; i < faces.size();) {
        std::size_t end = i, n_kept = 0, kept = i;
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
        default:
            return Palette::kOtherCell;
    }
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
    Internal::ForEachCell(topology, [&](const CellShape& shape, std::span<const Index> cell) {
        for (const Internal::LocalFace& local : shape.faces) {
            std::array<Index, 4> face{};
            std::size_t n = 0;
            for (int i : local) {
                if (i >= 0) face[n++] = cell[static_cast<std::size_t>(i)];
            }
            AppendEdges(std::span(face).first(n), edges);
        }
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
