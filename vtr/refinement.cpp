// SPDX-License-Identifier: Apache-2.0
// The uniform split: see refinement.h for the numbering.
#include <solidsubdiv/vtr/refinement.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <limits>
#include <tuple>

#include <solidsubdiv/sdc/cell_split.h>
#include <solidsubdiv/sdc/parallel.h>
#include <solidsubdiv/vtr/internal/child_numbers.h>
#include <solidsubdiv/vtr/internal/child_relations.h>

namespace SolidSubdiv::Vtr {

namespace {

constexpr Offset kGrain = 4096;

using Sdc::CellSplit;
using Sdc::Oct;
using Sdc::Tet;

/// A face's three points with the edges opposite to them.
struct Corners {
    std::array<Index, 3> vertices;
    std::array<Index, 3> edges;

    void Sort() {
        // Without a branch: the order is anybody's guess.
        const auto order = [&](int i, int j) {
            const bool swap = vertices[i] > vertices[j];
            const Index edge = edges[i];
            std::tie(vertices[i], vertices[j]) = std::minmax({vertices[i], vertices[j]});
            edges[i] = swap ? edges[j] : edge;
            edges[j] = swap ? edge : edges[j];
        };
        order(0, 1);
        order(1, 2);
        order(0, 1);
    }
};

class Splitter {
  public:
    Splitter(const Level& parent, Level& child) : parent_(parent), child_(child), first_(parent) {
        const Counts counts = Refine(CountsOf(parent));
        assert(counts.Largest() <= std::numeric_limits<Index>::max());
        child.n_vertices = static_cast<Index>(counts.n_vertices);
        child.n_edges = static_cast<Index>(counts.n_edges);
        child.n_faces = static_cast<Index>(counts.n_faces);
        child.n_tets = static_cast<Index>(counts.n_tets);
        child.n_octs = static_cast<Index>(counts.n_octs);
        child.n_boundary_faces = static_cast<Index>(counts.n_boundary_faces);
    }

    void SplitBoundary(bool full) {
        child_.boundary_vertices.resize(3 * static_cast<std::size_t>(child_.n_boundary_faces));
        if (full) child_.boundary_faces.resize(child_.n_boundary_faces);
        Sdc::ParallelFor(parent_.n_boundary_faces, kGrain, [&](Offset begin, Offset end) {
            for (Offset b = begin; b < end; ++b) SplitBoundaryFace(static_cast<Index>(b), full);
        });
    }

    void SplitCells(bool full) {
        child_.tet_vertices.resize(4 * static_cast<std::size_t>(child_.n_tets));
        child_.oct_vertices.resize(6 * static_cast<std::size_t>(child_.n_octs));
        if (full) {
            child_.tet_edges.resize(6 * static_cast<std::size_t>(child_.n_tets));
            child_.tet_faces.resize(4 * static_cast<std::size_t>(child_.n_tets));
            child_.oct_edges.resize(12 * static_cast<std::size_t>(child_.n_octs));
            child_.oct_faces.resize(8 * static_cast<std::size_t>(child_.n_octs));
        }
        Sdc::ParallelFor(parent_.n_tets, kGrain / 4, [&](Offset begin, Offset end) {
            for (Offset t = begin; t < end; ++t) SplitCell<Tet>(static_cast<Index>(t), full);
        });
        Sdc::ParallelFor(parent_.n_octs, kGrain / 8, [&](Offset begin, Offset end) {
            for (Offset o = begin; o < end; ++o) SplitCell<Oct>(static_cast<Index>(o), full);
        });
    }

    void SplitFaces() {
        child_.face_vertices.resize(3 * static_cast<std::size_t>(child_.n_faces));
        child_.face_edges.resize(3 * static_cast<std::size_t>(child_.n_faces));
        child_.face_tags.resize(child_.n_faces);
        Sdc::ParallelFor(parent_.n_faces, kGrain, [&](Offset begin, Offset end) {
            for (Offset f = begin; f < end; ++f) SplitFace(static_cast<Index>(f));
        });
        Sdc::ParallelFor(parent_.n_tets, kGrain / 4, [&](Offset begin, Offset end) {
            for (Offset t = begin; t < end; ++t) MakeInnerFaces<Tet>(static_cast<Index>(t));
        });
        Sdc::ParallelFor(parent_.n_octs, kGrain / 8, [&](Offset begin, Offset end) {
            for (Offset o = begin; o < end; ++o) MakeInnerFaces<Oct>(static_cast<Index>(o));
        });
    }

    void SplitEdges() {
        child_.edge_vertices.resize(2 * static_cast<std::size_t>(child_.n_edges));
        child_.edge_tags.resize(child_.n_edges);
        Sdc::ParallelFor(parent_.n_edges, kGrain, [&](Offset begin, Offset end) {
            for (Offset e = begin; e < end; ++e) {
                const auto ends = parent_.EdgeVertices(static_cast<Index>(e));
                for (int s = 0; s < 2; ++s) {
                    SetEdge(static_cast<Index>(2 * e + s), ends[s], EdgePoint(static_cast<Index>(e)),
                            parent_.edge_tags[e]);
                }
            }
        });
        Sdc::ParallelFor(parent_.n_faces, kGrain, [&](Offset begin, Offset end) {
            for (Offset f = begin; f < end; ++f) {
                const auto edges = parent_.FaceEdges(static_cast<Index>(f));
                const Tag tag = TagOfFaceEdge(parent_.face_tags[f]);
                for (int k = 0; k < 3; ++k) {
                    const Index p = EdgePoint(edges[(k + 1) % 3]), q = EdgePoint(edges[(k + 2) % 3]);
                    SetEdge(static_cast<Index>(first_.face_edge + 3 * f + k), std::min(p, q), std::max(p, q), tag);
                }
            }
        });
        Sdc::ParallelFor(parent_.n_octs, kGrain / 4, [&](Offset begin, Offset end) {
            for (Offset o = begin; o < end; ++o) {
                const auto edges = parent_.OctEdges(static_cast<Index>(o));
                for (int i = 0; i < Oct::kEdges; ++i) {
                    SetEdge(static_cast<Index>(first_.oct_edge + Oct::kEdges * o + i), EdgePoint(edges[i]),
                            static_cast<Index>(first_.centre + o), TagInsideCell());
                }
            }
        });
    }

    void TagVertices() {
        child_.vertex_tags.resize(child_.n_vertices);
        std::copy(parent_.vertex_tags.begin(), parent_.vertex_tags.end(), child_.vertex_tags.begin());
        Sdc::ParallelFor(parent_.n_edges, kGrain, [&](Offset begin, Offset end) {
            for (Offset e = begin; e < end; ++e)
                child_.vertex_tags[first_.edge_point + e] = TagOfEdgePoint(parent_.edge_tags[e]);
        });
        std::fill(child_.vertex_tags.begin() + first_.centre, child_.vertex_tags.end(), TagInsideCell());
    }

  private:
    Index EdgePoint(Index edge) const { return first_.edge_point + edge; }

    void SetEdge(Index e, Index low, Index high, Tag tag) {
        child_.edge_vertices[2 * static_cast<std::size_t>(e)] = low;
        child_.edge_vertices[2 * static_cast<std::size_t>(e) + 1] = high;
        child_.edge_tags[e] = tag;
    }

    void SetFace(Index f, Corners corners, FaceTag tag) {
        corners.Sort();
        const std::size_t at = 3 * static_cast<std::size_t>(f);
        for (int k = 0; k < 3; ++k) {
            child_.face_vertices[at + k] = corners.vertices[k];
            child_.face_edges[at + k] = corners.edges[k];
        }
        child_.face_tags[f] = tag;
    }

    void SplitFace(Index f) {
        const auto v = parent_.FaceVertices(f);
        const auto e = parent_.FaceEdges(f);
        const FaceTag tag = parent_.face_tags[f];
        Corners middle;
        for (int k = 0; k < 3; ++k) {
            // At corner k meet the edges opposite the other two corners i and j.
            const int i = (k + 1) % 3, j = (k + 2) % 3;
            const Index across = first_.face_edge + 3 * f + k;
            const Index half_i = 2 * e[i] + (v[k] > v[j]), half_j = 2 * e[j] + (v[k] > v[i]);
            SetFace(4 * f + k, {{v[k], EdgePoint(e[i]), EdgePoint(e[j])}, {across, half_j, half_i}}, tag);
            middle.vertices[k] = EdgePoint(e[k]);
            middle.edges[k] = across;
        }
        SetFace(4 * f + 3, middle, TagOfMiddleFace(tag));
    }

    void SplitBoundaryFace(Index b, bool full) {
        const auto v = parent_.BoundaryVertices(b);  // outward
        const Index f = parent_.boundary_faces[b];
        const auto e = parent_.FaceEdges(f);
        const std::size_t over1 = v[0] > v[1], over2 = v[1] > v[2], over0 = v[2] > v[0];
        // Of v[k]: its place in ascending order. Of the edge opposite v[k]: the point on it.
        const std::array<std::size_t, 3> rank{over1 + 1 - over0, over2 + 1 - over1, over0 + 1 - over2};
        const std::array<Index, 3> mid{EdgePoint(e[rank[0]]), EdgePoint(e[rank[1]]), EdgePoint(e[rank[2]])};
        Index* const children = child_.boundary_vertices.data() + 12 * static_cast<std::size_t>(b);
        const auto set = [&](std::size_t r, Index p, Index q, Index s) {
            Index* const corners = children + 3 * r;
            corners[0] = p;
            corners[1] = q;
            corners[2] = s;
        };
        for (int k = 0; k < 3; ++k) set(rank[k], v[k], mid[(k + 2) % 3], mid[(k + 1) % 3]);
        set(3, mid[0], mid[1], mid[2]);
        if (!full) return;
        for (Index r = 0; r < 4; ++r) child_.boundary_faces[4 * static_cast<std::size_t>(b) + r] = 4 * f + r;
    }

    template <class Cell>
    auto Vertices(Index c) const {
        if constexpr (Cell::kVertices == 4)
            return parent_.TetVertices(c);
        else
            return parent_.OctVertices(c);
    }
    template <class Cell>
    auto Edges(Index c) const {
        if constexpr (Cell::kVertices == 4)
            return parent_.TetEdges(c);
        else
            return parent_.OctEdges(c);
    }
    template <class Cell>
    auto Faces(Index c) const {
        if constexpr (Cell::kVertices == 4)
            return parent_.TetFaces(c);
        else
            return parent_.OctFaces(c);
    }

    template <class Cell>
    void GatherPoints(Index c, Index* points) const {
        const auto v = Vertices<Cell>(c);
        const auto e = Edges<Cell>(c);
        for (int i = 0; i < Cell::kVertices; ++i) points[i] = v[i];
        for (int i = 0; i < Cell::kEdges; ++i) points[Cell::kVertices + i] = EdgePoint(e[i]);
        if constexpr (CellSplit<Cell>::kIsOct) points[CellSplit<Cell>::kCentre] = first_.centre + c;
    }

    /// Numbers of the child edges of cell c, in the order of CellSplit::edge_points.
    template <class Cell>
    void GatherChildEdges(Index c, Index* child_edges) const {
        const auto v = Vertices<Cell>(c);
        const auto e = Edges<Cell>(c);
        const auto f = Faces<Cell>(c);
        for (int i = 0; i < Cell::kEdges; ++i) {
            const Index low_first = v[Cell::edges[i][0]] > v[Cell::edges[i][1]];
            child_edges[2 * i] = 2 * e[i] + low_first;
            child_edges[2 * i + 1] = 2 * e[i] + 1 - low_first;
        }
        for (int i = 0; i < Cell::kFaces; ++i) {
            for (int k = 0; k < 3; ++k) {
                child_edges[2 * Cell::kEdges + 3 * i + k] = first_.face_edge + 3 * f[i] + CornerRank<Cell>(v, i, k);
            }
        }
        for (int i = 0; i < CellSplit<Cell>::kInnerEdges; ++i) {
            child_edges[CellSplit<Cell>::kFirstInnerEdge + i] = first_.oct_edge + Oct::kEdges * c + i;
        }
    }

    /// Place of corner k of local face i among the face's vertices in ascending order.
    template <class Cell, class Row>
    static Index CornerRank(const Row& v, int i, int k) {
        const auto& corners = Cell::faces[i];
        const Index mine = v[corners[k]];
        return (mine > v[corners[(k + 1) % 3]]) + (mine > v[corners[(k + 2) % 3]]);
    }

    template <class Cell>
    Index InnerFace(Index c) const {
        return CellSplit<Cell>::kIsOct ? first_.oct_face + CellSplit<Oct>::kInnerFaces * c
                                       : first_.tet_face + CellSplit<Tet>::kInnerFaces * c;
    }

    template <class Cell>
    void SplitCell(Index c, bool full) {
        constexpr const CellSplit<Cell>& split = Sdc::SplitOf<Cell>();
        constexpr bool is_oct = CellSplit<Cell>::kIsOct;
        const std::size_t first_tet =
            is_oct ? 4 * static_cast<std::size_t>(parent_.n_tets) + 8 * static_cast<std::size_t>(c)
                   : 4 * static_cast<std::size_t>(c);
        const std::size_t first_oct = is_oct
                                          ? static_cast<std::size_t>(parent_.n_tets) + 6 * static_cast<std::size_t>(c)
                                          : static_cast<std::size_t>(c);

        std::array<Index, CellSplit<Cell>::kPoints> points;
        GatherPoints<Cell>(c, points.data());
        Scatter(split.tets, points, child_.tet_vertices.data() + 4 * first_tet);
        Scatter(split.octs, points, child_.oct_vertices.data() + 6 * first_oct);
        if (!full) return;

        std::array<Index, CellSplit<Cell>::kChildEdges> edges;
        GatherChildEdges<Cell>(c, edges.data());
        Scatter(split.tet_edges, edges, child_.tet_edges.data() + 6 * first_tet);
        Scatter(split.oct_edges, edges, child_.oct_edges.data() + 12 * first_oct);

        std::array<Index, CellSplit<Cell>::kChildFaces> faces;
        const auto v = Vertices<Cell>(c);
        const auto f = Faces<Cell>(c);
        for (int i = 0; i < Cell::kFaces; ++i) {
            for (int k = 0; k < 3; ++k) faces[4 * i + k] = 4 * f[i] + CornerRank<Cell>(v, i, k);
            faces[4 * i + 3] = 4 * f[i] + 3;
        }
        for (int i = 0; i < CellSplit<Cell>::kInnerFaces; ++i) faces[4 * Cell::kFaces + i] = InnerFace<Cell>(c) + i;
        Scatter(split.tet_faces, faces, child_.tet_faces.data() + 4 * first_tet);
        Scatter(split.oct_faces, faces, child_.oct_faces.data() + 8 * first_oct);
    }

    /// Writes a table of local numbers row by row as the numbers they stand for.
    template <class Table, class Numbers>
    static void Scatter(const Table& table, const Numbers& numbers, Index* out) {
        for (const auto& row : table) {
            for (Sdc::Local local : row) *out++ = numbers[local];
        }
    }

    template <class Cell>
    void MakeInnerFaces(Index c) {
        constexpr const CellSplit<Cell>& split = Sdc::SplitOf<Cell>();
        std::array<Index, CellSplit<Cell>::kPoints> points;
        std::array<Index, CellSplit<Cell>::kChildEdges> edges;
        GatherPoints<Cell>(c, points.data());
        GatherChildEdges<Cell>(c, edges.data());
        for (int i = 0; i < CellSplit<Cell>::kInnerFaces; ++i) {
            const auto& p = split.face_points[CellSplit<Cell>::kFirstInnerFace + i];
            const auto& e = split.face_edges[CellSplit<Cell>::kFirstInnerFace + i];
            SetFace(InnerFace<Cell>(c) + i,
                    {{points[p[0]], points[p[1]], points[p[2]]}, {edges[e[0]], edges[e[1]], edges[e[2]]}},
                    MakeFaceTag(1, 1));
        }
    }

    const Level& parent_;
    Level& child_;
    const Internal::ChildNumbers first_;
};

}  // namespace

Offset Counts::Largest() const { return std::max({n_vertices, n_edges, n_faces, n_tets, n_octs, n_boundary_faces}); }

Counts CountsOf(const Level& level) {
    return {level.n_vertices, level.n_edges, level.n_faces, level.n_tets, level.n_octs, level.n_boundary_faces};
}

Counts Refine(const Counts& p) {
    return {p.n_vertices + p.n_edges + p.n_octs,
            2 * p.n_edges + 3 * p.n_faces + 12 * p.n_octs,
            4 * p.n_faces + 4 * p.n_tets + 24 * p.n_octs,
            4 * p.n_tets + 8 * p.n_octs,
            p.n_tets + 6 * p.n_octs,
            4 * p.n_boundary_faces};
}

Offset EstimateBytes(const Counts& c, bool full) {
    constexpr Offset index = sizeof(Index), offset = sizeof(Offset);
    Offset bytes = index * (4 * c.n_tets + 6 * c.n_octs + 3 * c.n_boundary_faces);
    if (full) {
        bytes += index * (10 * c.n_tets + 20 * c.n_octs + 6 * c.n_faces + 2 * c.n_edges + c.n_boundary_faces);
        bytes += c.n_vertices + c.n_edges + c.n_faces;
        const auto relation = [&](Offset n_rows, Offset n_items, Offset item_bytes) {
            return n_items == 0 ? 0 : offset * (n_rows + 1) + item_bytes * n_items;
        };
        bytes += relation(c.n_vertices, 2 * c.n_edges, index) + relation(c.n_vertices, 6 * c.n_octs, index + 1);
        bytes += relation(c.n_edges, 3 * c.n_faces, index) + relation(c.n_edges, 12 * c.n_octs, index + 1);
    }
    return bytes;
}

Level Refine(const Level& parent, bool full) {
    assert(parent.is_full);
    Level child;
    Splitter splitter(parent, child);
    splitter.SplitBoundary(full);
    splitter.SplitCells(full);
    if (full) {
        splitter.SplitFaces();
        splitter.SplitEdges();
        splitter.TagVertices();
        child.vertex_edges = Internal::ChildVertexEdges(parent);
        child.edge_faces = parent.n_cells() == 0 ? Internal::ChildEdgeFaces(parent)
                                                 : Invert(child.face_edges, 3, child.n_edges, false);
        child.vertex_octs = Invert(child.oct_vertices, 6, child.n_vertices, true);
        child.edge_octs = Invert(child.oct_edges, 12, child.n_edges, true);
        child.is_full = true;
    }
    return child;
}

}  // namespace SolidSubdiv::Vtr
