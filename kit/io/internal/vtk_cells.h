// SPDX-License-Identifier: Apache-2.0
// VTK's numbered cell types <-> elements; shared by VTU and legacy VTK.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <solidsubdiv/kit/io/internal/mesh_builder.h>

namespace SolidSubdiv::Io::Internal {

inline constexpr int kVtkPolyhedron = 42;

/// Adds the cell as the next row. Pixels, voxels, strips and polylines become our kinds. Polyhedra come with the stream
/// of their faces (their number, then for each its size and vertices); it is unused otherwise.
/// @throws IoError for cells that we don't have, by name
void AddVtkCell(MeshBuilder& builder, std::int64_t type, std::span<const std::int64_t> points,
                std::span<const std::int64_t> face_stream);

/// All elements of a mesh, in its order, as VTK has them.
struct VtkCells {
    std::vector<std::uint8_t> types;
    std::vector<Index> connectivity;  ///< of polyhedra: each vertex once
    std::vector<Offset> ends;         ///< per cell, into connectivity
    std::vector<Index>
        face_streams;  ///< of octahedra and polyhedra: number of faces, then for each its size and vertices
    std::vector<Offset>
        stream_ends;  ///< per cell, into face_streams; -1 for the others. Empty if there are none at all.
};
VtkCells MakeVtkCells(const Topology& topology);

}  // namespace SolidSubdiv::Io::Internal
