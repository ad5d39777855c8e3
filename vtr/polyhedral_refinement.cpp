// SPDX-License-Identifier: Apache-2.0
// The split of polyhedra: see polyhedral_refinement.h for the numbering.
#include <solidsubdiv/vtr/polyhedral_refinement.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <limits>

#include <solidsubdiv/sdc/hex_split.h>
#include <solidsubdiv/sdc/parallel.h>
#include <solidsubdiv/vtr/internal/odd_cells.h>
#include <solidsubdiv/vtr/internal/polyhedral_rules.h>

namespace SolidSubdiv::Vtr {

namespace {

constexpr Offset kGrain = 2048;

using Sdc::Hex;
using Sdc::HexSplit;
using Sdc::kHexSplit;

/// Where each group of children starts.
struct FirstNumbers {
    Index edge_point, face_point, cell_point;
    Index face_edge, cell_edge;  // in faces; in cells
    Index inner_face;

    explicit FirstNumbers(const PolyhedralLevel& p)
        : edge_point(p.n_vertices),
          face_point(edge_point + p.n_edges),
          cell_point(face_point + p.n_faces),
          face_edge(2 * p.n_edges),
          cell_edge(face_edge + static_cast<Index>(p.face_vertices.size())),
          inner_face(static_cast<Index>(p.face_vertices.size())) {}
};

class Splitter {
  public:
    Splitter(const PolyhedralLevel& parent, PolyhedralLevel& child)
        : parent_(parent), child_(child), odd_(parent), first_(parent) {
        const PolyhedralCounts counts = Refine(CountsOf(parent));
        assert(counts.Largest() <= std::numeric_limits<Index>::max());
        child.n_vertices = static_cast<Index>(counts.n_vertices);
        child.n_edges = static_cast<Index>(counts.n_edges);
        child.n_faces = static_cast<Index>(counts.n_faces);
        child.n_hexes = static_cast<Index>(counts.n_hexes);
        child.n_boundary_faces = static_cast<Index>(counts.n_boundary_faces);
    }

    void SplitCells(bool full) {
        child_.hex_vertices.resize(Hex::kVertices * static_cast<std::size_t>(child_.n_hexes));
        if (full) {
            child_.hex_edges.resize(Hex::kEdges * static_cast<std::size_t>(child_.n_hexes));
            child_.hex_faces.resize(Hex::kFaces * static_cast<std::size_t>(child_.n_hexes));
        }
        Sdc::ParallelFor(parent_.n_hexes, kGrain / 8, [&](Offset begin, Offset end) {
            for (Offset c = begin; c < end; ++c) SplitHex(static_cast<Index>(c), full);
        });
        odd_.MakeRoom(child_.polyhedra, full);
        Sdc::ParallelFor(parent_.n_polyhedra(), kGrain / 8, [&](Offset begin, Offset end) {
            for (Offset p = begin; p < end; ++p) SplitPolyhedron(static_cast<Index>(p), full);
        });
    }

    void SplitBoundary(bool full) {
        child_.boundary_vertices.resize(4 * static_cast<std::size_t>(child_.n_boundary_faces));
        if (full) child_.boundary_faces.resize(static_cast<std::size_t>(child_.n_boundary_faces));
        Sdc::ParallelFor(parent_.n_boundary_faces, kGrain, [&](Offset begin, Offset end) {
            for (Offset b = begin; b < end; ++b) {
                const Index f = parent_.boundary_faces[b];
                const Offset start = parent_.boundary_rows.Start(static_cast<Index>(b));
                for (int k = 0; k < parent_.face_rows.Count(f); ++k) {
                    const auto corners = CornerFace(f, k);
                    std::copy(corners.begin(), corners.end(), child_.boundary_vertices.begin() + 4 * (start + k));
                    if (full) child_.boundary_faces[start + k] = static_cast<Index>(parent_.face_rows.Start(f) + k);
                }
            }
        });
    }

    void SplitFaces() {
        child_.face_vertices.resize(4 * static_cast<std::size_t>(child_.n_faces));
        child_.face_edges.resize(4 * static_cast<std::size_t>(child_.n_faces));
        child_.face_cells.resize(2 * static_cast<std::size_t>(child_.n_faces));
        Sdc::ParallelFor(parent_.n_faces, kGrain, [&](Offset begin, Offset end) {
            for (Offset f = begin; f < end; ++f) SplitFace(static_cast<Index>(f));
        });
        Sdc::ParallelFor(parent_.n_hexes, kGrain / 4, [&](Offset begin, Offset end) {
            for (Offset c = begin; c < end; ++c) {
                for (int e = 0; e < Hex::kEdges; ++e) {
                    const auto [a, b] = Hex::edges[e];
                    const Index first = static_cast<Index>(Hex::kVertices * c);
                    InnerFace(static_cast<Index>(c), e, kHexSplit.sides[e][0], kHexSplit.sides[e][1], first + a,
                              first + b);
                }
            }
        });
        const Polyhedra& p = parent_.polyhedra;
        Sdc::ParallelFor(p.size(), kGrain / 4, [&](Offset begin, Offset end) {
            for (Offset i = begin; i < end; ++i) {
                const Index c = parent_.n_hexes + static_cast<Index>(i);
                const auto vertices = parent_.CellVertices(c);
                const auto edges = parent_.CellEdges(c);
                const Offset first = p.vertex_offsets[i];
                for (std::size_t corner = 0; corner < vertices.size(); ++corner) {
                    const Offset ring = p.ring_offsets[first + static_cast<Offset>(corner)];
                    const int n = odd_.Degree(first + static_cast<Offset>(corner));
                    for (int k = 0; k < n; ++k) {
                        const Index e = p.ring_edges[ring + k];
                        const Index other = parent_.OtherEnd(edges[static_cast<std::size_t>(e)], vertices[corner]);
                        const auto far = std::find(vertices.begin(), vertices.end(), other) - vertices.begin();
                        if (far < static_cast<std::ptrdiff_t>(corner)) continue;  // once, from its first end
                        InnerFace(c, e, p.ring_faces[ring + k], p.ring_faces[ring + (k + n - 1) % n],
                                  odd_.Child(first + static_cast<Offset>(corner)), odd_.Child(first + far));
                    }
                }
            }
        });
    }

    void SplitEdges() {
        child_.edge_vertices.resize(2 * static_cast<std::size_t>(child_.n_edges));
        child_.edge_tags.resize(static_cast<std::size_t>(child_.n_edges));
        Sdc::ParallelFor(parent_.n_edges, kGrain, [&](Offset begin, Offset end) {
            for (Offset e = begin; e < end; ++e) {
                const auto ends = parent_.EdgeVertices(static_cast<Index>(e));
                for (int s = 0; s < 2; ++s) {
                    SetEdge(2 * e + s, ends[s], EdgePoint(static_cast<Index>(e)), parent_.edge_tags[e]);
                }
            }
        });
        Sdc::ParallelFor(parent_.n_faces, kGrain, [&](Offset begin, Offset end) {
            for (Offset i = begin; i < end; ++i) {
                const Index f = static_cast<Index>(i);
                const auto edges = parent_.FaceEdges(f);
                const Tag tag = TagOfFaceEdge(MakeFaceTag(parent_.NCells(f), 0));
                for (std::size_t k = 0; k < edges.size(); ++k) {
                    SetEdge(first_.face_edge + parent_.face_rows.Start(f) + static_cast<Offset>(k), EdgePoint(edges[k]),
                            FacePoint(f), tag);
                }
            }
        });
        Sdc::ParallelFor(parent_.n_cells(), kGrain, [&](Offset begin, Offset end) {
            for (Offset i = begin; i < end; ++i) {
                const Index c = static_cast<Index>(i);
                const auto faces = parent_.CellFaces(c);
                for (std::size_t k = 0; k < faces.size(); ++k) {
                    SetEdge(CellEdge(c, static_cast<int>(k)), FacePoint(faces[k]), CellPoint(c), TagInsideCell());
                }
            }
        });
    }

    void TagVertices() {
        child_.vertex_tags.resize(static_cast<std::size_t>(child_.n_vertices));
        Tag* const tags = child_.vertex_tags.data();
        std::copy(parent_.vertex_tags.begin(), parent_.vertex_tags.end(), tags);
        Sdc::ParallelFor(parent_.n_edges, kGrain, [&](Offset begin, Offset end) {
            for (Offset e = begin; e < end; ++e) tags[first_.edge_point + e] = TagOfEdgePoint(parent_.edge_tags[e]);
        });
        Sdc::ParallelFor(parent_.n_faces, kGrain, [&](Offset begin, Offset end) {
            for (Offset f = begin; f < end; ++f) {
                tags[first_.face_point + f] = TagOfFacePoint(MakeFaceTag(parent_.NCells(static_cast<Index>(f)), 0));
            }
        });
        std::fill(tags + first_.cell_point, tags + child_.n_vertices, TagInsideCell());
    }

  private:
    Index EdgePoint(Index e) const { return first_.edge_point + e; }
    Index FacePoint(Index f) const { return first_.face_point + f; }
    Index CellPoint(Index c) const { return first_.cell_point + c; }
    Index HalfEdge(Index e, Index end) const { return 2 * e + (parent_.EdgeVertices(e)[1] == end); }
    /// The edge in a face to the point of one of its edges.
    Index FaceEdge(Index f, Index e) const {
        const auto edges = parent_.FaceEdges(f);
        const auto k = std::find(edges.begin(), edges.end(), e) - edges.begin();
        return first_.face_edge + static_cast<Index>(parent_.face_rows.Start(f) + k);
    }
    Index CellEdge(Index c, int face) const {
        const Offset before =
            parent_.IsHex(c) ? Offset{Hex::kFaces} * c
                             : Offset{Hex::kFaces} * parent_.n_hexes + parent_.polyhedra.offsets[c - parent_.n_hexes];
        return first_.cell_edge + static_cast<Index>(before) + face;
    }
    Index InnerFaceNumber(Index c, int edge) const {
        const Offset before = parent_.IsHex(c) ? Offset{Hex::kEdges} * c
                                               : Offset{Hex::kEdges} * parent_.n_hexes +
                                                     parent_.polyhedra.edge_offsets[c - parent_.n_hexes];
        return first_.inner_face + static_cast<Index>(before) + edge;
    }
    Index CornerOfFace(Index f, Index v) const {
        const auto vertices = parent_.FaceVertices(f);
        return static_cast<Index>(parent_.face_rows.Start(f) +
                                  (std::find(vertices.begin(), vertices.end(), v) - vertices.begin()));
    }
    /// The child at a vertex of a cell.
    Index ChildCell(Index c, Index v) const {
        if (c == kNoIndex) return kNoIndex;
        const auto vertices = parent_.CellVertices(c);
        const auto corner = std::find(vertices.begin(), vertices.end(), v) - vertices.begin();
        return parent_.IsHex(c) ? Hex::kVertices * c + static_cast<Index>(corner)
                                : odd_.Child(parent_.polyhedra.vertex_offsets[c - parent_.n_hexes] + corner);
    }

    std::array<Index, 4> CornerFace(Index f, int k) const {
        const auto v = parent_.FaceVertices(f);
        const auto e = parent_.FaceEdges(f);
        const std::size_t mine = static_cast<std::size_t>(k), before = mine > 0 ? mine - 1 : v.size() - 1;
        return {v[mine], EdgePoint(e[mine]), FacePoint(f), EdgePoint(e[before])};
    }

    void SplitFace(Index f) {
        const auto v = parent_.FaceVertices(f);
        const auto e = parent_.FaceEdges(f);
        const auto cells = parent_.FaceCells(f);
        const Index start = static_cast<Index>(parent_.face_rows.Start(f));
        const int n = static_cast<int>(v.size());
        for (int k = 0; k < n; ++k) {
            const int before = k > 0 ? k - 1 : n - 1;
            SetFace(start + k, CornerFace(f, k),
                    {HalfEdge(e[k], v[k]), first_.face_edge + start + k, first_.face_edge + start + before,
                     HalfEdge(e[before], v[k])},
                    ChildCell(cells[0], v[k]), ChildCell(cells[1], v[k]));
        }
    }
    /// The face across an edge of a cell, seen from outside the child at its first end. Faces are the cell's, left and
    /// right of the edge as it leaves that end.
    void InnerFace(Index c, int edge, int left, int right, Index first_child, Index second_child) {
        const Index e = parent_.CellEdges(c)[static_cast<std::size_t>(edge)];
        const auto faces = parent_.CellFaces(c);
        const Index on_left = faces[static_cast<std::size_t>(left)], on_right = faces[static_cast<std::size_t>(right)];
        SetFace(InnerFaceNumber(c, edge), {EdgePoint(e), FacePoint(on_right), CellPoint(c), FacePoint(on_left)},
                {FaceEdge(on_right, e), CellEdge(c, right), CellEdge(c, left), FaceEdge(on_left, e)}, first_child,
                second_child);
    }

    void SetEdge(Offset e, Index low, Index high, Tag tag) {
        child_.edge_vertices[2 * e] = low;
        child_.edge_vertices[2 * e + 1] = high;
        child_.edge_tags[e] = tag;
    }
    void SetFace(Index f, const std::array<Index, 4>& vertices, const std::array<Index, 4>& edges, Index first_cell,
                 Index second_cell) {
        std::copy(vertices.begin(), vertices.end(), child_.face_vertices.begin() + 4 * std::ptrdiff_t{f});
        std::copy(edges.begin(), edges.end(), child_.face_edges.begin() + 4 * std::ptrdiff_t{f});
        child_.face_cells[2 * static_cast<std::size_t>(f)] = first_cell;
        child_.face_cells[2 * static_cast<std::size_t>(f) + 1] = second_cell;
    }

    /// Writes a table of local numbers row by row as the numbers they stand for.
    template <class Table, class Numbers>
    static void Scatter(const Table& table, const Numbers& numbers, Index* out) {
        for (const auto& row : table) {
            for (Sdc::Local local : row) *out++ = numbers[local];
        }
    }

    void SplitHex(Index c, bool full) {
        const auto v = parent_.CellVertices(c);
        const auto e = parent_.CellEdges(c);
        const auto f = parent_.CellFaces(c);
        std::array<Index, HexSplit::kPoints> points;
        std::copy(v.begin(), v.end(), points.begin());
        for (int i = 0; i < Hex::kEdges; ++i) points[HexSplit::kFirstEdgePoint + i] = EdgePoint(e[i]);
        for (int i = 0; i < Hex::kFaces; ++i) points[HexSplit::kFirstFacePoint + i] = FacePoint(f[i]);
        points[HexSplit::kCentre] = CellPoint(c);
        const std::size_t first = 8 * static_cast<std::size_t>(c);
        Scatter(kHexSplit.vertices, points, child_.hex_vertices.data() + Hex::kVertices * first);
        if (!full) return;

        std::array<Index, HexSplit::kChildEdges> edges;
        std::array<Index, HexSplit::kChildFaces> faces;
        for (int i = 0; i < Hex::kEdges; ++i) {
            const Index first_is_high = v[Hex::edges[i][0]] > v[Hex::edges[i][1]];
            edges[2 * i] = 2 * e[i] + first_is_high;
            edges[2 * i + 1] = 2 * e[i] + 1 - first_is_high;
            faces[HexSplit::kFirstInnerFace + i] = InnerFaceNumber(c, i);
        }
        for (int i = 0; i < Hex::kFaces; ++i) {
            const Index start = static_cast<Index>(parent_.face_rows.Start(f[i]));
            for (int k = 0; k < 4; ++k) {
                faces[4 * i + k] = CornerOfFace(f[i], v[Hex::faces[i][k]]);
                // The face goes round as this cell sees it or the other way: edge k starts, or ends, at corner k.
                const Index corner = faces[4 * i + k] - start;
                const Index edge = e[kHexSplit.face_edges[i][k]];
                const Index place = parent_.FaceEdges(f[i])[static_cast<std::size_t>(corner)] == edge ? corner
                                    : corner > 0                                                      ? corner - 1
                                                                                                      : 3;
                edges[HexSplit::kFirstFaceEdge + 4 * i + k] = first_.face_edge + start + place;
            }
            edges[HexSplit::kFirstInnerEdge + i] = CellEdge(c, i);
        }
        Scatter(kHexSplit.edges, edges, child_.hex_edges.data() + Hex::kEdges * first);
        Scatter(kHexSplit.faces, faces, child_.hex_faces.data() + Hex::kFaces * first);
    }

    void SplitPolyhedron(Index i, bool full) {
        const Polyhedra& p = parent_.polyhedra;
        const Index c = parent_.n_hexes + i;
        const auto vertices = parent_.CellVertices(c);
        const auto cell_edges = parent_.CellEdges(c);
        const auto cell_faces = parent_.CellFaces(c);
        Internal::OddCell cell;
        for (std::size_t corner = 0; corner < vertices.size(); ++corner) {
            const Offset at = p.vertex_offsets[i] + static_cast<Offset>(corner);
            const Offset ring = p.ring_offsets[at];
            const int n = odd_.Degree(at);
            const Index v = vertices[corner];
            const auto edge = [&](int j) { return cell_edges[static_cast<std::size_t>(p.ring_edges[ring + j])]; };
            const auto face = [&](int j) { return cell_faces[static_cast<std::size_t>(p.ring_faces[ring + j])]; };
            if (n == 3 && !full) {  // most corners: what OddCells::Put would write
                const std::array<Index, 8> hex{v,
                                               EdgePoint(edge(0)),
                                               FacePoint(face(2)),
                                               EdgePoint(edge(2)),
                                               EdgePoint(edge(1)),
                                               FacePoint(face(0)),
                                               CellPoint(c),
                                               FacePoint(face(1))};
                std::copy(hex.begin(), hex.end(), child_.hex_vertices.begin() + 8 * std::ptrdiff_t{odd_.Child(at)});
                continue;
            }
            cell.Start(n);
            cell.vertices[0] = v;
            cell.vertices[cell.Centre()] = CellPoint(c);
            for (int j = 0; j < n; ++j) {
                cell.vertices[cell.EdgePoint(j)] = EdgePoint(edge(j));
                cell.vertices[cell.FacePoint(j)] = FacePoint(face(j));
                if (!full) continue;
                cell.edges[cell.Half(j)] = HalfEdge(edge(j), v);
                cell.edges[cell.OnFace(j, 0)] = FaceEdge(face(j), edge(j));
                cell.edges[cell.OnFace(j, 1)] = FaceEdge(face(j), edge(j + 1 < n ? j + 1 : 0));
                cell.edges[cell.Inner(j)] = CellEdge(c, p.ring_faces[ring + j]);
                cell.faces[cell.OuterFace(j)] = CornerOfFace(face(j), v);
                cell.faces[cell.InnerFace(j)] = InnerFaceNumber(c, p.ring_edges[ring + j]);
            }
            odd_.Put(cell, at, full, child_);
        }
    }

    const PolyhedralLevel& parent_;
    PolyhedralLevel& child_;
    const Internal::OddCells odd_;
    const FirstNumbers first_;
};

}  // namespace

PolyhedralLevel Refine(const PolyhedralLevel& parent, bool full) {
    assert(parent.is_full);
    PolyhedralLevel child;
    Splitter splitter(parent, child);
    splitter.SplitCells(full);
    splitter.SplitBoundary(full);
    if (full) {
        splitter.SplitFaces();
        splitter.SplitEdges();
        splitter.TagVertices();
        child.vertex_edges = Invert(child.edge_vertices, 2, child.n_vertices, false);
        child.edge_faces = Invert(child.face_edges, 4, child.n_edges, false);
        child.vertex_cells = Internal::CellsAtVertices(child);
        child.is_full = true;
    }
    return child;
}

}  // namespace SolidSubdiv::Vtr
