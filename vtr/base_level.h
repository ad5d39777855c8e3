// SPDX-License-Identifier: Apache-2.0
// Level 0: edges, faces and tags found from the caller's cells, triangles and edges.
//
// Faces and edges are numbered in lexicographic order of their ascending vertices, whatever the order of the cells.
#pragma once

#include <span>
#include <vector>

#include <solidsubdiv/vtr/level.h>

namespace SolidSubdiv::Vtr {

/// The elements of a complex. @pre every index in [0, n_vertices), no vertex twice in an element
struct BaseElements {
    Index n_vertices = 0;
    std::span<const Index> tets{};       ///< (n, 4)
    std::span<const Index> octs{};       ///< (n, 6)
    std::span<const Index> triangles{};  ///< (n, 3)
    std::span<const Index> edges{};      ///< (n, 2)
};

/// What was found besides the level itself: each entry counts elements of the kind that it names.
struct BaseFindings {
    std::vector<Index> faces_in_three_cells;  ///< faces of the level; if any, tags are not made and the level not full
    std::vector<Index> duplicate_triangles;   ///< triangles with the vertices of an earlier one
    std::vector<Index> duplicate_edges;
    std::vector<Index> coincident_triangles;  ///< triangles on a face of a cell: tags
    std::vector<Index> coincident_edges;      ///< edges on an edge of a cell or triangle: tags
    std::vector<Index> flipped_faces;         ///< inner faces that both cells see alike

    bool IsUsable() const {
        return faces_in_three_cells.empty() && duplicate_triangles.empty() && duplicate_edges.empty();
    }
};

/// Cost: sorts of short rows; parallel, the same bits for any number of threads.
Level MakeBaseLevel(const BaseElements& elements, BaseFindings& findings);

}  // namespace SolidSubdiv::Vtr
