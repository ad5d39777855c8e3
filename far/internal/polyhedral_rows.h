// SPDX-License-Identifier: Apache-2.0
// The rows of one refinement by the polyhedral split: for each child vertex, which parent vertices with which weights.
#pragma once

#include <algorithm>
#include <array>

#include <solidsubdiv/far/internal/centroid_row.h>
#include <solidsubdiv/far/internal/centroid_rules.h>
#include <solidsubdiv/far/internal/hex_rows.h>

namespace SolidSubdiv::Far::Internal {

class PolyhedralRows {
    using Kind = CentroidRules::Kind;

  public:
    /// @param sharpness the parent's
    PolyhedralRows(const Vtr::PolyhedralLevel& parent, const Sharpness& sharpness, const Sdc::PolyhedralRules& rules,
                   Sdc::CreasingMethod creasing)
        : rules_(parent, sharpness, rules, creasing),
          level_(parent),
          hexes_(parent, rules),
          max_face_(MaxFaceOf(parent)),
          max_cell_(MaxCellOf(parent)) {}

    static constexpr bool kHasLengths = false;

    Index n_children() const { return rules_.n_children(); }
    const CentroidRules& rules() const { return rules_; }

    /// At least the number of entries of a row; quick where the complex is a manifold of cells.
    std::size_t MaxLength(Index child) const {
        const auto [kind, i] = rules_.Locate(child);
        switch (kind) {
            case Kind::Vertex:
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
        const auto [kind, i] = rules_.Locate(child);
        if (kind == Kind::Cell) {
            if (!level_.IsHex(i)) return false;
            for (Index v : level_.CellVertices(i)) add(v, 1.0 / 8.0);
            return true;
        }
        if (rules_.rules().is_linear()) return false;
        if (kind == Kind::Face) return !level_.IsBoundary(i) && hexes_.VisitFace(i, add);
        const Vtr::Tag tag = kind == Kind::Vertex ? level_.vertex_tags[i] : level_.edge_tags[i];
        if (tag.non_manifold()) return false;
        if (tag.rule() == Vtr::Rule::Solid) {
            return kind == Kind::Vertex ? hexes_.VisitVertex(i, add) : hexes_.VisitEdge(i, add);
        }
        if (tag.rule() != Vtr::Rule::Surface) return false;
        const SharpRules& sharp = rules_.sharp();
        if (kind == Kind::Edge) return !sharp.ChangesEdge(i) && hexes_.VisitSurfaceEdge(i, add);
        if (sharp.ChangesVertex(i)) return false;
        std::array<Index, 16> edges;
        std::size_t n = 0;
        ForSurfaceEdges(rules_.graph(), i, [&](Index e) {
            if (n < edges.size()) edges[n] = e;
            ++n;
        });
        return n <= edges.size() && hexes_.VisitSurfaceVertex(i, {edges.data(), n}, add);
    }

    /// Fills the row and returns its length. Room for MaxLength(child) is needed.
    template <class Real>
    std::size_t Fill(Index child, Index* indices, Real* weights, RowScratch& scratch) const {
        scratch.MakeNotes(level_.n_vertices);
        if (const std::size_t room = MaxLength(child); scratch.sums.size() < room) scratch.sums.resize(2 * room);
        CentroidRow row(level_, indices, scratch);
        if (!Visit(child, [&](Index v, double weight) { row.Add(v, weight); })) rules_.Add(child, row);
        for (int k = 0; k < row.size(); ++k) weights[k] = static_cast<Real>(row[k]);
        return static_cast<std::size_t>(row.size());
    }

  private:
    std::size_t MaxVertexLength(Index v) const {
        const Vtr::Tag tag = level_.vertex_tags[v];
        const auto edges = level_.vertex_edges[v];
        std::size_t n = 1 + edges.size() + level_.vertex_cells[v].size() * max_cell_;
        if (tag.in_cell() && !tag.non_manifold()) return n;  // faces are those of the cells
        for (Index e : edges) n += level_.edge_faces[e].size() * max_face_;
        return n;
    }
    /// The greatest number of vertices of a face, of a cell.
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

    const CentroidRules rules_;
    const Vtr::PolyhedralLevel& level_;
    const HexRows hexes_;
    const std::size_t max_face_, max_cell_;  // vertices
};

}  // namespace SolidSubdiv::Far::Internal
