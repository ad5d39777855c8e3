// SPDX-License-Identifier: Apache-2.0
// The elements of a refined level as a mesh for files, each with the control element that it comes from.
//
// A level numbers children by their parents, so both are arithmetic: tet t has the tets 4t .. 4t + 3 and the oct t, oct
// o the tets 4T + 8o .. and the octs T + 6o .., boundary face b the faces 4b .., edge e the edges 2e, 2e + 1.
#pragma once

#include <vector>

#include <solidsubdiv/apps/cli/refined_edges.h>
#include <solidsubdiv/far/topology_refiner.h>
#include <solidsubdiv/kit/io/mesh.h>

namespace SolidSubdiv::Cli {

class RefinedElements {
  public:
    /// `control` is what the refiner was made from; both must outlive this.
    /// @param drop_border leave out triangles that touch the border of an open surface
    RefinedElements(const Io::Topology& control, const Far::TopologyRefiner& refiner, bool drop_border = false);

    /// Triangles and edges of the control mesh that lie on a part of higher dimension: tags, which have no children.
    Offset n_tags() const { return n_tags_; }

    /// A level's tets, octs, triangles that bound no cell, and edges in no face.
    Io::Topology At(int level) const;

    /// For each element of At(level), in its order, the control mesh's row of cell data.
    std::vector<Offset> ControlRows(int level) const;

  private:
    struct Part {
        Index element;  ///< among the control mesh's triangles
        Index place;    ///< its boundary face in level 0
    };
    void FindTriangles();
    void DropBorder();

    const Io::Topology& control_;
    const Far::TopologyRefiner& refiner_;
    std::vector<Part> triangles_;
    RefinedEdges edges_;
    Offset n_tags_ = 0;
};

/// Rows of an attribute by element of the refined mesh.
Io::Attribute InheritedRows(const Io::Attribute& control, const std::vector<Offset>& control_rows);

}  // namespace SolidSubdiv::Cli
