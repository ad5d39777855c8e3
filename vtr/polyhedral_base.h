// SPDX-License-Identifier: Apache-2.0
// Level 0 of a complex of polyhedra: edges, faces and tags found from the caller's cells, polygons and edges.
//
// Faces and edges are numbered in lexicographic order of their ascending vertices, whatever the order of the cells.
#pragma once

#include <span>
#include <vector>

#include <solidsubdiv/vtr/polyhedral_level.h>

namespace SolidSubdiv::Vtr {

/// The elements of a complex. @pre every index in [0, n_vertices), no vertex twice in an element's face or polygon
struct PolyhedralElements {
    Index n_vertices = 0;
    std::span<const Index> hexes{};  ///< (n, 8), as Sdc::Hex
    /// Other cells: cell c has the faces [cell_offsets[c], cell_offsets[c + 1]), face f of them the vertices
    /// [face_offsets[f], face_offsets[f + 1]) of face_vertices, counterclockwise from outside.
    std::span<const Offset> cell_offsets{};
    std::span<const Offset> face_offsets{};
    std::span<const Index> face_vertices{};
    std::span<const Offset> polygon_offsets{};
    std::span<const Index> polygon_vertices{};
    std::span<const Index> edges{};  ///< (n, 2)
};

/// What was found besides the level itself. Cells count as in the level: hexahedra first.
struct PolyhedralFindings {
    std::vector<Index> open_cells;            ///< whose faces do not close, or meet more than once in an edge or corner
    std::vector<Index> duplicate_cells;       ///< with the vertices of the cell on the other side of a face
    std::vector<Index> faces_in_three_cells;  ///< faces of the level
    std::vector<Index> twisted_faces;         ///< faces whose vertices stand in another order in another element
    std::vector<Index> duplicate_polygons;    ///< polygons with the vertices of an earlier one
    std::vector<Index> duplicate_edges;
    std::vector<Index> coincident_polygons;  ///< polygons on a face of a cell: tags
    std::vector<Index> coincident_edges;     ///< edges on an edge of a cell or polygon: tags
    std::vector<Index> flipped_faces;        ///< inner faces that both cells see alike
    std::vector<Index> flipped_edges;        ///< edges of surfaces that both polygons see alike

    bool IsUsable() const {
        return open_cells.empty() && duplicate_cells.empty() && faces_in_three_cells.empty() && twisted_faces.empty() &&
               duplicate_polygons.empty() && duplicate_edges.empty();
    }
};

/// If findings are not usable the level has no more than they speak of: its faces. Cost: sorts of short rows;
/// parallel, the same bits for any number of threads.
PolyhedralLevel MakePolyhedralBaseLevel(const PolyhedralElements& elements, PolyhedralFindings& findings);

}  // namespace SolidSubdiv::Vtr
