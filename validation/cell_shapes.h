// SPDX-License-Identifier: Apache-2.0
// Solids of cells of every kind, one for each feature, and what the framework takes of them.
#pragma once

#include <array>
#include <string>
#include <vector>

#include <solidsubdiv/far/topology_descriptor.h>

#include "surface_levels.h"

namespace SolidSubdiv::Validation {

struct CellShape {
    std::string name;
    std::vector<std::array<int, 8>> hexes;    ///< in VTK's order
    std::vector<std::vector<Polygon>> cells;  ///< others by their faces, counterclockwise from outside
    std::vector<double> positions;            ///< (n_vertices, 3), shaken
};

/// Flat arrays of a shape and a descriptor of them.
class DescribedCells {
  public:
    explicit DescribedCells(const CellShape& shape);
    DescribedCells(const DescribedCells&) = delete;
    DescribedCells& operator=(const DescribedCells&) = delete;

    Far::TopologyDescriptor descriptor;

  private:
    std::vector<Index> hexes_, vertices_;
    std::vector<Offset> offsets_{0}, face_offsets_{0};
};

/// Two layers of n cells around an edge: hexahedra, wedges, or both in turn.
enum class CellsAround { Hexes, Wedges, InTurn };
CellShape CellsAroundEdge(int n, CellsAround kind);

/// HexShapes; 3 to 8 cells around an edge; pyramids, prisms and a cell with corners of four and five edges.
std::vector<CellShape> CellShapes();

}  // namespace SolidSubdiv::Validation
