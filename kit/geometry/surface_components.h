// SPDX-License-Identifier: Apache-2.0
// The connected pieces of a surface of polygons and what kind of surface each is.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include <solidsubdiv/sdc/types.h>

namespace SolidSubdiv::Geometry {

/// One piece: faces that hang together by vertices.
struct SurfaceComponent {
    Offset n_vertices = 0;
    Offset n_edges = 0;
    Offset n_faces = 0;
    Offset n_border_edges = 0;           ///< edges of one face
    Offset n_non_manifold_edges = 0;     ///< edges of three and more faces
    Offset n_non_manifold_vertices = 0;  ///< vertices where several fans of faces meet
    Offset n_flipped_edges = 0;          ///< edges whose two faces look against each other
    Offset n_border_loops = 0;           ///< closed curves of border edges (manifolds only, else 0)

    /// Vertices - edges + faces: 2 for a sphere, 0 for a torus, 1 for a disc.
    Offset EulerCharacteristic() const { return n_vertices - n_edges + n_faces; }
    bool IsManifold() const { return n_non_manifold_edges == 0 && n_non_manifold_vertices == 0; }
    bool IsClosed() const { return n_border_edges == 0; }
    /// Number of handles; none for what is not manifold, or not consistently oriented.
    std::optional<Offset> Genus() const;
};

/// The pieces of faces, the largest (by faces) first, those of one size by their lowest vertex. Face i has the corners
/// [offsets[i], offsets[i + 1]).
/// @pre indices in [0, n_vertices), no vertex twice in a face, no face twice
/// Cost: a sort of the edges.
std::vector<SurfaceComponent> SurfaceComponents(std::span<const Offset> offsets, std::span<const Index> corners,
                                                Index n_vertices);

/// The same of triangles (n, 3).
std::vector<SurfaceComponent> SurfaceComponents(std::span<const Index> triangles, Index n_vertices);

}  // namespace SolidSubdiv::Geometry
