// SPDX-License-Identifier: Apache-2.0
// Corners, cell by cell.
#include <solidsubdiv/apps/fit/internal/cell_volumes.h>

#include <solidsubdiv/sdc/cells.h>

namespace SolidSubdiv::Fit::Internal {

std::vector<std::array<Index, 4>> CellCornersOf(const ControlMesh& mesh) {
    /// Ends of the edges at corner j of a hexahedron in VTK's order.
    constexpr std::size_t kHexEdges[8][3] = {{1, 3, 4}, {2, 0, 5}, {3, 1, 6}, {0, 2, 7},
                                             {7, 5, 0}, {4, 6, 1}, {5, 7, 2}, {6, 4, 3}};
    std::vector<std::array<Index, 4>> corners;
    for (std::size_t c = 0; c < mesh.hexes.size(); c += 8) {
        const Index* const v = &mesh.hexes[c];
        for (std::size_t j = 0; j < 8; ++j) {
            const auto& e = kHexEdges[j];
            corners.push_back({v[j], v[e[0]], v[e[1]], v[e[2]]});
        }
    }
    for (std::size_t c = 0; c < mesh.tets.size(); c += 4) {
        const Index* const v = &mesh.tets[c];
        corners.push_back({v[0], v[1], v[2], v[3]});
    }
    for (std::size_t c = 0; c < mesh.octs.size(); c += 6) {
        const Index* const v = &mesh.octs[c];
        for (const auto& t : Sdc::Oct::tets) corners.push_back({v[t[0]], v[t[1]], v[t[2]], v[t[3]]});
    }
    return corners;
}

}  // namespace SolidSubdiv::Fit::Internal
