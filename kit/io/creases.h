// SPDX-License-Identifier: Apache-2.0
// Creases and corners of a mesh: edges and vertices as elements of their own, with cell data `sharpness`.
//
// A file's way to say that an edge is a crease, or a vertex a corner, is an element of that dimension which coincides
// with a part of higher elements, and a number for it. Readers keep both as they are; the rules get them as a list:
//
//     Io::Mesh mesh = Io::ReadMesh("cube.obj");      // `t crease` and `t corner` lines, or elements of a .vtu
//     Io::Creases creases = Io::CreasesOf(mesh);
//
// Sharpness is the number of refinement steps that an edge stays sharp for; it may be broken. 0 is no crease, 10 and
// more stay sharp for ever, as in OpenSubdiv.
#pragma once

#include <string_view>
#include <vector>

#include <solidsubdiv/kit/io/mesh.h>

namespace SolidSubdiv::Io {

/// Name of the cell data, one number an element.
inline constexpr std::string_view kSharpness = "sharpness";
/// Sharp for ever.
inline constexpr float kInfinitelySharp = 10;

struct Creases {
    std::vector<Index> edge_vertices{};     ///< (n_edges, 2), row-major; no pair twice, in either order
    std::vector<float> edge_sharpness{};    ///< (n_edges), (0, 10]
    std::vector<Index> vertices{};          ///< (n_vertices); none twice
    std::vector<float> vertex_sharpness{};  ///< (n_vertices), (0, 10]

    bool empty() const { return edge_vertices.empty() && vertices.empty(); }

    /// Lets a descriptor see these; it must not outlive them.
    void AddTo(Far::TopologyDescriptor& descriptor) const {
        descriptor.crease_edges = edge_vertices;
        descriptor.crease_sharpness = edge_sharpness;
        descriptor.corner_vertices = vertices;
        descriptor.corner_sharpness = vertex_sharpness;
    }
};

/// The mesh's sharpness, if it has cell data of that name and of width 1; else null.
const Attribute* FindSharpness(const Mesh& mesh);

/// The edge and vertex elements of sharpness greater than 0, in the order in which they first come. The largest
/// sharpness counts where several elements have the same vertices; 10 stands for all above. Whether an edge lies on
/// anything is not asked. Cost: linear.
/// @throws InvalidInput if the sharpness of an edge or vertex is negative or NaN, or `sharpness` has not one number an
/// element
Creases CreasesOf(const Mesh& mesh);

/// Makes these, and no others, the mesh's creases: the `sharpness` of edge and vertex elements that are there already,
/// and of new ones behind them for the rest; 0 for all other elements, and in new rows of other cell data. Without
/// creases the mesh has no such attribute. Sharpness of 0 is skipped.
/// @throws InvalidInput naming the crease if an array's length, a vertex or a sharpness is wrong; the mesh is then as
/// it was
void SetCreases(Mesh& mesh, const Creases& creases);

}  // namespace SolidSubdiv::Io
