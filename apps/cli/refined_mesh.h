// SPDX-License-Identifier: Apache-2.0
// The elements of a refined level as a mesh for files, each with the control element that it comes from.
//
// A level numbers children by their parents, so both are arithmetic: tet t has the tets 4t .. 4t + 3 and the oct t, oct
// o the tets 4T + 8o .. and the octs T + 6o .., boundary face b the faces 4b .., edge e the edges 2e, 2e + 1.
#pragma once

#include <vector>

#include <solidsubdiv/apps/cli/left_out.h>
#include <solidsubdiv/apps/cli/refined_edges.h>
#include <solidsubdiv/far/topology_refiner.h>
#include <solidsubdiv/kit/io/mesh.h>

namespace SolidSubdiv::Cli {

class RefinedElements {
  public:
    /// `control` is what the refiner was made from; both must outlive this.
    RefinedElements(const Io::Topology& control, const Far::TopologyRefiner& refiner,
                    const FacesLeftOut& left_out = {});

    /// Triangles and edges of the control mesh that lie on a part of higher dimension: tags, which have no children.
    Offset n_tags() const { return n_tags_; }

    /// A level's tets, octs, triangles that bound no cell, and edges in no face.
    Io::Topology At(int level) const;

    /// For each element of At(level), in its order, the control mesh's row of cell data.
    std::vector<Offset> ControlRows(int level) const;

    /// Faces of the control mesh that are left out.
    Offset n_left_out() const { return static_cast<Offset>(left_out_.size()); }
    /// For each boundary face of a level whether it is left out; empty: none is.
    std::vector<bool> LeftOut(int level) const;

  private:
    void FindTriangles();

    const Io::Topology& control_;
    const Far::TopologyRefiner& refiner_;
    std::vector<FacePart> triangles_;
    std::vector<Index> left_out_;  // boundary faces of level 0
    RefinedEdges edges_;
    Offset n_tags_ = 0;
};

/// Rows of an attribute by element of the refined mesh.
Io::Attribute InheritedRows(const Io::Attribute& control, const std::vector<Offset>& control_rows);

}  // namespace SolidSubdiv::Cli
