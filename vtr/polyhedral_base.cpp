// SPDX-License-Identifier: Apache-2.0
// Level 0 of a complex of polyhedra.
#include <solidsubdiv/vtr/polyhedral_base.h>

#include <algorithm>
#include <array>

#include <solidsubdiv/sdc/hex_split.h>
#include <solidsubdiv/sdc/parallel.h>
#include <solidsubdiv/vtr/grouping.h>
#include <solidsubdiv/vtr/internal/cell_rings.h>
#include <solidsubdiv/vtr/internal/polyhedral_rules.h>
#include <solidsubdiv/vtr/unique_tuples.h>

namespace SolidSubdiv::Vtr {

namespace {

using Sdc::Hex;

constexpr Offset kGrain = 1024;

/// Lists of vertices around faces: sides of hexahedra, faces of other cells, polygons, in this order.
class FaceItems {
  public:
    explicit FaceItems(const PolyhedralElements& in) : in_(in) {
        const auto rows = [](std::span<const Offset> offsets) {
            return offsets.empty() ? Offset{0} : static_cast<Offset>(offsets.size()) - 1;
        };
        n_hexes_ = static_cast<Index>(in.hexes.size() / Hex::kVertices);
        n_hex_items_ = Offset{Hex::kFaces} * n_hexes_;
        n_cell_items_ = n_hex_items_ + rows(in.face_offsets);
        n_ = n_cell_items_ + rows(in.polygon_offsets);
        for (Index c = 0; c < rows(in.cell_offsets); ++c) {
            cells_.insert(cells_.end(), static_cast<std::size_t>(in.cell_offsets[c + 1] - in.cell_offsets[c]),
                          n_hexes_ + c);
        }
    }
    Offset size() const { return n_; }
    Offset n_hex_items() const { return n_hex_items_; }
    Offset n_cell_items() const { return n_cell_items_; }
    bool IsPolygon(Offset i) const { return i >= n_cell_items_; }
    /// The cell that has item i, or kNoIndex.
    Index CellOf(Offset i) const {
        if (i < n_hex_items_) return static_cast<Index>(i / Hex::kFaces);
        return IsPolygon(i) ? kNoIndex : cells_[static_cast<std::size_t>(i - n_hex_items_)];
    }
    int Count(Offset i) const {
        if (i < n_hex_items_) return 4;
        const auto [offsets, at] = RowOf(i);
        return static_cast<int>(offsets[at + 1] - offsets[at]);
    }
    Index Vertex(Offset i, int k) const {
        if (i < n_hex_items_) {
            return in_.hexes[static_cast<std::size_t>(i / Hex::kFaces * Hex::kVertices +
                                                      Hex::faces[static_cast<std::size_t>(i % Hex::kFaces)][k])];
        }
        const auto [offsets, at] = RowOf(i);
        return (IsPolygon(i) ? in_.polygon_vertices : in_.face_vertices)[static_cast<std::size_t>(offsets[at] + k)];
    }

  private:
    struct Row {
        std::span<const Offset> offsets;
        std::size_t at;
    };
    Row RowOf(Offset i) const {
        if (IsPolygon(i)) return {in_.polygon_offsets, static_cast<std::size_t>(i - n_cell_items_)};
        return {in_.face_offsets, static_cast<std::size_t>(i - n_hex_items_)};
    }

    const PolyhedralElements& in_;
    Index n_hexes_;
    Offset n_hex_items_, n_cell_items_, n_;
    std::vector<Index> cells_;
};

class Builder {
  public:
    Builder(const PolyhedralElements& elements, PolyhedralFindings& findings)
        : in_(elements), findings_(findings), items_(elements) {}

    PolyhedralLevel Build() {
        level_.n_vertices = in_.n_vertices;
        level_.n_hexes = static_cast<Index>(in_.hexes.size() / Hex::kVertices);
        level_.hex_vertices.assign(in_.hexes.begin(), in_.hexes.end());
        NumberFaces();
        MakeFaces();
        MakeEdges();
        if (!findings_.IsUsable()) return std::move(level_);
        MakeHexes();
        MakePolyhedra();
        if (findings_.IsUsable()) FindDuplicateCells();
        if (!findings_.IsUsable()) return std::move(level_);
        level_.vertex_edges = Invert(level_.edge_vertices, 2, level_.n_vertices, false);
        MakeUpwardRelations();
        MakeBoundary();
        Internal::TagEdgesAndVertices(level_);
        level_.is_full = true;
        return std::move(level_);
    }

  private:
    /// Of each item its face: items with the same vertices are one. Faces in lexicographic order of ascending vertices.
    void NumberFaces() {
        const Offset n = items_.size();
        Array<Offset> starts(static_cast<std::size_t>(n) + 1);
        for (Offset i = 0; i < n; ++i) starts[i] = items_.Count(i);
        Array<Index> sorted(static_cast<std::size_t>(Sdc::ScanLengths(starts)));
        Sdc::ParallelFor(n, kGrain, [&](Offset begin, Offset end) {
            for (Offset i = begin; i < end; ++i) {
                Index* const row = sorted.data() + starts[i];
                const int size = items_.Count(i);
                for (int k = 0; k < size; ++k) row[k] = items_.Vertex(i, k);
                std::sort(row, row + size);
            }
        });
        const auto vertices = [&](Offset i) {
            return std::span(sorted.data() + starts[i], static_cast<std::size_t>(starts[i + 1] - starts[i]));
        };
        const auto compare = [&](Index i, Index j) {
            const auto a = vertices(i), b = vertices(j);
            return std::lexicographical_compare_three_way(a.begin(), a.end(), b.begin(), b.end());
        };
        const auto visit = [&](auto&& add) {
            for (Offset i = 0; i < n; ++i) add(vertices(i)[0], static_cast<Index>(i));
        };
        Array<Offset> rows = CountRows(in_.n_vertices, visit);
        items_of_face_.resize(static_cast<std::size_t>(n));
        FillRows(rows, visit, [&](Offset place, Index i) { items_of_face_[place] = i; });
        Sdc::ParallelFor(in_.n_vertices, kGrain, [&](Offset begin, Offset end) {
            for (Offset v = begin; v < end; ++v) {
                std::sort(items_of_face_.begin() + rows[v], items_of_face_.begin() + rows[v + 1],
                          [&](Index i, Index j) {
                              const auto order = compare(i, j);
                              return order != 0 ? order < 0 : i < j;
                          });
            }
        });
        face_of_item_.resize(static_cast<std::size_t>(n));
        face_items_.assign(1, 0);
        for (Offset k = 0; k < n; ++k) {
            const Index i = items_of_face_[k];
            if (k > 0 && compare(i, items_of_face_[k - 1]) != 0) face_items_.push_back(k);
            face_of_item_[i] = static_cast<Index>(face_items_.size()) - 1;
        }
        if (n > 0) face_items_.push_back(n);
        level_.n_faces = static_cast<Index>(face_items_.size()) - 1;
    }

    /// An item's vertices from the lowest on, and whether the next of them is lower than the last.
    bool Around(Offset i, std::vector<Index>& out) const {
        const int n = items_.Count(i);
        int lowest = 0;
        for (int k = 1; k < n; ++k) {
            if (items_.Vertex(i, k) < items_.Vertex(i, lowest)) lowest = k;
        }
        out.clear();
        for (int k = 0; k < n; ++k) out.push_back(items_.Vertex(i, (lowest + k) % n));
        return out[1] < out.back();
    }

    void MakeFaces() {
        level_.face_cells.resize(2 * static_cast<std::size_t>(level_.n_faces));
        RowOffsets& rows = level_.face_rows;
        rows.fixed = 0;
        rows.offsets.assign(1, 0);
        std::vector<Index> around, first_around, listed;
        for (Index f = 0; f < level_.n_faces; ++f) {
            Index* const cells = level_.face_cells.data() + 2 * static_cast<std::size_t>(f);
            cells[0] = cells[1] = kNoIndex;
            int n_cells = 0;
            bool first_is_forward = false, has_polygon = false;
            for (Offset k = face_items_[f]; k < face_items_[f + 1]; ++k) {
                const Offset i = items_of_face_[k];
                const bool is_forward = Around(i, around);
                const bool is_first = k == face_items_[f];
                if (is_first) {
                    listed = around;
                    first_is_forward = is_forward;
                }
                if (is_forward != first_is_forward) std::reverse(around.begin() + 1, around.end());
                if (is_first) {
                    first_around = around;
                } else if (around != first_around) {
                    findings_.twisted_faces.push_back(f);
                    break;
                }
                if (items_.IsPolygon(i)) {
                    const Index polygon = static_cast<Index>(i - items_.n_cell_items());
                    if (has_polygon) {
                        findings_.duplicate_polygons.push_back(polygon);
                    } else if (n_cells > 0) {
                        findings_.coincident_polygons.push_back(polygon);
                    }
                    has_polygon = true;
                    continue;
                }
                if (n_cells == 2) {
                    findings_.faces_in_three_cells.push_back(f);
                    break;
                }
                if (n_cells == 1 && is_forward == first_is_forward) findings_.flipped_faces.push_back(f);
                cells[n_cells++] = items_.CellOf(i);
            }
            // Between two cells the list does not depend on their order: its second vertex is lower than its last.
            if (n_cells == 2 && !first_is_forward) {
                std::swap(cells[0], cells[1]);
                std::reverse(listed.begin() + 1, listed.end());
            }
            level_.face_vertices.insert(level_.face_vertices.end(), listed.begin(), listed.end());
            rows.offsets.push_back(static_cast<Offset>(level_.face_vertices.size()));
        }
        if (level_.face_vertices.size() == 4 * static_cast<std::size_t>(level_.n_faces)) {
            const auto is_quad = [&](Index f) { return rows.Count(f) == 4; };
            bool all = true;
            for (Index f = 0; f < level_.n_faces; ++f) all = all && is_quad(f);
            if (all) rows = {{}, 4};
        }
    }

    void MakeEdges() {
        const Offset n_face_items = static_cast<Offset>(level_.face_vertices.size());
        const Offset n_free = static_cast<Offset>(in_.edges.size() / 2);
        Array<Index> next(level_.face_vertices.size());
        for (Index f = 0; f < level_.n_faces; ++f) {
            const Offset start = level_.face_rows.Start(f);
            const int n = level_.face_rows.Count(f);
            for (int k = 0; k < n; ++k) next[start + k] = level_.face_vertices[start + (k + 1) % n];
        }
        UniqueTuples<2> edges(in_.n_vertices, n_face_items + n_free, [&](Offset i) -> std::array<Index, 2> {
            if (i < n_face_items) return {level_.face_vertices[i], next[i]};
            return {in_.edges[2 * (i - n_face_items)], in_.edges[2 * (i - n_face_items) + 1]};
        });
        level_.n_edges = edges.size();
        level_.edge_vertices = std::move(edges.tuples);
        level_.face_edges.assign(edges.ids.begin(), edges.ids.begin() + n_face_items);
        std::vector<std::uint8_t> use(static_cast<std::size_t>(level_.n_edges), 0);
        for (Index e : level_.face_edges) use[e] = 1;
        for (Offset i = 0; i < n_free; ++i) {
            std::uint8_t& mine = use[edges.ids[n_face_items + i]];
            if (mine == 2) {
                findings_.duplicate_edges.push_back(static_cast<Index>(i));
            } else if (mine == 1) {
                findings_.coincident_edges.push_back(static_cast<Index>(i));
            } else {
                mine = 2;
            }
        }
    }

    /// The edge of face f between two of its vertices that follow one another.
    Index EdgeOf(Index f, Index a, Index b) const {
        const auto v = level_.FaceVertices(f);
        const auto e = level_.FaceEdges(f);
        for (std::size_t k = 0; k < v.size(); ++k) {
            const Index next = v[k + 1 < v.size() ? k + 1 : 0];
            if ((v[k] == a && next == b) || (v[k] == b && next == a)) return e[k];
        }
        return kNoIndex;
    }

    void MakeHexes() {
        level_.hex_faces.assign(face_of_item_.begin(), face_of_item_.begin() + items_.n_hex_items());
        level_.hex_edges.resize(Hex::kEdges * static_cast<std::size_t>(level_.n_hexes));
        Sdc::ParallelFor(level_.n_hexes, kGrain, [&](Offset begin, Offset end) {
            for (Offset c = begin; c < end; ++c) {
                const Index* const v = level_.hex_vertices.data() + Hex::kVertices * c;
                for (int e = 0; e < Hex::kEdges; ++e) {
                    const Index face = level_.hex_faces[Hex::kFaces * c + Sdc::kHexSplit.sides[e][0]];
                    level_.hex_edges[Hex::kEdges * c + e] = EdgeOf(face, v[Hex::edges[e][0]], v[Hex::edges[e][1]]);
                }
            }
        });
    }

    void MakePolyhedra() {
        Polyhedra& p = level_.polyhedra;
        if (in_.cell_offsets.empty()) return;
        p.offsets.assign(in_.cell_offsets.begin(), in_.cell_offsets.end());
        p.face_vertex_offsets.assign(in_.face_offsets.begin(), in_.face_offsets.end());
        p.face_vertices.assign(in_.face_vertices.begin(), in_.face_vertices.end());
        p.faces.assign(face_of_item_.begin() + items_.n_hex_items(), face_of_item_.begin() + items_.n_cell_items());
        Internal::CellRings rings;
        for (Index c = 0; c < p.size(); ++c) {
            const Offset first = p.offsets[c];
            const bool is_closed = rings.Find(static_cast<Index>(p.offsets[c + 1] - first), [&](Index f) {
                const Offset start = p.face_vertex_offsets[first + f], end = p.face_vertex_offsets[first + f + 1];
                return std::span<const Index>(p.face_vertices.data() + start, static_cast<std::size_t>(end - start));
            });
            std::vector<Index> faces(p.faces.begin() + first, p.faces.begin() + p.offsets[c + 1]);
            std::sort(faces.begin(), faces.end());
            const bool has_face_twice = std::adjacent_find(faces.begin(), faces.end()) != faces.end();
            if (!is_closed || has_face_twice) {
                findings_.open_cells.push_back(level_.n_hexes + c);
                continue;
            }
            p.vertices.insert(p.vertices.end(), rings.vertices.begin(), rings.vertices.end());
            p.vertex_offsets.push_back(static_cast<Offset>(p.vertices.size()));
            const Offset first_ring = static_cast<Offset>(p.ring_edges.size());
            for (std::size_t i = 1; i < rings.ring_offsets.size(); ++i) {
                p.ring_offsets.push_back(first_ring + rings.ring_offsets[i]);
            }
            p.ring_edges.insert(p.ring_edges.end(), rings.ring_edges.begin(), rings.ring_edges.end());
            p.ring_faces.insert(p.ring_faces.end(), rings.ring_faces.begin(), rings.ring_faces.end());
            // Any face at an edge knows its number: the one after it in a ring of one of its ends does.
            std::vector<Index> face_at(rings.edges.size());
            for (std::size_t i = 0; i < rings.ring_edges.size(); ++i)
                face_at[rings.ring_edges[i]] = rings.ring_faces[i];
            for (std::size_t e = 0; e < rings.edges.size(); ++e) {
                p.edges.push_back(EdgeOf(p.faces[first + face_at[e]], rings.vertices[rings.edges[e][0]],
                                         rings.vertices[rings.edges[e][1]]));
            }
            p.edge_offsets.push_back(static_cast<Offset>(p.edges.size()));
        }
    }

    /// Two cells that are the same share all faces: any one tells.
    void FindDuplicateCells() {
        const auto vertices = [&](Index c) {
            const auto v = level_.CellVertices(c);
            std::vector<Index> sorted(v.begin(), v.end());
            std::sort(sorted.begin(), sorted.end());
            return sorted;
        };
        for (Index c = 0; c < level_.n_cells(); ++c) {
            const auto sides = level_.FaceCells(level_.CellFaces(c)[0]);
            const Index other = sides[0] == c ? sides[1] : sides[0];
            if (other == kNoIndex || other > c) continue;
            if (level_.CellVertices(other).size() == level_.CellVertices(c).size() && vertices(other) == vertices(c)) {
                findings_.duplicate_cells.push_back(c);
            }
        }
    }

    void MakeUpwardRelations() {
        const auto visit_faces = [&](auto&& add) {
            for (Index f = 0; f < level_.n_faces; ++f) {
                for (Index e : level_.FaceEdges(f)) add(e, f);
            }
        };
        if (level_.n_faces > 0) {
            Relation& r = level_.edge_faces;
            r.offsets = CountRows(level_.n_edges, visit_faces);
            r.items.resize(level_.face_edges.size());
            FillRows(r.offsets, visit_faces, [&](Offset place, Index f) { r.items[place] = f; });
        }
        level_.vertex_cells = Internal::CellsAtVertices(level_);
    }

    /// Lists faces of one cell or none, and finds places where surface elements are oriented against each other.
    void MakeBoundary() {
        RowOffsets& rows = level_.boundary_rows;
        rows = level_.face_rows.is_fixed() ? RowOffsets{{}, 4} : RowOffsets{Array<Offset>{0}, 0};
        // Of each edge, who passed it upwards and downwards.
        std::vector<std::uint8_t> seen(static_cast<std::size_t>(level_.n_edges), 0);
        for (Index f = 0; f < level_.n_faces; ++f) {
            if (!level_.IsBoundary(f)) continue;
            const auto v = level_.FaceVertices(f);
            level_.boundary_faces.push_back(f);
            level_.boundary_vertices.insert(level_.boundary_vertices.end(), v.begin(), v.end());
            if (!rows.is_fixed()) rows.offsets.push_back(static_cast<Offset>(level_.boundary_vertices.size()));
            if (level_.NCells(f) > 0) continue;
            const auto e = level_.FaceEdges(f);
            for (std::size_t k = 0; k < v.size(); ++k) {
                const std::uint8_t way = level_.EdgeVertices(e[k])[0] == v[k] ? 1 : 2;
                if ((seen[e[k]] & way) != 0 && level_.edge_faces.Count(e[k]) == 2) {
                    findings_.flipped_faces.push_back(f);
                }
                seen[e[k]] |= way;
            }
        }
        level_.n_boundary_faces = static_cast<Index>(level_.boundary_faces.size());
    }

    const PolyhedralElements& in_;
    PolyhedralFindings& findings_;
    const FaceItems items_;
    PolyhedralLevel level_;
    std::vector<Index> items_of_face_;  // items, those of a face side by side
    std::vector<Index> face_of_item_;
    std::vector<Offset> face_items_;  // of each face: its items
};

}  // namespace

PolyhedralLevel MakePolyhedralBaseLevel(const PolyhedralElements& elements, PolyhedralFindings& findings) {
    return Builder(elements, findings).Build();
}

}  // namespace SolidSubdiv::Vtr
