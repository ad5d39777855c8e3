// SPDX-License-Identifier: Apache-2.0
// Level 0 of a complex of polyhedra.
#include <solidsubdiv/vtr/polyhedral_base.h>

#include <algorithm>
#include <array>
#include <atomic>

#include <solidsubdiv/sdc/hex_split.h>
#include <solidsubdiv/sdc/parallel.h>
#include <solidsubdiv/vtr/grouping.h>
#include <solidsubdiv/vtr/internal/cell_rings.h>
#include <solidsubdiv/vtr/internal/face_items.h>
#include <solidsubdiv/vtr/internal/polyhedral_rules.h>
#include <solidsubdiv/vtr/internal/unique_faces.h>
#include <solidsubdiv/vtr/unique_tuples.h>

namespace SolidSubdiv::Vtr {

namespace {

using Sdc::Hex;

constexpr Offset kGrain = 1024;

/// Calls body(begin, end, findings) on ranges that cover [0, n), in parallel; what they find is added in their order.
template <class Body>
void FindInRanges(Offset n, PolyhedralFindings& findings, Body&& body) {
    const Offset n_ranges = (n + kGrain - 1) / kGrain;
    std::vector<PolyhedralFindings> parts(static_cast<std::size_t>(n_ranges));
    Sdc::ParallelFor(n_ranges, 1, [&](Offset first, Offset last) {
        for (Offset range = first; range < last; ++range) {
            body(static_cast<Index>(range * kGrain), static_cast<Index>(std::min((range + 1) * kGrain, n)),
                 parts[static_cast<std::size_t>(range)]);
        }
    });
    using F = PolyhedralFindings;
    for (const F& part : parts) {
        for (auto list : {&F::open_cells, &F::duplicate_cells, &F::faces_in_three_cells, &F::twisted_faces,
                          &F::duplicate_polygons, &F::coincident_polygons, &F::flipped_faces}) {
            (findings.*list).insert((findings.*list).end(), (part.*list).begin(), (part.*list).end());
        }
    }
}

class Builder {
  public:
    Builder(const PolyhedralElements& elements, PolyhedralFindings& findings)
        : in_(elements), findings_(findings), items_(elements), faces_(items_, elements.n_vertices) {}

    PolyhedralLevel Build() {
        level_.n_vertices = in_.n_vertices;
        level_.n_hexes = static_cast<Index>(in_.hexes.size() / Hex::kVertices);
        level_.hex_vertices.assign(in_.hexes.begin(), in_.hexes.end());
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
    /// An item's vertices from the lowest on, and whether the next of them is lower than the last.
    bool Around(Offset i, std::vector<Index>& out) const {
        items_.Copy(i, out);
        std::rotate(out.begin(), std::min_element(out.begin(), out.end()), out.end());
        return out[1] < out.back();
    }

    void MakeFaces() {
        level_.n_faces = faces_.size();
        level_.face_cells.resize(2 * static_cast<std::size_t>(level_.n_faces));
        Array<Offset> starts(static_cast<std::size_t>(level_.n_faces) + 1);
        std::atomic<bool> all_quads = true;
        Sdc::ParallelFor(level_.n_faces, kGrain, [&](Offset begin, Offset end) {
            for (Offset f = begin; f < end; ++f) {
                starts[f] = items_.Count(faces_.items[faces_.starts[f]]);
                if (starts[f] != 4) all_quads = false;
            }
        });
        level_.face_vertices.resize(static_cast<std::size_t>(Sdc::ScanLengths(starts)));
        if (!all_quads) level_.face_rows = {std::move(starts), 0};
        FindInRanges(level_.n_faces, findings_, [&](Index begin, Index end, PolyhedralFindings& found) {
            std::vector<Index> around;
            for (Index f = begin; f < end; ++f) MakeFace(f, around, found);
        });
    }

    /// @param around scratch
    void MakeFace(Index f, std::vector<Index>& around, PolyhedralFindings& found) {
        Index* const cells = level_.face_cells.data() + 2 * static_cast<std::size_t>(f);
        Index* const listed = level_.face_vertices.data() + level_.face_rows.Start(f);
        cells[0] = cells[1] = kNoIndex;
        int n_cells = 0;
        bool first_is_forward = false, has_polygon = false;
        for (Offset k = faces_.starts[f]; k < faces_.starts[f + 1]; ++k) {
            const Offset i = faces_.items[k];
            const bool is_forward = Around(i, around);
            if (k == faces_.starts[f]) {
                first_is_forward = is_forward;
                std::copy(around.begin(), around.end(), listed);
            }
            if (is_forward != first_is_forward) std::reverse(around.begin() + 1, around.end());
            if (!std::equal(around.begin(), around.end(), listed)) {
                found.twisted_faces.push_back(f);
                break;
            }
            if (items_.IsPolygon(i)) {
                const Index polygon = static_cast<Index>(i - items_.n_cell_items());
                if (has_polygon) {
                    found.duplicate_polygons.push_back(polygon);
                } else if (n_cells > 0) {
                    found.coincident_polygons.push_back(polygon);
                }
                has_polygon = true;
                continue;
            }
            if (n_cells == 2) {
                found.faces_in_three_cells.push_back(f);
                break;
            }
            if (n_cells == 1 && is_forward == first_is_forward) found.flipped_faces.push_back(f);
            cells[n_cells++] = items_.CellOf(i);
        }
        // Between two cells the list does not depend on their order: its second vertex is lower than its last.
        if (n_cells == 2 && !first_is_forward) {
            std::swap(cells[0], cells[1]);
            std::reverse(listed + 1, listed + level_.face_rows.Count(f));
        }
    }

    void MakeEdges() {
        const Offset n_face_items = static_cast<Offset>(level_.face_vertices.size());
        const Offset n_free = static_cast<Offset>(in_.edges.size() / 2);
        Array<Index> next(level_.face_vertices.size());
        Sdc::ParallelFor(level_.n_faces, kGrain, [&](Offset begin, Offset end) {
            for (Offset f = begin; f < end; ++f) {
                const auto v = level_.FaceVertices(static_cast<Index>(f));
                std::rotate_copy(v.begin(), v.begin() + 1, v.end(),
                                 next.begin() + level_.face_rows.Start(static_cast<Index>(f)));
            }
        });
        UniqueTuples<2> edges(in_.n_vertices, n_face_items + n_free, [&](Offset i) -> std::array<Index, 2> {
            if (i < n_face_items) return {level_.face_vertices[i], next[i]};
            return {in_.edges[2 * (i - n_face_items)], in_.edges[2 * (i - n_face_items) + 1]};
        });
        level_.n_edges = edges.size();
        level_.edge_vertices = std::move(edges.tuples);
        level_.face_edges = std::move(edges.ids);
        const std::vector<Index> free(level_.face_edges.begin() + n_face_items, level_.face_edges.end());
        level_.face_edges.resize(static_cast<std::size_t>(n_face_items));
        if (free.empty()) return;
        std::vector<std::uint8_t> use(static_cast<std::size_t>(level_.n_edges), 0);
        for (Index e : level_.face_edges) use[e] = 1;
        for (std::size_t i = 0; i < free.size(); ++i) {
            std::uint8_t& mine = use[free[i]];
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
        level_.hex_faces.assign(faces_.face_of_item.begin(), faces_.face_of_item.begin() + items_.n_hex_items());
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
        p.faces.assign(faces_.face_of_item.begin() + items_.n_hex_items(),
                       faces_.face_of_item.begin() + items_.n_cell_items());
        const auto find_rings = [&](Index c, Internal::CellRings& rings) {
            const Offset first = p.offsets[c];
            return rings.Find(static_cast<Index>(p.offsets[c + 1] - first), [&](Index f) {
                const Offset start = p.face_vertex_offsets[first + f], end = p.face_vertex_offsets[first + f + 1];
                return std::span<const Index>(p.face_vertices.data() + start, static_cast<std::size_t>(end - start));
            });
        };
        // Count, scan, fill: rings are found twice, which costs less than to keep them.
        p.vertex_offsets.resize(p.offsets.size());
        p.edge_offsets.resize(p.offsets.size());
        FindInRanges(p.size(), findings_, [&](Index begin, Index end, PolyhedralFindings& found) {
            Internal::CellRings rings;
            std::vector<Index> faces;
            for (Index c = begin; c < end; ++c) {
                faces.assign(p.faces.begin() + p.offsets[c], p.faces.begin() + p.offsets[c + 1]);
                std::sort(faces.begin(), faces.end());
                const bool has_face_twice = std::adjacent_find(faces.begin(), faces.end()) != faces.end();
                if (!find_rings(c, rings) || has_face_twice) found.open_cells.push_back(level_.n_hexes + c);
                p.vertex_offsets[c] = static_cast<Offset>(rings.vertices.size());
                p.edge_offsets[c] = static_cast<Offset>(rings.edges.size());
            }
        });
        if (!findings_.IsUsable()) return;
        p.vertices.resize(static_cast<std::size_t>(Sdc::ScanLengths(p.vertex_offsets)));
        p.edges.resize(static_cast<std::size_t>(Sdc::ScanLengths(p.edge_offsets)));
        p.ring_offsets.resize(p.vertices.size() + 1);
        p.ring_edges.resize(2 * p.edges.size());  // an edge is in the rings of its ends
        p.ring_faces.resize(2 * p.edges.size());
        Sdc::ParallelFor(p.size(), kGrain, [&](Offset begin, Offset end) {
            Internal::CellRings rings;
            for (Offset c = begin; c < end; ++c) {
                find_rings(static_cast<Index>(c), rings);
                const Offset first_corner = p.vertex_offsets[c], first_ring = 2 * p.edge_offsets[c];
                std::copy(rings.vertices.begin(), rings.vertices.end(), p.vertices.begin() + first_corner);
                for (std::size_t i = 1; i < rings.ring_offsets.size(); ++i) {
                    p.ring_offsets[first_corner + static_cast<Offset>(i)] = first_ring + rings.ring_offsets[i];
                }
                std::copy(rings.ring_edges.begin(), rings.ring_edges.end(), p.ring_edges.begin() + first_ring);
                std::copy(rings.ring_faces.begin(), rings.ring_faces.end(), p.ring_faces.begin() + first_ring);
                for (std::size_t e = 0; e < rings.edges.size(); ++e) {
                    const auto [a, b] = rings.edges[e];
                    p.edges[p.edge_offsets[c] + static_cast<Offset>(e)] =
                        EdgeOf(p.faces[p.offsets[c] + rings.FaceAt(static_cast<Index>(e))], rings.vertices[a],
                               rings.vertices[b]);
                }
            }
        });
    }

    /// Two cells that are the same share all faces: any one tells.
    void FindDuplicateCells() {
        FindInRanges(level_.n_cells(), findings_, [&](Index begin, Index end, PolyhedralFindings& found) {
            for (Index c = begin; c < end; ++c) {
                const auto sides = level_.FaceCells(level_.CellFaces(c)[0]);
                const Index other = sides[0] == c ? sides[1] : sides[0];
                if (other == kNoIndex || other > c) continue;
                const auto mine = level_.CellVertices(c), others = level_.CellVertices(other);
                const auto has = [&](Index v) { return std::find(others.begin(), others.end(), v) != others.end(); };
                if (mine.size() == others.size() && std::all_of(mine.begin(), mine.end(), has)) {
                    found.duplicate_cells.push_back(c);
                }
            }
        });
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
                    findings_.flipped_edges.push_back(e[k]);
                }
                seen[e[k]] |= way;
            }
        }
        level_.n_boundary_faces = static_cast<Index>(level_.boundary_faces.size());
    }

    const PolyhedralElements& in_;
    PolyhedralFindings& findings_;
    const Internal::FaceItems items_;
    const Internal::UniqueFaces faces_;
    PolyhedralLevel level_;
};

}  // namespace

PolyhedralLevel MakePolyhedralBaseLevel(const PolyhedralElements& elements, PolyhedralFindings& findings) {
    return Builder(elements, findings).Build();
}

}  // namespace SolidSubdiv::Vtr
