// SPDX-License-Identifier: Apache-2.0
// Links of vertices and edges of level 0, and the rules that follow from them.
#include <solidsubdiv/vtr/internal/vertex_rules.h>

#include <algorithm>
#include <numeric>
#include <vector>

#include <solidsubdiv/sdc/parallel.h>
#include <solidsubdiv/vtr/short_map.h>

namespace SolidSubdiv::Vtr::Internal {

namespace {

constexpr Offset kGrain = 1024;

/// Disjoint sets of small numbers.
class Sets {
  public:
    void Reset(std::size_t n) {
        parent_.resize(n);
        std::iota(parent_.begin(), parent_.end(), 0);
        n_sets_ = n;
    }
    std::size_t Find(std::size_t i) {
        while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
        return i;
    }
    void Join(std::size_t i, std::size_t j) {
        i = Find(i);
        j = Find(j);
        if (i != j) {
            parent_[i] = j;
            --n_sets_;
        }
    }
    std::size_t n_sets() const { return n_sets_; }

  private:
    std::vector<std::size_t> parent_;
    std::size_t n_sets_ = 0;
};

Tag TagOfEdge(const Level& level, Index e) {
    int boundary = 0, sheets = 0, inner = 0;
    for (Index f : level.edge_faces[e]) {
        const int n = level.face_tags[f].n_cells();
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

class VertexTagger {
  public:
    VertexTagger(const Level& level, const Relation& vertex_tets) : level_(level), vertex_tets_(vertex_tets) {}

    Tag TagOf(Index v) {
        const auto edges = level_.vertex_edges[v];
        int some = 0, all = Tag::kInCell | Tag::kInFace;  // what some edge has, what all edges have
        for (Index e : edges) {
            some |= level_.edge_tags[e].bits;
            all &= level_.edge_tags[e].bits;
        }
        const bool in_cell = some & Tag::kInCell, in_face = some & Tag::kInFace;
        const bool all_edges_in_dimension = in_cell ? all & Tag::kInCell : in_face ? all & Tag::kInFace : true;
        bool sheets = false;
        for (std::size_t i = 0; in_cell && i < edges.size(); ++i) {
            for (Index f : level_.edge_faces[edges[i]]) sheets |= level_.face_tags[f].n_cells() == 0;
        }
        int flags = (in_cell ? Tag::kInCell : 0) | (in_face ? Tag::kInFace : 0);
        if (in_cell && CountCells(v) == 1) flags |= Tag::kOneCell;

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
    std::size_t CountCells(Index v) const { return vertex_tets_[v].size() + level_.vertex_octs[v].size(); }

    /// Two creases of the governing dimension make a crease, any other number a corner.
    Rule RuleOfCreases(Index v, bool in_cell, bool in_face) const {
        int creases = 0;
        for (Index e : level_.vertex_edges[v]) {
            const Tag tag = level_.edge_tags[e];
            if (tag.rule() == Rule::Curve && (!in_cell || tag.in_cell()) && (!in_face || tag.in_face())) ++creases;
        }
        return creases == 2 ? Rule::Curve : Rule::Corner;
    }

    /// The cells at v cut its link into triangles and quads; manifold means that this is a sphere (inside) or a disc.
    bool SolidIsManifold(Index v, bool& inside) {
        const auto tets = vertex_tets_[v];
        const auto octs = level_.vertex_octs[v];
        int link_vertices = 0, link_edges = 0, border = 0;
        const std::size_t n_cells = tets.size() + octs.size();
        sets_.Reset(n_cells);
        cell_of_face_.Start(4 * n_cells);  // as many faces of an octahedron meet in a vertex
        const auto add_faces = [&](std::size_t cell, std::span<const Index> faces) {
            for (Index f : faces) {
                const auto fv = level_.FaceVertices(f);
                if (fv[0] != v && fv[1] != v && fv[2] != v) continue;
                const std::size_t other = static_cast<std::size_t>(cell_of_face_.Note(f, static_cast<Index>(cell)));
                if (other != cell) {
                    sets_.Join(other, cell);
                    continue;
                }
                ++link_edges;
                border += level_.face_tags[f].n_cells() == 1;
            }
        };
        for (std::size_t i = 0; i < tets.size(); ++i) add_faces(i, level_.TetFaces(tets[i]));
        for (std::size_t i = 0; i < octs.size(); ++i) add_faces(tets.size() + i, level_.OctFaces(octs[i]));
        for (Index e : level_.vertex_edges[v]) {
            const Tag tag = level_.edge_tags[e];
            if (!tag.in_cell()) continue;
            ++link_vertices;
            int boundary = 0;
            for (Index f : level_.edge_faces[e]) boundary += level_.face_tags[f].n_cells() == 1;
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
        for (Index e : level_.vertex_edges[v]) {
            const int n = level_.edge_faces.Count(e);
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
            const auto faces = level_.edge_faces[e];
            if (faces.size() == 1 && n_met > 1) break;
            f = faces[0] != f ? faces[0] : faces[1];
            e = OtherEdgeAt(v, f, e);
        } while (e != start);
        return n_met == n_edges ? borders : -1;
    }
    /// The edge of f at v that is not e.
    Index OtherEdgeAt(Index v, Index f, Index e) const {
        const auto vertices = level_.FaceVertices(f);
        const auto edges = level_.FaceEdges(f);
        const Index opposite = edges[vertices[0] == v ? 0 : vertices[1] == v ? 1 : 2];
        return edges[0] + edges[1] + edges[2] - opposite - e;
    }

    const Level& level_;
    const Relation& vertex_tets_;
    ShortMap cell_of_face_;
    Sets sets_;
};

}  // namespace

void TagEdgesAndVertices(Level& level) {
    const Relation vertex_tets = Invert(level.tet_vertices, 4, level.n_vertices, false);
    level.edge_tags.resize(level.n_edges);
    level.vertex_tags.resize(level.n_vertices);
    Sdc::ParallelFor(level.n_edges, kGrain, [&](Offset begin, Offset end) {
        for (Offset e = begin; e < end; ++e) level.edge_tags[e] = TagOfEdge(level, static_cast<Index>(e));
    });
    Sdc::ParallelFor(level.n_vertices, kGrain, [&](Offset begin, Offset end) {
        VertexTagger tagger(level, vertex_tets);
        for (Offset v = begin; v < end; ++v) level.vertex_tags[v] = tagger.TagOf(static_cast<Index>(v));
    });
}

}  // namespace SolidSubdiv::Vtr::Internal
