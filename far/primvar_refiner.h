// SPDX-License-Identifier: Apache-2.0
// Refines values one level at a time straight from the topology, without a table: for data that is refined once.
//
//     Far::PrimvarRefiner primvars(refiner, Sdc::BoxSpline{});
//     std::vector<double> fine(3 * refiner.level(1).n_vertices);
//     primvars.Interpolate<double>(1, coarse, fine, 3);
//
// Gives the same values as a cascaded StencilTable of doubles: bit for bit under the tet/oct split, to round-off under
// the polyhedral one, whose new points are summed from centroids.
#pragma once

#include <span>

#include <solidsubdiv/far/topology_refiner.h>
#include <solidsubdiv/sdc/schemes.h>

namespace SolidSubdiv::Far {

class PrimvarRefiner {
  public:
    /// The refiner must outlive this. @throws InvalidInput if the scheme can't refine the mesh
    PrimvarRefiner(const TopologyRefiner& refiner, const Sdc::Scheme& scheme);

    /// Values at the vertices of `level` from those of `level` - 1; rows of `width` numbers, (n_vertices, width).
    /// @pre 1 <= level <= max_level, width >= 1, source and destination do not overlap
    /// @throws InvalidInput where a span's length does not fit
    template <class Real>
    void Interpolate(int level, std::span<const Real> source, std::span<Real> destination, int width) const;

  private:
    const TopologyRefiner& refiner_;
    Sdc::Scheme scheme_;
};

}  // namespace SolidSubdiv::Far
