// SPDX-License-Identifier: Apache-2.0
// Rows in places where all cells are hexahedra and all faces quadrilaterals, as they are nearly everywhere after one
// split: each vertex around comes once, with the weight of its role, so that a row can be summed as it is visited.
//
// Where that is not so the visits return false and call nothing: PolyhedralRows has the general way.
#pragma once

#include <algorithm>
#include <array>
#include <span>

#include <solidsubdiv/sdc/hex_split.h>
#include <solidsubdiv/sdc/polyhedral_masks.h>
#include <solidsubdiv/vtr/polyhedral_level.h>

namespace SolidSubdiv::Far::Internal {

class HexRows {
  public:
    HexRows(const Vtr::PolyhedralLevel& level, const Sdc::PolyhedralRules& rules) : level_(level), rules_(rules) {}

    /// Inside a solid. @pre its rule is that of solids, and the complex is a manifold there
    template <class Add>
    bool VisitVertex(Index v, Add&& add) const {
        const auto cells = level_.vertex_cells[v];
        const auto edges = level_.vertex_edges[v];
        if (!std::all_of(cells.begin(), cells.end(), [&](Index c) { return level_.IsHex(c); })) return false;
        int n_sides = 0;  // each face at v has two edges there
        for (Index e : edges) n_sides += level_.edge_faces.Count(e);
        const auto w = rules_.HexVertex(static_cast<int>(edges.size()), n_sides / 2, static_cast<int>(cells.size()));
        add(v, w.self);
        for (Index e : edges) {
            const auto faces = level_.edge_faces[e];
            add(level_.OtherEnd(e, v), w.edge + w.edge_cell * static_cast<double>(faces.size()));
            VisitAcross(v, e, faces, w.face, add);
        }
        for (Index c : cells) {
            const auto corners = Corners(c);
            add(corners[Sdc::Hex::Opposite(Place(corners, v))], w.far);
        }
        return true;
    }

    /// The same.
    template <class Add>
    bool VisitEdge(Index e, Add&& add) const {
        const auto faces = level_.edge_faces[e];
        const std::size_t n = faces.size();
        std::array<Index, kMost> cells;
        if (n > kMost) return false;
        std::size_t n_cells = 0;
        for (Index f : faces) {
            for (Index c : level_.FaceCells(f)) {
                if (!level_.IsHex(c)) return false;
                if (std::find(cells.begin(), cells.begin() + n_cells, c) != cells.begin() + n_cells) continue;
                if (n_cells == n) return false;  // a ring has as many cells as faces
                cells[n_cells++] = c;
            }
        }
        const auto w = rules_.HexEdge(static_cast<int>(n));
        const auto ends = level_.EdgeVertices(e);
        for (Index v : ends) add(v, w.end);
        for (Index f : faces) VisitBeside(e, f, w.face, add);
        for (std::size_t i = 0; i < n_cells; ++i) {
            const auto corners = Corners(cells[i]);
            for (Index v : ends) add(corners[Sdc::Hex::Opposite(Place(corners, v))], w.far);
        }
        return true;
    }

    /// The same.
    template <class Add>
    bool VisitFace(Index f, Add&& add) const {
        const auto cells = level_.FaceCells(f);
        if (!level_.IsHex(cells[0]) || !level_.IsHex(cells[1])) return false;
        const auto w = rules_.HexFace();
        for (Index v : level_.FaceVertices(f)) add(v, w.near);
        for (Index c : cells) {
            const auto corners = Corners(c);
            const auto sides = level_.CellFaces(c);
            const std::size_t side = static_cast<std::size_t>(std::find(sides.begin(), sides.end(), f) - sides.begin());
            for (Sdc::Local i : Sdc::Hex::faces[side ^ 1]) add(corners[i], w.far);  // faces come in opposite pairs
        }
        return true;
    }

    /// On a surface whose edges at v are `edges`. @pre its rule is that of smooth surfaces, a manifold there
    template <class Add>
    bool VisitSurfaceVertex(Index v, std::span<const Index> edges, Add&& add) const {
        for (Index e : edges) {
            for (Index f : level_.edge_faces[e]) {
                if (level_.IsBoundary(f) && level_.face_rows.Count(f) != 4) return false;
            }
        }
        const auto w = rules_.QuadVertex(static_cast<int>(edges.size()));
        add(v, w.self);
        for (Index e : edges) {
            add(level_.OtherEnd(e, v), w.neighbor);
            for (Index f : level_.edge_faces[e]) {
                if (level_.IsBoundary(f)) VisitAcross(v, e, {&f, 1}, w.across, add);
            }
        }
        return true;
    }

    /// The same on an edge between two faces.
    template <class Add>
    bool VisitSurfaceEdge(Index e, Add&& add) const {
        for (Index f : level_.edge_faces[e]) {
            if (level_.IsBoundary(f) && level_.face_rows.Count(f) != 4) return false;
        }
        // Both rules of surfaces are bicubic there.
        for (Index v : level_.EdgeVertices(e)) add(v, 3.0 / 8.0);
        for (Index f : level_.edge_faces[e]) {
            if (level_.IsBoundary(f)) VisitBeside(e, f, 1.0 / 16.0, add);
        }
        return true;
    }

  private:
    static constexpr std::size_t kMost = 16;  ///< faces at an edge

    std::span<const Index, 8> Corners(Index c) const {
        return std::span<const Index, 8>(level_.hex_vertices.data() + 8 * static_cast<std::size_t>(c), 8);
    }
    /// Without a branch for each: where v is among the corners is anybody's guess.
    static int Place(std::span<const Index, 8> corners, Index v) {
        int place = 0;
        for (int i = 1; i < 8; ++i) place = corners[static_cast<std::size_t>(i)] == v ? i : place;
        return place;
    }

    /// The vertex across each quadrilateral from v, once: from the edge of v that the face lists first.
    template <class Add>
    void VisitAcross(Index v, Index e, std::span<const Index> faces, double weight, Add&& add) const {
        for (Index f : faces) {
            const auto corners = level_.FaceVertices(f);
            const auto edges = level_.FaceEdges(f);
            for (std::size_t k = 0; k < 4; ++k) {
                if (corners[k] == v && edges[k] == e) add(corners[(k + 2) % 4], weight);
            }
        }
    }
    /// The two vertices of a quadrilateral that its edge e does not have.
    template <class Add>
    void VisitBeside(Index e, Index f, double weight, Add&& add) const {
        const auto corners = level_.FaceVertices(f);
        const auto edges = level_.FaceEdges(f);
        const std::size_t k = static_cast<std::size_t>(std::find(edges.begin(), edges.begin() + 3, e) - edges.begin());
        add(corners[(k + 2) % 4], weight);
        add(corners[(k + 3) % 4], weight);
    }

    const Vtr::PolyhedralLevel& level_;
    const Sdc::PolyhedralRules rules_;
};

}  // namespace SolidSubdiv::Far::Internal
