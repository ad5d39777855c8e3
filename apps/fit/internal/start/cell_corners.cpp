// SPDX-License-Identifier: Apache-2.0
// Tables of corners, cell by cell.
#include <solidsubdiv/apps/fit/internal/start/cell_corners.h>

#include <solidsubdiv/sdc/cells.h>

namespace SolidSubdiv::Fit::Starting {

namespace {

/// Ends of the edges at corner j of a hexahedron in VTK's order.
constexpr std::size_t kHexCorners[8][3] = {{1, 3, 4}, {2, 0, 5}, {3, 1, 6}, {0, 2, 7},
                                           {7, 5, 0}, {4, 6, 1}, {5, 7, 2}, {6, 4, 3}};
constexpr std::size_t kTetCorners[4][4] = {{0, 1, 2, 3}, {1, 0, 3, 2}, {2, 0, 1, 3}, {3, 0, 2, 1}};

}  // namespace

std::vector<CellCorner> CornersOf(const ControlMesh& mesh) {
    std::vector<CellCorner> corners;
    for (std::size_t c = 0; c < mesh.hexes.size(); c += 8) {
        const Index* const v = &mesh.hexes[c];
        for (std::size_t j = 0; j < 8; ++j) {
            const auto& e = kHexCorners[j];
            corners.push_back({{v[j], v[e[0]], v[e[1]], v[e[2]]}, 1});
        }
    }
    const auto add_tet = [&](const std::array<Index, 4>& v) {
        const double ideal = std::sqrt(.5);
        for (const auto& e : kTetCorners) corners.push_back({{v[e[0]], v[e[1]], v[e[2]], v[e[3]]}, ideal});
    };
    for (std::size_t c = 0; c < mesh.tets.size(); c += 4) {
        add_tet({mesh.tets[c], mesh.tets[c + 1], mesh.tets[c + 2], mesh.tets[c + 3]});
    }
    for (std::size_t c = 0; c < mesh.octs.size(); c += 6) {
        for (const auto& t : Sdc::Oct::tets) {
            add_tet({mesh.octs[c + t[0]], mesh.octs[c + t[1]], mesh.octs[c + t[2]], mesh.octs[c + t[3]]});
        }
    }
    return corners;
}

}  // namespace SolidSubdiv::Fit::Starting
