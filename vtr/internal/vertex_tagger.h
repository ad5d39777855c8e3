// SPDX-License-Identifier: Apache-2.0
// Links of vertices and edges of level 0, and the rules that follow from them, for complexes of any cells.
//
// A Complex answers: vertex_edges(), edge_faces(), edge_tags(); NCells(f), the cells of a face; NCellsAt(v);
// ForCellFacesAt(v, on_face), which calls on_face(i, f) for each face at v of the i-th cell at v, MaxCellFacesAt(v)
// times at most; OtherEdgeAt(v, f, e), the other edge of f at v.
#pragma once

#include <solidsubdiv/sdc/disjoint_sets.h>
#include <solidsubdiv/sdc/parallel.h>
#include <solidsubdiv/vtr/relation.h>
#include <solidsubdiv/vtr/short_map.h>
#include <solidsubdiv/vtr/tags.h>

namespace SolidSubdiv::Vtr::Internal {

template <class Complex>
Tag TagOfEdge(const Complex& complex, Index e) {
    int boundary = 0, sheets = 0, inner = 0;
    for (Index f : complex.edge_faces()[e]) {
        const int n = complex.NCells(f);
        boundary += n == 1;
        sheets += n == 0;
        inner += n == 2;
    }
    const int n_cells = (2 * inner + boundary) / 2;  // each has two faces at the edge
    int flags = 0;
    if (n_cells > 0) flags |= Tag::kInCell;
    if (boundary + sheets + inner > 0) flags |= Tag::kInFace;
    if (n_cells == 1) flags |= Tag::kOneCell;
    if (n_cells > 0 && boundary == 2) flags |= Tag::kHalfBall;

    Rule rule = Rule::Curve;
    if (n_cells > 0 && boundary == 0) {
        rule = Rule::Solid;
    } else if (boundary + sheets == 2) {
        rule = Rule::Surface;
    }
    const bool fan_of_cells = n_cells > 0 && sheets == 0 && boundary <= 2;
    const bool plain_sheet = n_cells == 0 && sheets <= 2;
    if (!fan_of_cells && !plain_sheet) flags |= Tag::kNonManifold;
    return MakeTag(rule, flags);
}

template <class Complex>
class VertexTagger {
  public:
    explicit VertexTagger(const Complex& complex) : complex_(complex) {}

    Tag TagOf(Index v) {
        const auto edges = complex_.vertex_edges()[v];
        int some = 0, all = Tag::kInCell | Tag::kInFace;  // what some edge has, what all edges have
        for (Index e : edges) {
            some |= complex_.edge_tags()[e].bits;
            all &= complex_.edge_tags()[e].bits;
        }
        const bool in_cell = some & Tag::kInCell, in_face = some & Tag::kInFace;
        const bool all_edges_in_dimension = in_cell ? all & Tag::kInCell : in_face ? all & Tag::kInFace : true;
        bool sheets = false;
        for (std::size_t i = 0; in_cell && i < edges.size(); ++i) {
            for (Index f : complex_.edge_faces()[edges[i]]) sheets |= complex_.NCells(f) == 0;
        }
        int flags = (in_cell ? Tag::kInCell : 0) | (in_face ? Tag::kInFace : 0);
        if (in_cell && complex_.NCellsAt(v) == 1) flags |= Tag::kOneCell;

        bool manifold;
        Rule rule;
        if (in_cell) {
            bool inside = false;
            manifold = SolidIsManifold(v, inside);
            rule = manifold ? (inside ? Rule::Solid : Rule::Surface) : RuleOfCreases(v, in_cell, in_face);
            manifold = manifold && !sheets && all_edges_in_dimension;
        } else if (in_face) {
            const int borders = SurfaceBorders(v);  // -1: not one fan
            rule = borders == 0 ? Rule::Surface : RuleOfCreases(v, in_cell, in_face);
            manifold = borders >= 0 && all_edges_in_dimension;
        } else {
            rule = RuleOfCreases(v, in_cell, in_face);
            manifold = edges.size() <= 2;
        }
        if (!manifold) flags |= Tag::kNonManifold;
        return MakeTag(rule, flags);
    }

  private:
    /// Two creases of the governing dimension make a crease, any other number a corner.
    Rule RuleOfCreases(Index v, bool in_cell, bool in_face) const {
        int creases = 0;
        for (Index e : complex_.vertex_edges()[v]) {
            const Tag tag = complex_.edge_tags()[e];
            if (tag.rule() == Rule::Curve && (!in_cell || tag.in_cell()) && (!in_face || tag.in_face())) ++creases;
        }
        return creases == 2 ? Rule::Curve : Rule::Corner;
    }

    /// The cells at v cut its link into polygons; manifold means that this is a sphere (inside) or a disc.
    bool SolidIsManifold(Index v, bool& inside) {
        const std::size_t n_cells = complex_.NCellsAt(v);
        int link_vertices = 0, link_edges = 0, border = 0;
        sets_.Reset(n_cells);
        cell_of_face_.Start(complex_.MaxCellFacesAt(v));
        complex_.ForCellFacesAt(v, [&](std::size_t cell, Index f) {
            const std::size_t other = static_cast<std::size_t>(cell_of_face_.Note(f, static_cast<Index>(cell)));
            if (other != cell) {
                sets_.Unite(other, cell);
                return;
            }
            ++link_edges;
            border += complex_.NCells(f) == 1;
        });
        for (Index e : complex_.vertex_edges()[v]) {
            const Tag tag = complex_.edge_tags()[e];
            if (!tag.in_cell()) continue;
            ++link_vertices;
            int boundary = 0;
            for (Index f : complex_.edge_faces()[e]) boundary += complex_.NCells(f) == 1;
            if (boundary != 0 && boundary != 2) return false;
        }
        inside = border == 0;
        const int euler = link_vertices - link_edges + static_cast<int>(n_cells);
        return sets_.n_sets() == 1 && euler == (inside ? 2 : 1);
    }

    /// Faces at v in no cell: the number of border edges if they form one fan (0 or 2), otherwise -1.
    int SurfaceBorders(Index v) const {
        int borders = 0, n_edges = 0;
        Index start = kNoIndex;
        for (Index e : complex_.vertex_edges()[v]) {
            const int n = complex_.edge_faces().Count(e);
            if (n > 2) return -1;
            borders += n == 1;
            n_edges += n > 0;
            if (n == 1 || (n == 2 && start == kNoIndex)) start = e;
        }
        if (borders != 0 && borders != 2) return -1;
        // Around v from face to face: a fan comes to its other border, or back, after all edges.
        int n_met = 0;
        Index e = start, f = kNoIndex;
        do {
            ++n_met;
            const auto faces = complex_.edge_faces()[e];
            if (faces.size() == 1 && n_met > 1) break;
            f = faces[0] != f ? faces[0] : faces[1];
            e = complex_.OtherEdgeAt(v, f, e);
        } while (e != start);
        return n_met == n_edges ? borders : -1;
    }
    const Complex& complex_;
    Vtr::ShortMap cell_of_face_;
    Sdc::DisjointSets sets_;
};

/// Fills edge_tags and vertex_tags; the complex sees edge_tags. Source: rules.md section 7 (chang2003interpolatory).
template <class Complex>
void TagEdgesAndVertices(const Complex& complex, Array<Tag>& edge_tags, Array<Tag>& vertex_tags) {
    constexpr Offset kGrain = 1024;
    Sdc::ParallelFor(static_cast<Offset>(edge_tags.size()), kGrain, [&](Offset begin, Offset end) {
        for (Offset e = begin; e < end; ++e) edge_tags[e] = TagOfEdge(complex, static_cast<Index>(e));
    });
    Sdc::ParallelFor(static_cast<Offset>(vertex_tags.size()), kGrain, [&](Offset begin, Offset end) {
        VertexTagger tagger(complex);
        for (Offset v = begin; v < end; ++v) vertex_tags[v] = tagger.TagOf(static_cast<Index>(v));
    });
}

}  // namespace SolidSubdiv::Vtr::Internal
