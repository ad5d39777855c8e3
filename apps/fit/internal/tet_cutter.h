// SPDX-License-Identifier: Apache-2.0
// Edges, faces and cells of a lattice cut in parts, and what is at them with them.
#pragma once

#include <array>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include <solidsubdiv/apps/fit/control_mesh.h>
#include <solidsubdiv/apps/fit/internal/vec3.h>

namespace SolidSubdiv::Fit::Internal {

/// Ends of an edge, the lower first.
using Edge = std::pair<Index, Index>;

/// Of tets and octahedra, all of them positive; so they stay.
class TetCutter {
  public:
    struct Face {
        std::array<Index, 3> vertices;  ///< counterclockwise from outside
        Index patch = 0;                ///< whatever the caller says; parts of a face have that of the face
    };

    /// The mesh must outlive this; its cells are changed here alone.
    explicit TetCutter(ControlMesh& mesh);

    const ControlMesh& mesh() const { return mesh_; }
    Vec3 At(Index v) const { return PointAt(mesh_.positions, v); }
    std::array<Index, 4> Tet(std::size_t t) const;
    std::size_t n_tets() const { return mesh_.tets.size() / 4; }
    /// Of the boundary.
    const std::vector<Face>& Faces() const { return faces_; }
    void SetPatch(std::size_t face, Index patch) { faces_[face].patch = patch; }
    std::set<Edge> BoundaryEdges() const;
    std::set<Index> BoundaryVertices() const;
    /// Of the edges of the boundary at one of its vertices.
    double MeanEdge(Index v) const;

    /// Whether the cells at a vertex are well shaped there; where not it stays.
    bool MoveIfWell(Index v, const Vec3& to);
    /// As far as cells stay well shaped.
    void MoveTowards(Index v, const Vec3& to);
    /// @param at where the new vertex is to be: as near to there, from the edge, as cells allow
    /// @returns its number
    Index CutEdge(Index u, Index v, const Vec3& at);
    /// @param face of the boundary
    Index CutFace(const std::array<Index, 3>& face, const Vec3& at);
    Index CutTet(const std::array<Index, 4>& tet);
    /// Into tets around its major diagonal.
    void CutOct(std::size_t o);

  private:
    Index AddVertex(const Vec3& at);
    void CutOctsAt(std::span<const Index> vertices);
    /// Parts of a tet: for each of these vertices the tet with c in its place.
    void ReplaceTet(std::size_t t, std::span<const Index> vertices, Index c);
    double LeastQuality(Index v) const;

    ControlMesh& mesh_;
    std::vector<Face> faces_;
};

}  // namespace SolidSubdiv::Fit::Internal
