// SPDX-License-Identifier: Apache-2.0
// What is around one vertex of a level of polyhedra, as a complex of its own.
//
// Every rule at a vertex, at its edges, faces and cells reads the cells and faces that have the vertex, and nothing
// else: refined alone, they give the same rows there. After one split the vertex and the points on its edges, in its
// faces and in its cells depend on each other only.
#pragma once

#include <vector>

#include <solidsubdiv/far/internal/sharpness.h>
#include <solidsubdiv/far/local_matrix.h>
#include <solidsubdiv/sdc/polyhedral_masks.h>

namespace SolidSubdiv::Far::Internal {

class VertexStar {
  public:
    /// @pre level.is_full; sharpness is the level's, or empty
    VertexStar(const Vtr::PolyhedralLevel& level, const Sharpness& sharpness, Index vertex);

    /// How the vertex and the points around it, one split on, move at each split. `ring` counts points of the split
    /// star, 0 is the vertex. @param creasing of the scheme
    LocalMatrix Matrix(const Sdc::PolyhedralRules& rules, Sdc::CreasingMethod creasing) const;

    /// Weights of points of the split star as weights of the level's vertices.
    void Compose(const Sdc::PolyhedralRules& rules, Sdc::CreasingMethod creasing, const LocalMatrix& matrix,
                 std::span<const double> mask, std::vector<Index>& indices, std::vector<double>& weights) const;

  private:
    Index Add(Index vertex);
    void AddSharpness(const Vtr::PolyhedralLevel& level, const Sharpness& sharpness);

    std::vector<Index> vertices_;  // the level's, by their numbers here: the vertex itself is 0
    Vtr::PolyhedralLevel star_, split_;
    Sharpness sharpness_;
};

}  // namespace SolidSubdiv::Far::Internal
