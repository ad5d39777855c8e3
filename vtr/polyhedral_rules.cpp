// SPDX-License-Identifier: Apache-2.0
// Rules of a complex of polyhedra.
#include <solidsubdiv/vtr/internal/polyhedral_rules.h>

#include <algorithm>
#include <array>

#include <solidsubdiv/sdc/hex_split.h>
#include <solidsubdiv/vtr/grouping.h>
#include <solidsubdiv/vtr/internal/vertex_tagger.h>

namespace SolidSubdiv::Vtr::Internal {

namespace {

using Sdc::Hex;

/// The three faces at each corner of a hexahedron.
constexpr std::array<std::array<int, 3>, Hex::kVertices> kFacesAtCorner = [] {
    std::array<std::array<int, 3>, Hex::kVertices> table{};
    for (int i = 0; i < Hex::kVertices; ++i) {
        int n = 0;
        for (int f = 0; f < Hex::kFaces; ++f) {
            if (Sdc::Internal::CornerOfFace(f, i) >= 0) table[i][n++] = f;
        }
    }
    return table;
}();

/// A level as VertexTagger asks for it.
class PolyhedralComplex {
  public:
    explicit PolyhedralComplex(const PolyhedralLevel& level) : level_(level) {}

    const Relation& vertex_edges() const { return level_.vertex_edges; }
    const Relation& edge_faces() const { return level_.edge_faces; }
    const Array<Tag>& edge_tags() const { return level_.edge_tags; }
    int NCells(Index f) const { return level_.NCells(f); }
    std::size_t NCellsAt(Index v) const { return level_.vertex_cells[v].size(); }
    std::size_t MaxCellFacesAt(Index v) const {
        std::size_t n = 0;
        ForCellFacesAt(v, [&](std::size_t, Index) { ++n; });
        return n;
    }

    template <class OnFace>
    void ForCellFacesAt(Index v, OnFace&& on_face) const {
        const auto cells = level_.vertex_cells[v];
        for (std::size_t i = 0; i < cells.size(); ++i) {
            const auto vertices = level_.CellVertices(cells[i]);
            const auto faces = level_.CellFaces(cells[i]);
            const std::ptrdiff_t corner = std::find(vertices.begin(), vertices.end(), v) - vertices.begin();
            if (level_.IsHex(cells[i])) {
                for (int f : kFacesAtCorner[static_cast<std::size_t>(corner)])
                    on_face(i, faces[static_cast<std::size_t>(f)]);
                continue;
            }
            const Polyhedra& p = level_.polyhedra;
            const Offset at = p.vertex_offsets[cells[i] - level_.n_hexes] + corner;
            for (Offset k = p.ring_offsets[at]; k < p.ring_offsets[at + 1]; ++k) {
                on_face(i, faces[static_cast<std::size_t>(p.ring_faces[k])]);
            }
        }
    }

    Index OtherEdgeAt(Index v, Index f, Index e) const {
        const auto vertices = level_.FaceVertices(f);
        const auto edges = level_.FaceEdges(f);
        const std::size_t n = vertices.size();
        const std::size_t k =
            static_cast<std::size_t>(std::find(vertices.begin(), vertices.end(), v) - vertices.begin());
        const Index before = edges[k > 0 ? k - 1 : n - 1];
        return edges[k] == e ? before : edges[k];
    }

  private:
    const PolyhedralLevel& level_;
};

}  // namespace

Relation CellsAtVertices(const PolyhedralLevel& level) {
    Relation r;
    const Polyhedra& p = level.polyhedra;
    if (level.hex_vertices.empty() && p.vertices.empty()) return r;
    const auto visit = [&](auto&& add) {
        const Index* v = level.hex_vertices.data();
        for (Index c = 0; c < level.n_hexes; ++c) {
            for (int k = 0; k < Hex::kVertices; ++k) add(*v++, c);
        }
        for (Index c = 0; c < p.size(); ++c) {
            for (Index vertex : level.CellVertices(level.n_hexes + c)) add(vertex, level.n_hexes + c);
        }
    };
    r.offsets = CountRows(level.n_vertices, visit);
    r.items.resize(level.hex_vertices.size() + p.vertices.size());
    FillRows(r.offsets, visit, [&](Offset place, Index c) { r.items[place] = c; });
    return r;
}

void TagEdgesAndVertices(PolyhedralLevel& level) {
    level.edge_tags.resize(static_cast<std::size_t>(level.n_edges));
    level.vertex_tags.resize(static_cast<std::size_t>(level.n_vertices));
    TagEdgesAndVertices(PolyhedralComplex(level), level.edge_tags, level.vertex_tags);
}

}  // namespace SolidSubdiv::Vtr::Internal
