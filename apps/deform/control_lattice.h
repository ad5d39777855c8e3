// SPDX-License-Identifier: Apache-2.0
// A control lattice: cells of any kind and where their vertices, the control points, are.
#pragma once

#include <vector>

#include <solidsubdiv/far/topology_descriptor.h>

namespace SolidSubdiv::Deform {

/// Owns what Far::TopologyDescriptor views (same names, shapes and vertex orders). Cells count as a polyhedral level
/// has them: hexes, then tets, octs, wedges, pyramids, polyhedra.
struct ControlLattice {
    std::vector<double> positions;  ///< (n_control_points, 3)
    std::vector<Index> hexes;       ///< (n, 8)
    std::vector<Index> tets;        ///< (n, 4)
    std::vector<Index> octs;        ///< (n, 6)
    std::vector<Offset> polyhedron_offsets, polyhedron_face_offsets;
    std::vector<Index> polyhedron_vertices;

    Index n_control_points() const { return static_cast<Index>(positions.size() / 3); }
    Index n_polyhedra() const {
        return polyhedron_offsets.empty() ? 0 : static_cast<Index>(polyhedron_offsets.size()) - 1;
    }
    Index n_cells() const {
        return static_cast<Index>(hexes.size() / 8 + tets.size() / 4 + octs.size() / 6) + n_polyhedra();
    }
    /// Valid while this lives and its arrays are not resized.
    Far::TopologyDescriptor View() const {
        return {.n_vertices = n_control_points(),
                .tets = tets,
                .octs = octs,
                .hexes = hexes,
                .polyhedron_offsets = polyhedron_offsets,
                .polyhedron_face_offsets = polyhedron_face_offsets,
                .polyhedron_vertices = polyhedron_vertices};
    }
};

}  // namespace SolidSubdiv::Deform
