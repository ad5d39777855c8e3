// SPDX-License-Identifier: Apache-2.0
// What the split makes at the corners of cells that are no hexahedra.
#pragma once

#include <vector>

#include <solidsubdiv/vtr/polyhedral_level.h>

namespace SolidSubdiv::Vtr::Internal {

/// The child at a corner of n edges e0 e1 ... and faces f0 (between e0 and e1) f1 ..., counterclockwise from outside.
/// Its corners: the vertex, the points on the edges, in the faces, in the cell. Its edges: halves of the edges; in each
/// face to the point before and to the one after; from each face to the cell. Its faces: on the faces; across the
/// edges.
class OddCell {
  public:
    void Start(int n) {
        n_ = n;
        vertices.resize(static_cast<std::size_t>(2 * n + 2));
        edges.resize(static_cast<std::size_t>(4 * n));
        faces.resize(static_cast<std::size_t>(2 * n));
    }
    int n() const { return n_; }
    std::size_t EdgePoint(int j) const { return Place(1 + j); }
    std::size_t FacePoint(int j) const { return Place(1 + n_ + j); }
    std::size_t Centre() const { return Place(2 * n_ + 1); }
    std::size_t Half(int j) const { return Place(j); }
    /// In face j to the point of edge j (0) or j + 1 (1).
    std::size_t OnFace(int j, int which) const { return Place(n_ + 2 * j + which); }
    std::size_t Inner(int j) const { return Place(3 * n_ + j); }
    std::size_t OuterFace(int j) const { return Place(j); }
    std::size_t InnerFace(int j) const { return Place(n_ + j); }

    std::vector<Index> vertices, edges, faces;

  private:
    static std::size_t Place(int i) { return static_cast<std::size_t>(i); }
    int n_ = 0;
};

/// Corners of cells other than hexahedra where other than three edges meet.
struct OddCorners {
    Offset n = 0, n_edges = 0;  ///< and the sum of their numbers of edges
    void Add(Offset degree) {
        ++n;
        n_edges += degree;
    }
};
/// Those before each chunk of corners; the last: all of them. @pre the level is full
std::vector<OddCorners> CountOddCorners(const Polyhedra& polyhedra);

/// Numbers the children of all cells but hexahedra, and writes them: hexahedra where three edges meet.
class OddCells {
  public:
    explicit OddCells(const PolyhedralLevel& parent);

    /// Corners count through all cells but hexahedra.
    int Degree(Offset corner) const {
        return static_cast<int>(rings_[static_cast<std::size_t>(corner) + 1] -
                                rings_[static_cast<std::size_t>(corner)]);
    }
    /// The child cell at a corner.
    Index Child(Offset corner) const { return children_[static_cast<std::size_t>(corner)]; }

    void MakeRoom(Polyhedra& child, bool full) const;
    void Put(const OddCell& cell, Offset corner, bool full, PolyhedralLevel& child) const;

  private:
    const Array<Offset>& rings_;
    Index n_hexes_;               // of the child
    Array<Index> children_;       // of each corner
    Array<Offset> edges_before_;  // of each child that is no hexahedron: the sum of the degrees before it
};

}  // namespace SolidSubdiv::Vtr::Internal
