// SPDX-License-Identifier: Apache-2.0
// The rules of the polyhedral split: which vertices and centroids of faces and cells make a new point, with which
// weights. A row of vertices sums them up; values are summed from centroids that are there already.
//
// A Row takes in Add(vertex, weight), AddFace(face, weight) and AddCell(cell, weight): the last two are for centroids.
#pragma once

#include <algorithm>
#include <array>
#include <cassert>

#include <solidsubdiv/far/internal/cell_averages.h>
#include <solidsubdiv/far/internal/sharpness.h>
#include <solidsubdiv/sdc/masks.h>
#include <solidsubdiv/sdc/polyhedral_masks.h>
#include <solidsubdiv/vtr/polyhedral_level.h>

namespace SolidSubdiv::Far::Internal {

class CentroidRules {
  public:
    /// @param sharpness the parent's. It and the parent outlive this.
    CentroidRules(const Vtr::PolyhedralLevel& parent, const Sharpness& sharpness, const Sdc::PolyhedralRules& rules,
                  Sdc::CreasingMethod creasing)
        : level_(parent), graph_(parent), sharp_(graph_, sharpness, creasing), rules_(rules) {
        assert(parent.is_full);
        for (int n = 1; n < kFew; ++n)
            edge_weights_[static_cast<std::size_t>(n)] = Sdc::PolyhedralRules::SolidEdgeOf(n);
    }

    const Vtr::PolyhedralLevel& level() const { return level_; }
    const Vtr::EdgeGraph& graph() const { return graph_; }
    const SharpRules& sharp() const { return sharp_; }
    const Sdc::PolyhedralRules& rules() const { return rules_; }

    /// Children by number, as vtr/polyhedral_refinement.h has them.
    Index n_children() const {
        return level_.n_vertices + level_.n_edges + level_.n_faces + static_cast<Index>(level_.n_cells());
    }
    enum class Kind { Vertex, Edge, Face, Cell };
    struct Place {
        Kind kind;
        Index i;  ///< among the parent's components of that kind
    };
    Place Locate(Index child) const {
        if (child < level_.n_vertices) return {Kind::Vertex, child};
        child -= level_.n_vertices;
        if (child < level_.n_edges) return {Kind::Edge, child};
        child -= level_.n_edges;
        if (child < level_.n_faces) return {Kind::Face, child};
        return {Kind::Cell, child - level_.n_faces};
    }

    /// Adds up a new point.
    template <class Row>
    void Add(Index child, Row& row) const {
        const auto [kind, i] = Locate(child);
        switch (kind) {
            case Kind::Vertex:
                return AddVertex(i, row);
            case Kind::Edge:
                return AddEdge(i, row);
            case Kind::Face:
                return AddFace(i, row);
            case Kind::Cell:
                return AddCell(i, row);
        }
    }

  private:
    template <class Row>
    static void AddMiddle(std::span<const Index, 2> ends, double weight, Row& row) {
        for (Index v : ends) row.Add(v, weight / 2);
    }

    template <class Row>
    void AddCell(Index c, Row& row) const {
        const auto vertices = level_.CellVertices(c);
        // Of a hexahedron's corners none is special.
        if (rules_.solid != Sdc::PolyhedralRule::Averaged || level_.IsHex(c)) return row.AddCell(c, 1);
        for (Index v : vertices) AddNewCell(level_, c, v, 1 / static_cast<double>(vertices.size()), row);
    }

    template <class Row>
    void AddFace(Index f, Row& row) const {
        const auto cells = level_.FaceCells(f);
        if (rules_.is_linear() || level_.IsBoundary(f)) return row.AddFace(f, 1);
        if (rules_.solid == Sdc::PolyhedralRule::Averaged) {
            const auto vertices = level_.FaceVertices(f);
            const double share = 0.5 / static_cast<double>(vertices.size());
            for (Index c : cells) {
                for (Index v : vertices) AddNewCell(level_, c, v, share, row);
            }
            return;
        }
        const auto w = Sdc::PolyhedralRules::SolidFace();
        row.AddFace(f, w.face);
        for (Index c : cells) row.AddCell(c, w.cell);
    }

    template <class Row>
    void AddEdge(Index e, Row& row) const {
        const auto ends = level_.EdgeVertices(e);
        const Vtr::Rule rule = level_.edge_tags[e].rule();
        if (rules_.is_linear() || rule == Vtr::Rule::Curve) return AddMiddle(ends, 1, row);
        if (rule == Vtr::Rule::Solid) {
            const auto faces = level_.edge_faces[e];
            const bool has_sheets = level_.edge_tags[e].non_manifold();
            int n = static_cast<int>(faces.size());
            if (has_sheets) {
                n = static_cast<int>(
                    std::count_if(faces.begin(), faces.end(), [&](Index f) { return level_.NCells(f) == 2; }));
            }
            if (rules_.solid == Sdc::PolyhedralRule::Averaged) return AddAveragedEdge(e, 0.25 / n, row);
            const auto w = n < kFew ? edge_weights_[static_cast<std::size_t>(n)] : Sdc::PolyhedralRules::SolidEdgeOf(n);
            AddMiddle(ends, w.middle, row);
            for (Index f : faces) {
                if (has_sheets && level_.NCells(f) != 2) continue;
                row.AddFace(f, w.face);
                // Each cell at the edge has two faces there.
                for (Index c : level_.FaceCells(f)) row.AddCell(c, w.cell / 2);
            }
            return;
        }
        const double crease = sharp_.ChangesEdge(e) ? sharp_.CreaseShare(e) : 0, smooth = 1 - crease;
        Index faces[2] = {kNoIndex, kNoIndex};
        for (Index f : level_.edge_faces[e]) {
            if (level_.IsBoundary(f)) (faces[0] == kNoIndex ? faces[0] : faces[1]) = f;
        }
        if (rules_.surface == Sdc::PolyhedralRule::Averaged) {
            AddMiddle(ends, crease, row);
            if (smooth == 0) return;
            for (Index f : faces) {
                for (Index v : ends) AddNewFace(level_, f, CornerOf(f, v), smooth / 4, row);
            }
            return;
        }
        const auto is_triangle = [&](Index f) { return level_.FaceVertices(f).size() == 3; };
        const auto w = rules_.SurfaceEdgeOf(is_triangle(faces[0]), is_triangle(faces[1]));
        for (Index v : ends) row.Add(v, 0.5 * crease + w.end * smooth);
        if (smooth == 0) return;
        for (Index f : faces) row.AddFace(f, w.face * smooth);
    }

    std::size_t CornerOf(Index f, Index v) const {
        const auto vertices = level_.FaceVertices(f);
        return static_cast<std::size_t>(std::find(vertices.begin(), vertices.end(), v) - vertices.begin());
    }

    /// Each cell at the edge has two faces there, each face with two cells, and a new cell at each end.
    template <class Row>
    void AddAveragedEdge(Index e, double share, Row& row) const {
        for (Index f : level_.edge_faces[e]) {
            if (level_.NCells(f) != 2) continue;
            for (Index c : level_.FaceCells(f)) {
                for (Index v : level_.EdgeVertices(e)) AddNewCell(level_, c, v, share, row);
            }
        }
    }

    template <class Row>
    void AddVertex(Index v, Row& row) const {
        const Vtr::Tag tag = level_.vertex_tags[v];
        if (rules_.is_linear() || tag.rule() == Vtr::Rule::Corner) return row.Add(v, 1);
        if (tag.rule() == Vtr::Rule::Solid) return AddSolidVertex(v, row);
        if (!sharp_.ChangesVertex(v)) {
            if (tag.rule() == Vtr::Rule::Surface) return AddSurfaceVertex(v, 1, row);
            return AddCurveVertex(v, row);
        }
        for (const SharpRules::Part& part : sharp_.VertexParts(v)) {
            if (part.share == 0) continue;
            if (part.rule == Sdc::SharpRule::Corner) {
                row.Add(v, part.share);
            } else if (part.rule == Sdc::SharpRule::Crease) {
                row.Add(v, 0.75 * part.share);
                for (Index e : part.crease) row.Add(level_.OtherEnd(e, v), 0.125 * part.share);
            } else {
                AddSurfaceVertex(v, part.share, row);
            }
        }
    }

    template <class Row>
    void AddSolidVertex(Index v, Row& row) const {
        const auto cells = level_.vertex_cells[v];
        if (rules_.solid == Sdc::PolyhedralRule::Averaged) {
            for (Index c : cells) AddNewCell(level_, c, v, 1 / static_cast<double>(cells.size()), row);
            return;
        }
        const auto w = Sdc::PolyhedralRules::SolidVertexRule();
        int n_edges = 0, n_sides = 0;  // each face at v has two edges there
        for (Index e : level_.vertex_edges[v]) {
            if (!level_.edge_tags[e].in_cell()) continue;
            ++n_edges;
            for (Index f : level_.edge_faces[e]) n_sides += level_.NCells(f) > 0;
        }
        row.Add(v, w.self + w.middle / 2);
        for (Index e : level_.vertex_edges[v]) {
            if (!level_.edge_tags[e].in_cell()) continue;
            row.Add(level_.OtherEnd(e, v), w.middle / 2 / n_edges);
            for (Index f : level_.edge_faces[e]) {
                if (level_.NCells(f) > 0) row.AddFace(f, w.face / n_sides);
            }
        }
        for (Index c : cells) row.AddCell(c, w.cell / static_cast<double>(cells.size()));
    }

    /// From the edges and faces of the surface at v alone.
    template <class Row>
    void AddSurfaceVertex(Index v, double share, Row& row) const {
        const int n_cells = level_.vertex_tags[v].in_cell() ? 1 : 0;  // of the faces; others are sheets that end here
        int n = 0;
        ForSurfaceEdges(graph_, v, [&](Index) { ++n; });
        if (rules_.surface == Sdc::PolyhedralRule::Averaged) {
            ForSurfaceEdges(graph_, v, [&](Index e) {
                for (Index f : level_.edge_faces[e]) {
                    if (level_.NCells(f) == n_cells) AddNewFace(level_, f, CornerOf(f, v), share / (2 * n), row);
                }
            });
            return;
        }
        const auto w = Sdc::PolyhedralRules::SurfaceVertexOf(n);
        row.Add(v, share * w.self);
        ForSurfaceEdges(graph_, v, [&](Index e) {
            row.Add(level_.OtherEnd(e, v), share * w.neighbor);
            for (Index f : level_.edge_faces[e]) {
                // Each face at v has two edges there.
                if (level_.NCells(f) == n_cells) row.AddFace(f, share * w.face / 2);
            }
        });
    }

    template <class Row>
    void AddCurveVertex(Index v, Row& row) const {
        const Vtr::Tag tag = level_.vertex_tags[v];
        row.Add(v, 0.75);
        double left = 0.25;
        for (Index e : level_.vertex_edges[v]) {
            const Vtr::Tag edge = level_.edge_tags[e];
            const bool in_part = (!tag.in_cell() || edge.in_cell()) && (!tag.in_face() || edge.in_face());
            if (!in_part || edge.rule() != Vtr::Rule::Curve) continue;
            row.Add(level_.OtherEnd(e, v), 0.125);
            left -= 0.125;
        }
        if (left != 0) row.Add(v, left);
    }

    const Vtr::PolyhedralLevel& level_;
    const Vtr::EdgeGraph graph_;
    const SharpRules sharp_;
    const Sdc::PolyhedralRules rules_;
    static constexpr int kFew = 16;
    std::array<Sdc::PolyhedralRules::SolidEdge, kFew> edge_weights_{};  // by the number of faces: divisions take long
};

}  // namespace SolidSubdiv::Far::Internal
