// SPDX-License-Identifier: Apache-2.0
// Links of vertices and edges of level 0, and the rules that follow from them.
#include <solidsubdiv/vtr/internal/vertex_rules.h>

#include <algorithm>
#include <numeric>
#include <vector>

#include <solidsubdiv/sdc/parallel.h>

namespace SolidSubdiv::Vtr::Internal {

namespace {

constexpr Offset kGrain = 1024;

/// Cells around one vertex or edge: tets count from 0, octs follow them.
struct CellRings {
    Relation vertex_tets;
    Relation edge_tets;
};

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

Tag TagOfEdge(const Level& level, const CellRings& rings, Index e) {
    const int n_cells = rings.edge_tets.Count(e) + level.edge_octs.Count(e);
    int boundary = 0, sheets = 0, inner = 0;
    for (Index f : level.edge_faces[e]) {
        const int n = level.face_tags[f].n_cells();
        boundary += n == 1;
        sheets += n == 0;
        inner += n == 2;
    }
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
    VertexTagger(const Level& level, const CellRings& rings) : level_(level), rings_(rings) {}

    Tag TagOf(Index v) {
        bool in_cell = false, in_face = false, all_edges_in_dimension = true, sheets = false;
        const auto edges = level_.vertex_edges[v];
        for (Index e : edges) {
            in_cell |= level_.edge_tags[e].in_cell();
            in_face |= level_.edge_tags[e].in_face();
        }
        for (Index e : edges) {
            const Tag tag = level_.edge_tags[e];
            all_edges_in_dimension &= in_cell ? tag.in_cell() : in_face ? tag.in_face() : true;
            for (Index f : level_.edge_faces[e]) sheets |= level_.face_tags[f].n_cells() == 0;
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
    std::size_t CountCells(Index v) const { return rings_.vertex_tets[v].size() + level_.vertex_octs[v].size(); }

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
        const auto tets = rings_.vertex_tets[v];
        const auto octs = level_.vertex_octs[v];
        int link_vertices = 0, link_edges = 0, border = 0;
        faces_.clear();
        const auto add_faces = [&](std::size_t cell, std::span<const Index> faces) {
            for (Index f : faces) {
                const auto fv = level_.FaceVertices(f);
                if (fv[0] == v || fv[1] == v || fv[2] == v) faces_.push_back({f, cell});
            }
        };
        for (std::size_t i = 0; i < tets.size(); ++i) add_faces(i, level_.TetFaces(tets[i]));
        for (std::size_t i = 0; i < octs.size(); ++i) add_faces(tets.size() + i, level_.OctFaces(octs[i]));
        std::sort(faces_.begin(), faces_.end());
        sets_.Reset(tets.size() + octs.size());
        for (std::size_t i = 0; i < faces_.size(); ++i) {
            if (i > 0 && faces_[i].face == faces_[i - 1].face) {
                sets_.Join(faces_[i].cell, faces_[i - 1].cell);
            } else {
                ++link_edges;
                border += level_.face_tags[faces_[i].face].n_cells() == 1;
            }
        }
        for (Index e : level_.vertex_edges[v]) {
            const Tag tag = level_.edge_tags[e];
            if (!tag.in_cell()) continue;
            ++link_vertices;
            int boundary = 0;
            for (Index f : level_.edge_faces[e]) boundary += level_.face_tags[f].n_cells() == 1;
            if (boundary != 0 && boundary != 2) return false;
        }
        inside = border == 0;
        const int euler = link_vertices - link_edges + static_cast<int>(tets.size() + octs.size());
        return sets_.n_sets() == 1 && euler == (inside ? 2 : 1);
    }

    /// Faces at v in no cell: the number of border edges if they form one fan (0 or 2), otherwise -1.
    int SurfaceBorders(Index v) {
        int borders = 0;
        faces_.clear();
        for (Index e : level_.vertex_edges[v]) {
            const auto faces = level_.edge_faces[e];
            if (faces.size() > 2) return -1;
            borders += faces.size() == 1;
            for (Index f : faces) faces_.push_back({f, static_cast<std::size_t>(e)});
        }
        // Each face at v meets two of its edges; join faces through edges by joining edges through faces.
        std::sort(faces_.begin(), faces_.end());
        std::vector<std::size_t> edges;
        for (const Side& s : faces_) edges.push_back(s.cell);
        std::sort(edges.begin(), edges.end());
        edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
        sets_.Reset(edges.size());
        const auto place = [&](std::size_t e) {
            return static_cast<std::size_t>(std::lower_bound(edges.begin(), edges.end(), e) - edges.begin());
        };
        for (std::size_t i = 1; i < faces_.size(); ++i) {
            if (faces_[i].face == faces_[i - 1].face) sets_.Join(place(faces_[i].cell), place(faces_[i - 1].cell));
        }
        return sets_.n_sets() == 1 && borders <= 2 ? borders : -1;
    }

    struct Side {
        Index face;
        std::size_t cell;
        bool operator<(const Side& other) const { return face != other.face ? face < other.face : cell < other.cell; }
    };

    const Level& level_;
    const CellRings& rings_;
    std::vector<Side> faces_;
    Sets sets_;
};

}  // namespace

void TagEdgesAndVertices(Level& level) {
    const CellRings rings{Invert(level.tet_vertices, 4, level.n_vertices, false),
                          Invert(level.tet_edges, 6, level.n_edges, false)};
    level.edge_tags.resize(level.n_edges);
    level.vertex_tags.resize(level.n_vertices);
    Sdc::ParallelFor(level.n_edges, kGrain, [&](Offset begin, Offset end) {
        for (Offset e = begin; e < end; ++e) level.edge_tags[e] = TagOfEdge(level, rings, static_cast<Index>(e));
    });
    Sdc::ParallelFor(level.n_vertices, kGrain, [&](Offset begin, Offset end) {
        VertexTagger tagger(level, rings);
        for (Offset v = begin; v < end; ++v) level.vertex_tags[v] = tagger.TagOf(static_cast<Index>(v));
    });
}

}  // namespace SolidSubdiv::Vtr::Internal
