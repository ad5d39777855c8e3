// SPDX-License-Identifier: Apache-2.0
// What is around a place, written as a text that does not depend on numbers.
#pragma once

#include <string>
#include <vector>

#include <solidsubdiv/sdc/schemes.h>
#include <solidsubdiv/vtr/level.h>
#include <solidsubdiv/vtr/polyhedral_level.h>

namespace SolidSubdiv::Analysis::Internal {

struct PlaceCode {
    std::u16string text;  ///< empty: no such place
    std::string what;     ///< for people
};

/// Whether a scheme's rules ask where major diagonals are.
bool UsesDiagonals(const Sdc::Scheme& scheme);

class TetOctCodes {
  public:
    TetOctCodes(const Vtr::Level& level, bool uses_diagonals);

    Index n_edges() const { return level_.n_edges; }
    Index n_faces() const { return level_.n_faces; }
    Index n_cells() const { return 0; }  // places inside cells are regular

    PlaceCode InnerVertex(Index v) const;
    PlaceCode InnerEdge(Index e) const;
    PlaceCode InnerFace(Index f) const;
    PlaceCode InnerCell(Index) const { return {}; }
    PlaceCode SurfaceVertex(Index v) const;
    PlaceCode SurfaceFace(Index) const { return {}; }

  private:
    const Vtr::Level& level_;
    bool uses_diagonals_;
    Vtr::Relation vertex_tets_, edge_tets_;
    /// Of each face, from each of its cells: its kind and the vertex that the B edge lies opposite to, or where the
    /// octahedron's major diagonal ends.
    struct Side {
        Index vertex = kNoIndex;
        bool is_oct = false;
    };
    std::vector<Side> sides_;  // (n_faces, 2)
};

class PolyhedralCodes {
  public:
    explicit PolyhedralCodes(const Vtr::PolyhedralLevel& level) : level_(level) {}

    Index n_edges() const { return level_.n_edges; }
    Index n_faces() const { return level_.n_faces; }
    Index n_cells() const { return static_cast<Index>(level_.n_cells()); }

    PlaceCode InnerVertex(Index v) const;
    PlaceCode InnerEdge(Index e) const;
    PlaceCode InnerFace(Index f) const;
    PlaceCode InnerCell(Index c) const;
    PlaceCode SurfaceVertex(Index v) const;
    PlaceCode SurfaceFace(Index f) const;

  private:
    const Vtr::PolyhedralLevel& level_;
};

}  // namespace SolidSubdiv::Analysis::Internal
