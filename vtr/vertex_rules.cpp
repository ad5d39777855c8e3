// SPDX-License-Identifier: Apache-2.0
// Rules of a complex of tets and octs.
#include <solidsubdiv/vtr/internal/vertex_rules.h>

#include <solidsubdiv/vtr/internal/vertex_tagger.h>

namespace SolidSubdiv::Vtr::Internal {

namespace {

/// A level as VertexTagger asks for it.
class TetOctComplex {
  public:
    explicit TetOctComplex(const Level& level)
        : level_(level), vertex_tets_(Invert(level.tet_vertices, 4, level.n_vertices, false)) {}

    const Relation& vertex_edges() const { return level_.vertex_edges; }
    const Relation& edge_faces() const { return level_.edge_faces; }
    const Array<Tag>& edge_tags() const { return level_.edge_tags; }
    int NCells(Index f) const { return level_.face_tags[f].n_cells(); }
    std::size_t NCellsAt(Index v) const { return vertex_tets_[v].size() + level_.vertex_octs[v].size(); }
    /// Four faces of an octahedron meet in a vertex, three of a tet.
    std::size_t MaxCellFacesAt(Index v) const { return 4 * NCellsAt(v); }

    template <class OnFace>
    void ForCellFacesAt(Index v, OnFace&& on_face) const {
        const auto tets = vertex_tets_[v];
        const auto octs = level_.vertex_octs[v];
        const auto visit = [&](std::size_t cell, std::span<const Index> faces) {
            for (Index f : faces) {
                const auto fv = level_.FaceVertices(f);
                if (fv[0] == v || fv[1] == v || fv[2] == v) on_face(cell, f);
            }
        };
        for (std::size_t i = 0; i < tets.size(); ++i) visit(i, level_.TetFaces(tets[i]));
        for (std::size_t i = 0; i < octs.size(); ++i) visit(tets.size() + i, level_.OctFaces(octs[i]));
    }

    Index OtherEdgeAt(Index v, Index f, Index e) const {
        const auto vertices = level_.FaceVertices(f);
        const auto edges = level_.FaceEdges(f);
        const Index opposite = edges[vertices[0] == v ? 0 : vertices[1] == v ? 1 : 2];
        return edges[0] + edges[1] + edges[2] - opposite - e;
    }

  private:
    const Level& level_;
    const Relation vertex_tets_;
};

}  // namespace

void TagEdgesAndVertices(Level& level) {
    level.edge_tags.resize(level.n_edges);
    level.vertex_tags.resize(level.n_vertices);
    TagEdgesAndVertices(TetOctComplex(level), level.edge_tags, level.vertex_tags);
}

}  // namespace SolidSubdiv::Vtr::Internal
