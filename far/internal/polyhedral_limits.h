// SPDX-License-Identifier: Apache-2.0
// Limit masks at the vertices of a level of polyhedra.
#pragma once

#include <vector>

#include <solidsubdiv/far/internal/sharpness.h>
#include <solidsubdiv/sdc/polyhedral_masks.h>
#include <solidsubdiv/vtr/polyhedral_level.h>

namespace SolidSubdiv::Far::Internal {

/// A row while tables are made of it. Empty: the vertex has no limit.
struct MaskRow {
    std::vector<Index> indices;
    std::vector<double> weights;
};

/// Tensor products of (1, 4, 1)/6 in regular places, elsewhere from the vertex's star.
class PolyhedralLimits {
  public:
    /// @param sharpness the level's. All arguments outlive it.
    PolyhedralLimits(const Vtr::PolyhedralLevel& level, const Sharpness& sharpness, const Sdc::PolyhedralRules& rules,
                     Sdc::CreasingMethod creasing);

    MaskRow Of(Index vertex) const;

  private:
    bool IsRegularInside(Index vertex) const;
    std::vector<Index> RegularSurfaceFaces(Index vertex) const;

    const Vtr::PolyhedralLevel& level_;
    const Sharpness& sharpness_;
    const Sdc::PolyhedralRules rules_;
    const Sdc::CreasingMethod creasing_;
    const Vtr::EdgeGraph graph_;
    const SharpRules sharp_;
};

}  // namespace SolidSubdiv::Far::Internal
