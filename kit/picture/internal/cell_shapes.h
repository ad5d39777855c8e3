// SPDX-License-Identifier: Apache-2.0
// Faces of every kind of cell that pictures show.
#pragma once

#include <array>
#include <span>
#include <vector>

#include <solidsubdiv/kit/io/mesh.h>
#include <solidsubdiv/kit/picture/cut.h>

namespace SolidSubdiv::Picture::Internal {

using LocalFace = std::array<int, 4>;  ///< counterclockwise from outside; the fourth is -1 in triangles

/// A kind of cell, in the vertex order of sdc/cells.h (tets, octs) or VTK (the others).
struct CellShape {
    CellKind kind;
    std::size_t n_vertices;
    std::vector<LocalFace> faces;
};

const std::array<CellShape, 5>& CellShapes();

std::span<const Index> CellsOf(const Io::Topology& topology, CellKind kind);

/// Calls visit(shape, vertices) for every cell.
template <class Visit>
void ForEachCell(const Io::Topology& topology, Visit&& visit) {
    for (const CellShape& shape : CellShapes()) {
        const std::span<const Index> cells = CellsOf(topology, shape.kind);
        for (std::size_t c = 0; c + shape.n_vertices <= cells.size(); c += shape.n_vertices) {
            visit(shape, cells.subspan(c, shape.n_vertices));
        }
    }
}

/// @throws InvalidInput
void RefusePolyhedra(const Io::Topology& topology);

/// @throws InvalidInput unless the normal is a direction
void CheckPlane(const Plane& plane);

/// The edges, each once, ordered, as one flat array.
std::vector<Index> UniqueEdges(std::vector<std::array<Index, 2>> edges);

}  // namespace SolidSubdiv::Picture::Internal
