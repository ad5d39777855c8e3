// SPDX-License-Identifier: Apache-2.0
// A caller's mesh of any cells as level 0 of polyhedra takes it, and what is wrong with it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <solidsubdiv/far/internal/check.h>
#include <solidsubdiv/vtr/polyhedral_base.h>

namespace SolidSubdiv::Far::Internal {

/// Cells other than hexahedra as lists of faces: tets, octs, wedges, pyramids, polyhedra; faces as polygons: triangles,
/// quads, polygons. The descriptor's arrays outlive it.
class PolyhedralInput {
  public:
    explicit PolyhedralInput(const TopologyDescriptor& descriptor);
    Vtr::PolyhedralElements elements() const;
    /// Corners of the faces of all cells, before they are unique.
    Offset n_face_corners() const;

  private:
    template <class Cell>
    void AddCells(std::span<const Index> cells);
    void AddPolygons(std::span<const Index> polygons, std::size_t arity);

    const TopologyDescriptor& descriptor_;
    std::vector<Offset> cell_offsets_{0}, face_offsets_{0}, polygon_offsets_{0};
    std::vector<Index> face_vertices_, polygon_vertices_;
};

/// Array lengths, index ranges, repeated vertices: what must hold before a level is built.
void CheckPolyhedralElements(const TopologyDescriptor& descriptor, DefectList& defects);

/// Checks everything, and builds level 0 unless something is fatal. @throws InvalidInput where counts do not fit
std::optional<Vtr::PolyhedralLevel> MakeCheckedPolyhedralLevel(const TopologyDescriptor& descriptor,
                                                               DefectList& defects);

/// A cell of level 0 as the caller knows it: "hexahedron 3", "wedge 0".
std::string CellName(const TopologyDescriptor& descriptor, Index cell);

}  // namespace SolidSubdiv::Far::Internal
