// SPDX-License-Identifier: Apache-2.0
// A control mesh that owns its arrays: a lattice of cells, or a cage of faces.
#pragma once

#include <span>
#include <vector>

#include <solidsubdiv/far/topology_descriptor.h>

namespace SolidSubdiv::Fit {

/// Arrays have the names, shapes and vertex orders of Far::TopologyDescriptor.
struct ControlMesh {
    std::vector<double> positions{};    ///< (n_vertices, 3)
    std::vector<Index> tets{};          ///< (n, 4)
    std::vector<Index> octs{};          ///< (n, 6)
    std::vector<Index> hexes{};         ///< (n, 8)
    std::vector<Index> triangles{};     ///< (n, 3)
    std::vector<Index> quads{};         ///< (n, 4)
    std::vector<Index> crease_edges{};  ///< (n, 2)
    std::vector<float> crease_sharpness{};
    std::vector<Index> corner_vertices{};
    std::vector<float> corner_sharpness{};

    Index n_vertices() const { return static_cast<Index>(positions.size() / 3); }
    bool is_solid() const { return !tets.empty() || !octs.empty() || !hexes.empty(); }
    /// Valid while this lives and its arrays are not resized.
    Far::TopologyDescriptor View() const {
        return {.n_vertices = n_vertices(),
                .tets = tets,
                .octs = octs,
                .hexes = hexes,
                .triangles = triangles,
                .quads = quads,
                .crease_edges = crease_edges,
                .crease_sharpness = crease_sharpness,
                .corner_vertices = corner_vertices,
                .corner_sharpness = corner_sharpness};
    }
};

/// A surface to be met: triangles, or points alone. Views of the caller's arrays.
struct TargetSurface {
    std::span<const double> positions{};  ///< (n, 3)
    std::span<const Index> triangles{};   ///< (n, 3), counterclockwise from outside; empty: points alone
    std::span<const double> normals{};    ///< (n, 3) of length 1, or empty; of points alone

    /// @throws InvalidInput where there is no point, a coordinate is not finite or beyond 1e75, all points are within
    /// 1e-75, a triangle names a point that is not there or one twice, or normals are not one a point
    void Validate() const;
};

}  // namespace SolidSubdiv::Fit
