// SPDX-License-Identifier: Apache-2.0
// Links, rings and sides read off a level.
#include <solidsubdiv/kit/analysis/internal/place_codes.h>

#include <algorithm>
#include <array>

#include <solidsubdiv/kit/analysis/internal/link.h>

namespace SolidSubdiv::Analysis::Internal {

namespace {

std::string Counted(std::size_t n, const std::string& one, const std::string& many) {
    return std::to_string(n) + " " + (n == 1 ? one : many);
}

/// "6 tets, 1 octahedron"
std::string CellsText(std::size_t n_tets, std::size_t n_octs) {
    std::string text;
    if (n_tets > 0) text = Counted(n_tets, "tet", "tets");
    if (n_octs > 0) text += (text.empty() ? "" : ", ") + Counted(n_octs, "octahedron", "octahedra");
    return text;
}

std::u16string Code(std::size_t n) { return std::u16string(1, static_cast<char16_t>(n + 1)); }

int NumberOf(std::vector<Index>& list, Index v) {
    const auto at = std::find(list.begin(), list.end(), v) - list.begin();
    if (at == static_cast<std::ptrdiff_t>(list.size())) list.push_back(v);
    return static_cast<int>(at);
}

// Marks of the cells around an edge between two ring vertices: the tet's B edge, or the edge is an A edge and the lower
// end's mate is the first, the second ring vertex; an octahedron whose major diagonal starts below, above, on the ring.
constexpr char16_t kTet = 0, kFirst = 1, kSecond = 2, kOctBelow = 3, kOctAbove = 4, kOctRing = 5;

char16_t SwapRing(char16_t mark) { return mark == kFirst ? kSecond : mark == kSecond ? kFirst : mark; }
char16_t SwapEnds(char16_t mark) {
    return mark == kOctBelow ? kOctAbove : mark == kOctAbove ? kOctBelow : SwapRing(mark);
}

}  // namespace

bool UsesDiagonals(const Sdc::Scheme& scheme) {
    return std::visit(
        [](const auto& s) {
            if constexpr (requires { s.footprint(); }) return s.footprint().octs == Sdc::OctNeighbors::MajorDiagonal;
            return false;
        },
        scheme);
}

TetOctCodes::TetOctCodes(const Vtr::Level& level, bool uses_diagonals)
    : level_(level),
      uses_diagonals_(uses_diagonals),
      vertex_tets_(Vtr::Invert(level.tet_vertices, 4, level.n_vertices, true)),
      edge_tets_(Vtr::Invert(level.tet_edges, 6, level.n_edges, true)),
      sides_(2 * static_cast<std::size_t>(level.n_faces)) {
    const auto add = [&](Index face, Index vertex, bool is_oct) {
        Side* side = &sides_[2 * static_cast<std::size_t>(face)];
        if (side->vertex != kNoIndex) ++side;
        *side = {vertex, is_oct};
    };
    for (Index t = 0; t < level.n_tets; ++t) {
        // Opposite vertex i the B edge in the face is the one without i's mate.
        for (std::size_t i = 0; i < 4; ++i) add(level.TetFaces(t)[i], level.TetVertices(t)[i ^ 1], false);
    }
    for (Index o = 0; o < level.n_octs; ++o) {
        for (std::size_t i = 0; i < 8; ++i)
            add(level.OctFaces(o)[i], level.OctVertices(o)[Sdc::Oct::faces[i][0]], true);
    }
}

PlaceCode TetOctCodes::InnerVertex(Index v) const {
    std::vector<Index> neighbors;
    std::vector<LinkFace> link;
    const auto tets = vertex_tets_[v], octs = level_.vertex_octs[v];
    for (std::size_t k = 0; k < tets.size(); ++k) {
        const auto corners = level_.TetVertices(tets[k]);
        const unsigned self = vertex_tets_.Locals(v)[k];
        LinkFace face;
        for (unsigned i = 0; i < 4; ++i) {
            if (i == self) continue;
            face.corners.push_back(NumberOf(neighbors, corners[i]));
            face.marks.push_back(uses_diagonals_ && i == (self ^ 1));
        }
        link.push_back(std::move(face));
    }
    for (std::size_t k = 0; k < octs.size(); ++k) {
        const auto corners = level_.OctVertices(octs[k]);
        const unsigned pair = level_.vertex_octs.Locals(v)[k] / 2u;
        const unsigned a = pair == 0 ? 2 : 0, b = pair == 2 ? 2 : 4;  // the other pairs
        LinkFace face;
        for (unsigned i : {a, b, a + 1, b + 1}) {
            face.corners.push_back(NumberOf(neighbors, corners[i]));
            face.marks.push_back(uses_diagonals_ && (pair == 0 || i < 2) ? 1 : 0);
        }
        link.push_back(std::move(face));
    }
    return {CodeOf(link),
            CellsText(tets.size(), octs.size()) + ", " + Counted(neighbors.size(), "neighbor", "neighbors")};
}

PlaceCode TetOctCodes::InnerEdge(Index e) const {
    if (level_.edge_tags[e].rule() != Vtr::Rule::Solid) return {};
    std::vector<RingCell> ring;
    const auto ends = level_.EdgeVertices(e);
    const auto tets = edge_tets_[e], octs = level_.edge_octs[e];
    std::size_t n_along = 0;
    for (std::size_t k = 0; k < tets.size(); ++k) {
        const auto v = level_.TetVertices(tets[k]);
        const auto& local = Sdc::Tet::edges[edge_tets_.Locals(e)[k]];
        const unsigned below = v[local[0]] == ends[0] ? local[0] : local[1], above = local[0] + local[1] - below;
        std::array<unsigned, 2> others{};
        for (unsigned i = 0, n = 0; i < 4; ++i) {
            if (i != below && i != above) others[n++] = i;
        }
        const bool is_b_edge = (below ^ 1) == above;
        n_along += is_b_edge;
        const char16_t mark = !uses_diagonals_ || is_b_edge ? kTet : (below ^ 1) == others[0] ? kFirst : kSecond;
        ring.push_back({v[others[0]], v[others[1]], mark});
    }
    for (std::size_t k = 0; k < octs.size(); ++k) {
        const auto v = level_.OctVertices(octs[k]);
        const auto& local = Sdc::Oct::edges[level_.edge_octs.Locals(e)[k]];
        const unsigned below = v[local[0]] == ends[0] ? local[0] : local[1], above = local[0] + local[1] - below;
        const unsigned third = 3 - below / 2 - above / 2;  // the pair across
        const char16_t mark = !uses_diagonals_ || below < 2 ? kOctBelow : above < 2 ? kOctAbove : kOctRing;
        ring.push_back({v[2 * third], v[2 * third + 1], mark});
    }
    std::string what = CellsText(tets.size(), octs.size());
    if (uses_diagonals_) what += ", B edge of " + std::to_string(n_along);
    // Without diagonals octahedra have one mark, which turning upside down must not change.
    return {CodeOf(std::move(ring), {SwapRing, uses_diagonals_ ? SwapEnds : SwapRing}), what};
}

PlaceCode TetOctCodes::InnerFace(Index f) const {
    if (level_.face_tags[f].n_cells() != 2) return {};
    const Side& a = sides_[2 * static_cast<std::size_t>(f)];
    const Side& b = sides_[2 * static_cast<std::size_t>(f) + 1];
    const bool is_matched = a.vertex == b.vertex;
    const std::size_t n_octs = static_cast<std::size_t>(a.is_oct) + static_cast<std::size_t>(b.is_oct);
    std::string what = CellsText(2 - n_octs, n_octs);
    if (uses_diagonals_) what += is_matched ? ", matched" : ", unmatched";
    return {Code(2 * n_octs + (uses_diagonals_ && is_matched)), what};
}

PlaceCode TetOctCodes::SurfaceVertex(Index v) const {
    std::vector<Index> faces;
    for (Index e : level_.vertex_edges[v]) {
        for (Index f : level_.edge_faces[e]) {
            if (level_.face_tags[f].is_boundary()) NumberOf(faces, f);
        }
    }
    return {Code(faces.size()), Counted(faces.size(), "triangle", "triangles")};
}

PlaceCode PolyhedralCodes::InnerVertex(Index v) const {
    std::vector<Index> edges;
    std::vector<LinkFace> link;
    for (Index c : level_.vertex_cells[v]) {
        LinkFace face;
        const auto vertices = level_.CellVertices(c), cell_edges = level_.CellEdges(c);
        if (level_.IsHex(c)) {
            for (Index e : cell_edges) {
                const auto ends = level_.EdgeVertices(e);
                if (ends[0] == v || ends[1] == v) face.corners.push_back(NumberOf(edges, e));
            }
        } else {
            const Vtr::Polyhedra& p = level_.polyhedra;
            const Offset corner = p.vertex_offsets[c - level_.n_hexes] +
                                  (std::find(vertices.begin(), vertices.end(), v) - vertices.begin());
            for (Offset k = p.ring_offsets[corner]; k < p.ring_offsets[corner + 1]; ++k) {
                face.corners.push_back(NumberOf(edges, cell_edges[static_cast<std::size_t>(p.ring_edges[k])]));
            }
        }
        face.marks.assign(face.corners.size(), 0);
        link.push_back(std::move(face));
    }
    return {CodeOf(link), Counted(link.size(), "cell", "cells") + ", " + Counted(edges.size(), "edge", "edges")};
}

PlaceCode PolyhedralCodes::InnerEdge(Index e) const {
    if (level_.edge_tags[e].rule() != Vtr::Rule::Solid) return {};
    const auto n = static_cast<std::size_t>(level_.edge_faces.Count(e));
    return {Code(n), Counted(n, "cell", "cells")};
}

PlaceCode PolyhedralCodes::InnerFace(Index f) const {
    const std::size_t n = level_.FaceVertices(f).size();
    if (level_.NCells(f) != 2) return {};
    return {Code(n), Counted(n, "side", "sides")};
}

PlaceCode PolyhedralCodes::SurfaceFace(Index f) const {
    const std::size_t n = level_.FaceVertices(f).size();
    if (!level_.IsBoundary(f) || n == 4) return {};
    return {Code(n), Counted(n, "side", "sides")};
}

PlaceCode PolyhedralCodes::InnerCell(Index c) const {
    if (level_.IsHex(c)) return {u"hexahedron", "8 corners, 6 faces"};
    const Vtr::Polyhedra& p = level_.polyhedra;
    const Index i = c - level_.n_hexes;
    std::vector<LinkFace> link;  // of the cell's point: a corner for each face, a face for each corner
    for (Offset corner = p.vertex_offsets[i]; corner < p.vertex_offsets[i + 1]; ++corner) {
        LinkFace face;
        for (Offset k = p.ring_offsets[corner]; k < p.ring_offsets[corner + 1]; ++k) {
            face.corners.push_back(static_cast<int>(p.ring_faces[k]));
        }
        face.marks.assign(face.corners.size(), 0);
        link.push_back(std::move(face));
    }
    return {CodeOf(link),
            Counted(link.size(), "corner", "corners") + ", " + Counted(level_.CellFaces(c).size(), "face", "faces")};
}

PlaceCode PolyhedralCodes::SurfaceVertex(Index v) const {
    std::vector<Index> faces;
    for (Index e : level_.vertex_edges[v]) {
        for (Index f : level_.edge_faces[e]) {
            if (level_.IsBoundary(f)) NumberOf(faces, f);
        }
    }
    return {Code(faces.size()), Counted(faces.size(), "face", "faces")};
}

}  // namespace SolidSubdiv::Analysis::Internal
