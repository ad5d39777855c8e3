// SPDX-License-Identifier: Apache-2.0
// Surface faces that take part in refinement and whose children are not written, and the vertices that go with them.
#pragma once

#include <span>
#include <vector>

#include <solidsubdiv/far/topology_refiner.h>
#include <solidsubdiv/kit/io/mesh.h>

namespace SolidSubdiv::Cli {

struct FacesLeftOut {
    bool border = false;          ///< those at the border of open surfaces (OpenSubdiv's VTX_BOUNDARY_NONE)
    std::vector<Offset> holes{};  ///< rows of the control mesh's cell data, ascending
};

/// A surface element of the control mesh that has children.
struct FacePart {
    Offset row;   ///< of the control mesh's cell data
    Index place;  ///< its boundary face in level 0
};

/// Takes the parts away that are left out. @returns their places
std::vector<Index> TakeLeftOut(std::vector<FacePart>& parts, const FacesLeftOut& left_out,
                               const Far::TopologyRefiner& refiner);

/// Ascending: all vertices of a level but those of its boundary that no element of the topology has.
std::vector<Index> VerticesInUse(const Io::Topology& topology, std::span<const Index> boundary_corners);

/// Of each of n vertices its place among the kept ones, or kNoIndex.
std::vector<Index> NewNumbers(const std::vector<Index>& kept, Index n_vertices);

/// Leaves these vertices, in this order. @pre ascending; elements have no others
void KeepVertices(Io::Mesh& mesh, const std::vector<Index>& kept);

}  // namespace SolidSubdiv::Cli
