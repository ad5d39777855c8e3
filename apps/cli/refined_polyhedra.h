// SPDX-License-Identifier: Apache-2.0
// The elements of a level of the polyhedral split as a mesh for files, each with the control element that it comes
// from.
#pragma once

#include <vector>

#include <solidsubdiv/apps/cli/left_out.h>
#include <solidsubdiv/apps/cli/refined_edges.h>
#include <solidsubdiv/far/topology_refiner.h>
#include <solidsubdiv/kit/io/mesh.h>

namespace SolidSubdiv::Cli {

class RefinedPolyhedra {
  public:
    /// As RefinedElements.
    RefinedPolyhedra(const Io::Topology& control, const Far::TopologyRefiner& refiner,
                     const FacesLeftOut& left_out = {});

    Offset n_tags() const { return n_tags_; }
    Io::Topology At(int level) const;
    std::vector<Offset> ControlRows(int level) const;
    Offset n_left_out() const { return static_cast<Offset>(left_out_.size()); }
    std::vector<bool> LeftOut(int level) const;

  private:
    void FindFaces();
    /// Corners of a face's children at a level start at boundary face First(part, level).
    Offset First(Index boundary_face, int level) const;

    const Io::Topology& control_;
    const Far::TopologyRefiner& refiner_;
    std::vector<FacePart> faces_;
    std::vector<Index> left_out_;  // boundary faces of level 0
    RefinedEdges edges_;
    Offset n_tags_ = 0;
};

/// Adds faces to triangles, quads and polygons, by their numbers of corners.
void AddPolygons(const Vtr::RowOffsets& rows, std::span<const Index> corners, Io::Topology& topology);

}  // namespace SolidSubdiv::Cli
