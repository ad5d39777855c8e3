// SPDX-License-Identifier: Apache-2.0
// Children at the corners of cells that are no hexahedra.
#include <solidsubdiv/vtr/internal/odd_cells.h>

#include <algorithm>
#include <array>

#include <solidsubdiv/sdc/parallel.h>

namespace SolidSubdiv::Vtr::Internal {

namespace {

/// The child at a corner of three edges as a hexahedron: its vertices, edges and faces in the order of Sdc::Hex.
constexpr std::array<int, 8> kHexVertices{0, 1, 6, 3, 2, 4, 7, 5};
constexpr std::array<int, 12> kHexEdges{0, 8, 7, 2, 4, 9, 10, 5, 1, 3, 11, 6};
constexpr std::array<int, 6> kHexFaces{1, 3, 0, 5, 2, 4};

template <class Table>
void Permute(const Table& table, const std::vector<Index>& from, Index* to) {
    for (int i : table) *to++ = from[static_cast<std::size_t>(i)];
}

constexpr Offset kChunk = 1 << 14;

}  // namespace

std::vector<OddCorners> CountOddCorners(const Polyhedra& p) {
    const Offset n_corners = static_cast<Offset>(p.ring_offsets.size()) - 1,
                 n_chunks = (n_corners + kChunk - 1) / kChunk;
    std::vector<OddCorners> before(static_cast<std::size_t>(n_chunks) + 1);
    Sdc::ParallelFor(n_chunks, 1, [&](Offset begin, Offset end) {
        for (Offset chunk = begin; chunk < end; ++chunk) {
            OddCorners odd;
            for (Offset i = chunk * kChunk; i < std::min(n_corners, (chunk + 1) * kChunk); ++i) {
                const Offset degree = p.ring_offsets[i + 1] - p.ring_offsets[i];
                if (degree != 3) odd.Add(degree);
            }
            before[chunk + 1] = odd;
        }
    });
    for (std::size_t i = 1; i < before.size(); ++i) {
        before[i].n += before[i - 1].n;
        before[i].n_edges += before[i - 1].n_edges;
    }
    return before;
}

OddCells::OddCells(const PolyhedralLevel& parent) : rings_(parent.polyhedra.ring_offsets) {
    const Offset n_corners = static_cast<Offset>(parent.polyhedra.vertices.size());
    const std::vector<OddCorners> before = CountOddCorners(parent.polyhedra);
    const OddCorners all = before.back();
    const Offset first_hex = Offset{Sdc::Hex::kVertices} * parent.n_hexes;
    n_hexes_ = static_cast<Index>(first_hex + n_corners - all.n);
    children_.resize(static_cast<std::size_t>(n_corners));
    edges_before_.resize(static_cast<std::size_t>(all.n) + 1);
    edges_before_.back() = all.n_edges;
    Sdc::ParallelFor(static_cast<Offset>(before.size()) - 1, 1, [&](Offset begin, Offset end) {
        for (Offset chunk = begin; chunk < end; ++chunk) {
            OddCorners odd = before[chunk];
            for (Offset i = chunk * kChunk; i < std::min(n_corners, (chunk + 1) * kChunk); ++i) {
                if (Degree(i) == 3) {
                    children_[i] = static_cast<Index>(first_hex + i - odd.n);
                } else {
                    children_[i] = static_cast<Index>(n_hexes_ + odd.n);
                    edges_before_[odd.n] = odd.n_edges;
                    odd.Add(Degree(i));
                }
            }
        }
    });
}

void OddCells::MakeRoom(Polyhedra& child, bool full) const {
    const std::size_t n = edges_before_.size() - 1, n_edges = static_cast<std::size_t>(edges_before_.back());
    child.offsets.resize(n + 1);
    child.face_vertex_offsets.resize(2 * n_edges + 1);
    child.face_vertices.resize(8 * n_edges);
    for (std::size_t i = 0; i < child.face_vertex_offsets.size(); ++i) {
        child.face_vertex_offsets[i] = 4 * static_cast<Offset>(i);
    }
    for (std::size_t i = 0; i <= n; ++i) child.offsets[i] = 2 * edges_before_[i];
    if (!full) return;
    child.vertex_offsets.resize(n + 1);
    child.edge_offsets.resize(n + 1);
    child.vertices.resize(2 * n_edges + 2 * n);
    child.edges.resize(4 * n_edges);
    child.faces.resize(2 * n_edges);
    child.ring_offsets.resize(child.vertices.size() + 1);
    child.ring_edges.resize(8 * n_edges);
    child.ring_faces.resize(8 * n_edges);
    for (std::size_t i = 0; i <= n; ++i) {
        child.vertex_offsets[i] = 2 * edges_before_[i] + 2 * static_cast<Offset>(i);
        child.edge_offsets[i] = 4 * edges_before_[i];
    }
    child.ring_offsets.back() = 8 * static_cast<Offset>(n_edges);
}

void OddCells::Put(const OddCell& cell, Offset corner, bool full, PolyhedralLevel& child) const {
    const int n = cell.n();
    const std::size_t number = static_cast<std::size_t>(Child(corner));
    if (n == 3) {
        Permute(kHexVertices, cell.vertices, child.hex_vertices.data() + 8 * number);
        if (!full) return;
        Permute(kHexEdges, cell.edges, child.hex_edges.data() + 12 * number);
        Permute(kHexFaces, cell.faces, child.hex_faces.data() + 6 * number);
        return;
    }
    const std::size_t i = number - static_cast<std::size_t>(n_hexes_);
    Polyhedra& p = child.polyhedra;
    const auto after = [n](int j) { return j + 1 < n ? j + 1 : 0; };
    const auto before = [n](int j) { return j > 0 ? j - 1 : n - 1; };
    Index* corners = p.face_vertices.data() + 8 * edges_before_[i];
    const auto put_face = [&](std::initializer_list<std::size_t> vertices) {
        for (std::size_t v : vertices) *corners++ = cell.vertices[v];
    };
    for (int j = 0; j < n; ++j) put_face({0, cell.EdgePoint(j), cell.FacePoint(j), cell.EdgePoint(after(j))});
    for (int j = 0; j < n; ++j) {
        put_face({cell.EdgePoint(j), cell.FacePoint(before(j)), cell.Centre(), cell.FacePoint(j)});
    }
    if (!full) return;
    std::copy(cell.vertices.begin(), cell.vertices.end(), p.vertices.begin() + p.vertex_offsets[i]);
    std::copy(cell.edges.begin(), cell.edges.end(), p.edges.begin() + p.edge_offsets[i]);
    std::copy(cell.faces.begin(), cell.faces.end(), p.faces.begin() + p.offsets[i]);

    Offset at = 8 * edges_before_[i];
    Offset* ring = p.ring_offsets.data() + p.vertex_offsets[i];
    const auto put_ring = [&](std::initializer_list<std::array<std::size_t, 2>> pairs) {
        *ring++ = at;
        for (const auto& [edge, face] : pairs) {
            p.ring_edges[at] = static_cast<Index>(edge);
            p.ring_faces[at++] = static_cast<Index>(face);
        }
    };
    *ring++ = at;
    for (int j = 0; j < n; ++j) {
        p.ring_edges[at] = static_cast<Index>(cell.Half(j));
        p.ring_faces[at++] = static_cast<Index>(cell.OuterFace(j));
    }
    for (int j = 0; j < n; ++j) {
        put_ring({{cell.Half(j), cell.OuterFace(before(j))},
                  {cell.OnFace(before(j), 1), cell.InnerFace(j)},
                  {cell.OnFace(j, 0), cell.OuterFace(j)}});
    }
    for (int j = 0; j < n; ++j) {
        put_ring({{cell.OnFace(j, 1), cell.OuterFace(j)},
                  {cell.OnFace(j, 0), cell.InnerFace(j)},
                  {cell.Inner(j), cell.InnerFace(after(j))}});
    }
    *ring++ = at;
    for (int j = n - 1; j >= 0; --j) {
        p.ring_edges[at] = static_cast<Index>(cell.Inner(j));
        p.ring_faces[at++] = static_cast<Index>(cell.InnerFace(j));
    }
}

}  // namespace SolidSubdiv::Vtr::Internal
