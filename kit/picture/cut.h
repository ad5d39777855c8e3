// SPDX-License-Identifier: Apache-2.0
// What is seen of a solid from outside, whole or with the cells on one side of a plane taken away. See slice.h for
// smooth cuts.
//
//     Picture::SolidFaces cut = Picture::CutSolid(mesh, {.point = {0, 0, 0}, .normal = {1, 0, 0}});
//     scene.Add(Picture::Surface{.positions = mesh.positions, .triangles = cut.triangles,
//                                .triangle_colors = cut.ColorsByKind()});
//     scene.Add(Picture::Lines{.positions = mesh.positions, .edges = cut.edges});
#pragma once

#include <array>
#include <vector>

#include <solidsubdiv/kit/io/mesh.h>
#include <solidsubdiv/kit/picture/color.h>

namespace SolidSubdiv::Picture {

enum class CellKind : unsigned char { Tet, Oct, Hex, Wedge, Pyramid, Polyhedron };

/// The colour of a kind of cell in the project's pictures.
Color ColorOf(CellKind kind);

/// What lies on the side to which `normal` points is taken away.
struct Plane {
    std::array<double, 3> point{};
    std::array<double, 3> normal{1, 0, 0};  ///< any length but zero
};

/// Visible faces of the cells that are left. Indices are the mesh's own; triangles are counterclockwise from outside.
struct SolidFaces {
    std::vector<Index> triangles;       ///< (n, 3); larger faces are fans of triangles
    std::vector<CellKind> kinds;        ///< (n): of the cell behind each triangle
    std::vector<Index> cells;           ///< (n): its number among the mesh's cells, in the order of cell data
    std::vector<unsigned char> opened;  ///< (n): 1 where the cut opened the solid, 0 on the solid's own boundary
    std::vector<Index> edges;           ///< (m, 2): sides of the faces where the cut opened the solid, each once

    std::vector<Color> ColorsByKind() const;
    /// The solid's own boundary in one colour, what the cut opened by kind of cell.
    std::vector<Color> ColorsByKind(Color skin) const;
};

/// The boundary of the whole solid. @pre indices are in range (io guarantees it). Cost: all faces pass once.
SolidFaces SolidBoundary(const Io::Mesh& mesh);

/// The boundary of the cells whose centroid the plane leaves: whole cells, a rough cut that shows their shapes.
/// @throws InvalidInput for a plane without direction
SolidFaces CutSolid(const Io::Mesh& mesh, const Plane& plane);

/// The edges of a mesh's elements of every kind, each once, as pairs of vertices: what shows a control lattice.
std::vector<Index> ElementEdges(const Io::Topology& topology);

}  // namespace SolidSubdiv::Picture
