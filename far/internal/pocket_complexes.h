// SPDX-License-Identifier: Apache-2.0
// What pockets are made of, seen alike: elements that meet in sides. Cells of either split, or boundary faces.
#pragma once

#include <algorithm>
#include <array>
#include <numeric>
#include <span>
#include <vector>

#include <solidsubdiv/far/internal/pocket.h>

namespace SolidSubdiv::Far::Internal {

/// Cells of a level of tets and octahedra and what they meet in.
class TetOctCells {
  public:
    static constexpr bool kAreFaces = false;

    explicit TetOctCells(const Level& level)
        : level_(level), tets_at_(Vtr::Invert(level.tet_vertices, 4, level.n_vertices, false)) {}

    const Level& level() const { return level_; }
    Index size() const { return static_cast<Index>(level_.n_cells()); }
    Index n_sides() const { return level_.n_faces; }
    RootKind KindOf(Index c) const { return c < level_.n_tets ? RootKind::Tet : RootKind::Oct; }
    std::span<const Index> Vertices(Index c) const {
        if (c < level_.n_tets) return level_.TetVertices(c);
        return level_.OctVertices(c - level_.n_tets);
    }
    std::span<const Index> Sides(Index c) const {
        if (c < level_.n_tets) return level_.TetFaces(c);
        return level_.OctFaces(c - level_.n_tets);
    }
    std::span<const Index> SideVertices(Index side) const { return level_.FaceVertices(side); }
    template <class Body>
    void ForElementsAt(Index v, Body&& body) const {
        for (Index t : tets_at_[v]) body(t);
        for (Index o : level_.vertex_octs[v]) body(level_.n_tets + o);
    }
    bool IsSheet(Index face) const { return level_.face_tags[face].n_cells() == 0; }
    /// Whether two corners of a cell lie across from each other: of an octahedron.
    bool AreAcross(Index c, Index v, Index w) const {
        if (c < level_.n_tets) return false;
        const auto o = Vertices(c);
        for (std::size_t i = 0; i < 6; ++i) {
            if (o[i] == v) return o[i ^ 1] == w;
        }
        return false;
    }

    /// Of a tet with vertex v: the B edge that has v not, and the other end of the one that has it.
    std::array<Index, 2> FarBEdge(Index t, Index v) const {
        const auto w = Vertices(t);
        return w[0] == v || w[1] == v ? std::array{w[2], w[3]} : std::array{w[0], w[1]};
    }
    Index NearBEnd(Index t, Index v) const {
        const auto w = Vertices(t);
        return w[static_cast<std::size_t>((std::find(w.begin(), w.end(), v) - w.begin()) ^ 1)];
    }

  private:
    const Level& level_;
    Vtr::Relation tets_at_;
};

/// The same of polyhedra.
class PolyhedralCells {
  public:
    static constexpr bool kAreFaces = false;

    explicit PolyhedralCells(const Vtr::PolyhedralLevel& level) : level_(level) {}

    const Vtr::PolyhedralLevel& level() const { return level_; }
    Index size() const { return static_cast<Index>(level_.n_cells()); }
    Index n_sides() const { return level_.n_faces; }
    RootKind KindOf(Index c) const { return level_.IsHex(c) ? RootKind::Hex : RootKind::Polyhedron; }
    std::span<const Index> Vertices(Index c) const { return level_.CellVertices(c); }
    std::span<const Index> Sides(Index c) const { return level_.CellFaces(c); }
    std::span<const Index> SideVertices(Index side) const { return level_.FaceVertices(side); }
    template <class Body>
    void ForElementsAt(Index v, Body&& body) const {
        for (Index c : level_.vertex_cells[v]) body(c);
    }
    bool IsSheet(Index face) const { return level_.NCells(face) == 0; }
    /// Of a hexahedron: whether they are the ends of an edge.
    bool AreAcross(Index c, Index v, Index w) const {
        if (!level_.IsHex(c)) return false;
        const auto h = Vertices(c);
        const auto place = [&](Index x) { return static_cast<int>(std::find(h.begin(), h.end(), x) - h.begin()); };
        return Sdc::Hex::Distance(place(v), place(w)) == 1;
    }

  private:
    const Vtr::PolyhedralLevel& level_;
};

/// Whether the boundary at a vertex of a solid does not know all that its rules ask for: solids that touch, sheets.
template <class AnyLevel>
bool IsPinched(const AnyLevel& level, Index v) {
    if (!level.vertex_tags[v].in_cell()) return false;
    const auto edges = level.vertex_edges[v];
    return level.vertex_tags[v].non_manifold() || std::any_of(edges.begin(), edges.end(), [&](Index e) {
               return level.edge_tags[e].rule() == Vtr::Rule::Curve;
           });
}

/// Boundary faces of any level, which meet in edges.
template <class AnyLevel>
class BoundaryFaces {
  public:
    static constexpr bool kAreFaces = true;

    explicit BoundaryFaces(const AnyLevel& level) : level_(level) {
        at_offsets_.assign(static_cast<std::size_t>(level.n_vertices) + 1, 0);
        for (Index v : level.boundary_vertices) ++at_offsets_[static_cast<std::size_t>(v) + 1];
        std::partial_sum(at_offsets_.begin(), at_offsets_.end(), at_offsets_.begin());
        at_.resize(level.boundary_vertices.size());
        std::vector<Offset> next(at_offsets_.begin(), at_offsets_.end() - 1);
        for (Index b = 0; b < size(); ++b) {
            for (Index v : Vertices(b)) at_[static_cast<std::size_t>(next[static_cast<std::size_t>(v)]++)] = b;
        }
    }

    const AnyLevel& level() const { return level_; }
    Index size() const { return level_.n_boundary_faces; }
    Index n_sides() const { return level_.n_edges; }
    RootKind KindOf(Index) const { return RootKind::Face; }
    std::span<const Index> Vertices(Index b) const { return level_.BoundaryVertices(b); }
    std::span<const Index> Sides(Index b) const { return level_.FaceEdges(level_.boundary_faces[b]); }
    std::span<const Index> SideVertices(Index side) const { return level_.EdgeVertices(side); }
    template <class Body>
    void ForElementsAt(Index v, Body&& body) const {
        for (Offset i = at_offsets_[static_cast<std::size_t>(v)]; i < at_offsets_[static_cast<std::size_t>(v) + 1];
             ++i) {
            body(at_[static_cast<std::size_t>(i)]);
        }
    }
    bool IsSheet(Index) const { return false; }
    bool AreAcross(Index b, Index v, Index w) const {
        const auto corners = Vertices(b);
        const std::size_t n = corners.size();
        for (std::size_t i = 0; i < n; ++i) {
            if (corners[i] == v) return corners[(i + 1) % n] == w || corners[(i + n - 1) % n] == w;
        }
        return false;
    }

  private:
    const AnyLevel& level_;
    std::vector<Offset> at_offsets_;
    std::vector<Index> at_;
};

}  // namespace SolidSubdiv::Far::Internal
