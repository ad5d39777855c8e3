// SPDX-License-Identifier: Apache-2.0
// Stars are built as meshes are, and split once.
#include <solidsubdiv/far/internal/vertex_star.h>

#include <algorithm>
#include <cassert>

#include <solidsubdiv/far/internal/polyhedral_rows.h>
#include <solidsubdiv/far/internal/row_buffer.h>
#include <solidsubdiv/far/internal/row_sum.h>
#include <solidsubdiv/vtr/polyhedral_base.h>
#include <solidsubdiv/vtr/polyhedral_refinement.h>

namespace SolidSubdiv::Far::Internal {

namespace {

/// Lists of vertices with offsets, as PolyhedralElements has them.
struct Lists {
    std::vector<Offset> offsets{0};
    std::vector<Index> vertices;
    void End() { offsets.push_back(static_cast<Offset>(vertices.size())); }
};

}  // namespace

VertexStar::VertexStar(const Vtr::PolyhedralLevel& level, const Sharpness& sharpness, Index vertex) {
    Add(vertex);
    std::vector<Index> hexes, edges;
    std::vector<Offset> cell_offsets{0};
    Lists cell_faces, polygons;
    for (Index c : level.vertex_cells[vertex]) {
        if (level.IsHex(c)) {
            for (Index v : level.CellVertices(c)) hexes.push_back(Add(v));
            continue;
        }
        const Vtr::Polyhedra& p = level.polyhedra;
        const Index i = c - level.n_hexes;
        for (Offset f = p.offsets[i]; f < p.offsets[i + 1]; ++f) {
            for (Offset k = p.face_vertex_offsets[f]; k < p.face_vertex_offsets[f + 1]; ++k) {
                cell_faces.vertices.push_back(Add(p.face_vertices[k]));
            }
            cell_faces.End();
        }
        cell_offsets.push_back(static_cast<Offset>(cell_faces.offsets.size()) - 1);
    }
    std::vector<Index> sheets;
    for (Index e : level.vertex_edges[vertex]) {
        if (level.edge_faces.Count(e) == 0) edges.insert(edges.end(), {0, Add(level.OtherEnd(e, vertex))});
        for (Index f : level.edge_faces[e]) {
            if (level.NCells(f) == 0) sheets.push_back(f);
        }
    }
    std::sort(sheets.begin(), sheets.end());
    sheets.erase(std::unique(sheets.begin(), sheets.end()), sheets.end());
    for (Index f : sheets) {
        for (Index v : level.FaceVertices(f)) polygons.vertices.push_back(Add(v));
        polygons.End();
    }

    Vtr::PolyhedralElements elements{.n_vertices = static_cast<Index>(vertices_.size())};
    elements.hexes = hexes;
    elements.cell_offsets = cell_offsets;
    elements.face_offsets = cell_faces.offsets;
    elements.face_vertices = cell_faces.vertices;
    elements.polygon_offsets = polygons.offsets;
    elements.polygon_vertices = polygons.vertices;
    elements.edges = edges;
    Vtr::PolyhedralFindings findings;
    star_ = Vtr::MakePolyhedralBaseLevel(elements, findings);
    assert(findings.IsUsable());
    split_ = Vtr::Refine(star_, true);
    if (!sharpness.empty()) AddSharpness(level, sharpness);
}

Index VertexStar::Add(Index vertex) {
    const auto number = std::find(vertices_.begin(), vertices_.end(), vertex) - vertices_.begin();
    if (number == static_cast<std::ptrdiff_t>(vertices_.size())) vertices_.push_back(vertex);
    return static_cast<Index>(number);
}

/// Of the vertex and its edges: no other counts at the vertex.
void VertexStar::AddSharpness(const Vtr::PolyhedralLevel& level, const Sharpness& sharpness) {
    sharpness_.edges.assign(static_cast<std::size_t>(star_.n_edges), 0.0f);
    sharpness_.vertices.assign(static_cast<std::size_t>(star_.n_vertices), 0.0f);
    sharpness_.vertices[0] = sharpness.vertices[vertices_[0]];
    for (Index e : star_.vertex_edges[0]) {
        const Index other = vertices_[static_cast<std::size_t>(star_.OtherEnd(e, 0))];
        sharpness_.edges[e] = sharpness.edges[level.FindEdge(vertices_[0], other)];
    }
}

LocalMatrix VertexStar::Matrix(const Sdc::PolyhedralRules& rules, Sdc::CreasingMethod creasing) const {
    const Sharpness sharpness =
        ChildrenSharpness(Vtr::EdgeGraph(star_), split_.n_edges, split_.n_vertices, sharpness_, creasing);
    const PolyhedralRows rows(split_, sharpness, rules, creasing);
    // Of the split star: the vertex, ends of its edges, corners of its faces and cells that lie across.
    LocalMatrix m;
    std::vector<Index> children{0};  // of the points of the ring, in the next split
    m.ring = {0};
    const auto add = [&](Index point, Index child) {
        if (std::find(m.ring.begin(), m.ring.end(), point) != m.ring.end()) return;
        m.ring.push_back(point);
        children.push_back(child);
    };
    const auto far_corner = [](std::span<const Index> corners) {
        return *std::max_element(corners.begin(), corners.end());
    };
    for (Index e : split_.vertex_edges[0]) add(split_.OtherEnd(e, 0), split_.n_vertices + e);
    for (Index e : split_.vertex_edges[0]) {
        for (Index f : split_.edge_faces[e]) {
            add(far_corner(split_.FaceVertices(f)), split_.n_vertices + split_.n_edges + f);
        }
    }
    for (Index c : split_.vertex_cells[0]) {
        add(far_corner(split_.CellVertices(c)), split_.n_vertices + split_.n_edges + split_.n_faces + c);
    }

    const std::size_t n = m.ring.size();
    m.weights.assign(n * n, 0.0);
    RowBuffer<double> row;
    for (std::size_t i = 0; i < n; ++i) {
        row.Read(rows, children[i]);
        for (std::size_t k = 0; k < row.n; ++k) {
            const auto column = std::find(m.ring.begin(), m.ring.end(), row.indices[k]) - m.ring.begin();
            assert(column < static_cast<std::ptrdiff_t>(n));
            m.weights[i * n + static_cast<std::size_t>(column)] = row.weights[k];
        }
    }
    return m;
}

void VertexStar::Compose(const Sdc::PolyhedralRules& rules, Sdc::CreasingMethod creasing, const LocalMatrix& matrix,
                         std::span<const double> mask, std::vector<Index>& indices,
                         std::vector<double>& weights) const {
    const PolyhedralRows rows(star_, sharpness_, rules, creasing);
    RowSum sum(star_.n_vertices);
    RowBuffer<double> row;
    for (std::size_t i = 0; i < mask.size(); ++i) {
        row.Read(rows, matrix.ring[i]);
        sum.Add(mask[i], row.Indices(), row.Weights());
    }
    Array<Index> here;
    Array<double> sums;
    sum.Flush(here, sums);
    for (Index i : here) indices.push_back(vertices_[static_cast<std::size_t>(i)]);
    weights.assign(sums.begin(), sums.end());
}

}  // namespace SolidSubdiv::Far::Internal
