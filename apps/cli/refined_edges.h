// SPDX-License-Identifier: Apache-2.0
// What becomes of the control mesh's edges in no face: curves, halved at each level.
#pragma once

#include <vector>

#include <solidsubdiv/far/topology_refiner.h>
#include <solidsubdiv/kit/io/mesh.h>

namespace SolidSubdiv::Cli {

class RefinedEdges {
  public:
    /// Both must outlive this.
    RefinedEdges(const Io::Topology& control, const Far::TopologyRefiner& refiner);

    /// Edges of the control mesh that have children: the others lie on a face or a cell.
    Offset n_parts() const { return static_cast<Offset>(parts_.size()); }
    /// (n, 2): the ends of a level's edges.
    std::vector<Index> At(int level) const;
    /// For each of them which of the control mesh's edges it comes from.
    std::vector<Index> Origins(int level) const;

  private:
    struct Part {
        Index element;  ///< among the control mesh's edges
        Index edge;     ///< in level 0
    };
    const Far::TopologyRefiner& refiner_;
    std::vector<Part> parts_;
};

}  // namespace SolidSubdiv::Cli
