// SPDX-License-Identifier: Apache-2.0
// The rows of one refinement by the polyhedral split: for each child vertex, which parent vertices with which weights.
//
// Rules speak of centroids of cells, faces and edges around a place; a row sums the vertices that these are means of.
#pragma once

#include <algorithm>
#include <array>
#include <cassert>

#include <solidsubdiv/far/internal/cell_averages.h>
#include <solidsubdiv/far/internal/centroid_row.h>
#include <solidsubdiv/far/internal/hex_rows.h>
#include <solidsubdiv/far/internal/sharpness.h>
#include <solidsubdiv/sdc/masks.h>
#include <solidsubdiv/sdc/polyhedral_masks.h>
#include <solidsubdiv/vtr/polyhedral_level.h>

namespace SolidSubdiv::Far::Internal {

class PolyhedralRows {
  public:
    /// @param sharpness the parent's
    PolyhedralRows(const Vtr::PolyhedralLevel& parent, const Sharpness& sharpness, const Sdc::PolyhedralRules& rules,
                   Sdc::CreasingMethod creasing)
        : level_(parent),
          graph_(parent),
          sharp_(graph_, sharpness, creasing),
          rules_(rules),
          hexes_(parent, rules),
          max_face_(MaxFaceOf(parent)),
          max_cell_(MaxCellOf(parent)) {
        assert(parent.is_full);
    }

    static constexpr bool kHasLengths = false;

    /// Rows by child vertex, in the child's numbering (vtr/polyhedral_refinement.h).
    Index n_children() const {
        return level_.n_vertices + level_.n_edges + level_.n_faces + static_cast<Index>(level_.n_cells());
    }

    /// At least the number of entries of a row; quick where the complex is a manifold of cells.
    std::size_t MaxLength(Index child) const {
        const auto [kind, i] = Locate(child);
        switch (kind) {
            case Kind::Vertex:
                if (IsAmongCells(level_.vertex_tags[i])) {
                    return 1 + level_.vertex_edges[i].size() + level_.vertex_cells[i].size() * max_cell_;
                }
                return MaxVertexLength(i);
            case Kind::Edge:
                return 2 + level_.edge_faces[i].size() * (max_face_ + 2 * max_cell_);
            case Kind::Face:
                return max_face_ + 2 * max_cell_;
            default:
                return level_.CellVertices(i).size();
        }
    }

    /// Calls add(vertex, weight) for the entries of a row, if all around is hexahedra and quadrilaterals; a vertex may
    /// come twice where cells or faces meet in more than a part. Otherwise false, and no call: Fill knows.
    template <class Add>
    bool Visit(Index child, Add&& add) const {
        const auto [kind, i] = Locate(child);
        if (kind == Kind::Cell) {
            if (!level_.IsHex(i)) return false;
            for (Index v : level_.CellVertices(i)) add(v, 1.0 / 8.0);
            return true;
        }
        if (rules_.is_linear()) return false;
        if (kind == Kind::Face) return !level_.IsBoundary(i) && hexes_.VisitFace(i, add);
        const Vtr::Tag tag = kind == Kind::Vertex ? level_.vertex_tags[i] : level_.edge_tags[i];
        if (tag.non_manifold()) return false;
        if (tag.rule() == Vtr::Rule::Solid) {
            return kind == Kind::Vertex ? hexes_.VisitVertex(i, add) : hexes_.VisitEdge(i, add);
        }
        if (tag.rule() != Vtr::Rule::Surface) return false;
        if (kind == Kind::Edge) return !sharp_.ChangesEdge(i) && hexes_.VisitSurfaceEdge(i, add);
        if (sharp_.ChangesVertex(i)) return false;
        std::array<Index, 16> edges;
        std::size_t n = 0;
        ForSurfaceEdges(graph_, i, [&](Index e) {
            if (n < edges.size()) edges[n] = e;
            ++n;
        });
        return n <= edges.size() && hexes_.VisitSurfaceVertex(i, {edges.data(), n}, add);
    }

    /// Fills the row and returns its length. Room for MaxLength(child) is needed.
    template <class Real>
    std::size_t Fill(Index child, Index* indices, Real* weights, RowScratch& scratch) const {
        const auto [kind, i] = Locate(child);
        scratch.MakeNotes(level_.n_vertices);
        if (const std::size_t room = MaxLength(child); scratch.sums.size() < room) scratch.sums.resize(2 * room);
        CentroidRow row(indices, scratch);
        if (!Visit(child, [&](Index v, double weight) { row.Add(v, weight); })) Add(kind, i, row);
        for (int k = 0; k < row.size(); ++k) weights[k] = static_cast<Real>(row[k]);
        return static_cast<std::size_t>(row.size());
    }

  private:
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

    static bool IsAmongCells(Vtr::Tag tag) { return tag.in_cell() && !tag.non_manifold(); }
    std::size_t MaxVertexLength(Index v) const {
        std::size_t n = 1 + level_.vertex_cells[v].size() * max_cell_;
        for (Index e : level_.vertex_edges[v]) n += 1 + level_.edge_faces[e].size() * max_face_;
        return n;
    }
    /// The greatest number of vertices of a face; of a cell, which must be full.
    static std::size_t MaxFaceOf(const Vtr::PolyhedralLevel& level) {
        int n = 4;
        if (level.face_rows.is_fixed()) return static_cast<std::size_t>(level.face_rows.fixed);
        for (Index f = 0; f < level.n_faces; ++f) n = std::max(n, level.face_rows.Count(f));
        return static_cast<std::size_t>(n);
    }
    static std::size_t MaxCellOf(const Vtr::PolyhedralLevel& level) {
        std::size_t n = Sdc::Hex::kVertices;
        for (Index c = level.n_hexes; c < static_cast<Index>(level.n_cells()); ++c) {
            n = std::max(n, level.CellVertices(c).size());
        }
        return n;
    }

    void Add(Kind kind, Index i, CentroidRow& row) const {
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

    void AddCell(Index c, CentroidRow& row) const {
        const auto vertices = level_.CellVertices(c);
        // Of a hexahedron's corners none is special.
        if (rules_.solid != Sdc::PolyhedralRule::Averaged || level_.IsHex(c)) return row.AddMean(vertices, 1);
        for (Index v : vertices) AddNewCell(level_, c, v, 1 / static_cast<double>(vertices.size()), row);
    }

    void AddFace(Index f, CentroidRow& row) const {
        const auto cells = level_.FaceCells(f);
        if (rules_.is_linear() || level_.IsBoundary(f)) return row.AddMean(level_.FaceVertices(f), 1);
        if (rules_.solid == Sdc::PolyhedralRule::Averaged) {
            const auto vertices = level_.FaceVertices(f);
            const double share = 0.5 / static_cast<double>(vertices.size());
            for (Index c : cells) {
                for (Index v : vertices) AddNewCell(level_, c, v, share, row);
            }
            return;
        }
        const auto w = Sdc::PolyhedralRules::SolidFace();
        row.AddMean(level_.FaceVertices(f), w.face);
        for (Index c : cells) row.AddMean(level_.CellVertices(c), w.cell);
    }

    void AddEdge(Index e, CentroidRow& row) const {
        const auto ends = level_.EdgeVertices(e);
        const Vtr::Rule rule = level_.edge_tags[e].rule();
        if (rules_.is_linear() || rule == Vtr::Rule::Curve) return row.AddMean(ends, 1);
        if (rule == Vtr::Rule::Solid) {
            int n = 0;
            for (Index f : level_.edge_faces[e]) n += level_.NCells(f) == 2;
            if (rules_.solid == Sdc::PolyhedralRule::Averaged) return AddAveragedEdge(e, 0.25 / n, row);
            const auto w = Sdc::PolyhedralRules::SolidEdgeOf(n);
            row.AddMean(ends, w.middle);
            for (Index f : level_.edge_faces[e]) {
                if (level_.NCells(f) != 2) continue;
                row.AddMean(level_.FaceVertices(f), w.face);
                // Each cell at the edge has two faces there.
                for (Index c : level_.FaceCells(f)) row.AddMean(level_.CellVertices(c), w.cell / 2);
            }
            return;
        }
        const double crease = sharp_.ChangesEdge(e) ? sharp_.CreaseShare(e) : 0, smooth = 1 - crease;
        Index faces[2] = {kNoIndex, kNoIndex};
        for (Index f : level_.edge_faces[e]) {
            if (level_.IsBoundary(f)) (faces[0] == kNoIndex ? faces[0] : faces[1]) = f;
        }
        if (rules_.surface == Sdc::PolyhedralRule::Averaged) {
            row.AddMean(ends, crease);
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
        for (Index f : faces) row.AddMean(level_.FaceVertices(f), w.face * smooth);
    }

    std::size_t CornerOf(Index f, Index v) const {
        const auto vertices = level_.FaceVertices(f);
        return static_cast<std::size_t>(std::find(vertices.begin(), vertices.end(), v) - vertices.begin());
    }

    /// Each cell at the edge has two faces there, each face with two cells, and a new cell at each end.
    void AddAveragedEdge(Index e, double share, CentroidRow& row) const {
        for (Index f : level_.edge_faces[e]) {
            if (level_.NCells(f) != 2) continue;
            for (Index c : level_.FaceCells(f)) {
                for (Index v : level_.EdgeVertices(e)) AddNewCell(level_, c, v, share, row);
            }
        }
    }

    void AddVertex(Index v, CentroidRow& row) const {
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

    void AddSolidVertex(Index v, CentroidRow& row) const {
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
                if (level_.NCells(f) > 0) row.AddMean(level_.FaceVertices(f), w.face / n_sides);
            }
        }
        for (Index c : cells) row.AddMean(level_.CellVertices(c), w.cell / static_cast<double>(cells.size()));
    }

    /// From the edges and faces of the surface at v alone.
    void AddSurfaceVertex(Index v, double share, CentroidRow& row) const {
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
                if (level_.NCells(f) == n_cells) row.AddMean(level_.FaceVertices(f), share * w.face / 2);
            }
        });
    }

    void AddCurveVertex(Index v, CentroidRow& row) const {
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
    const HexRows hexes_;
    const std::size_t max_face_, max_cell_;  // vertices
};

}  // namespace SolidSubdiv::Far::Internal
