// SPDX-License-Identifier: Apache-2.0
// Tables of corners, cell by cell.
#include <solidsubdiv/apps/fit/internal/start/cell_corners.h>

#include <solidsubdiv/apps/fit/internal/cell_volumes.h>

namespace SolidSubdiv::Fit::Starting {

std::vector<CellCorner> CornersOf(const ControlMesh& mesh) {
    constexpr std::size_t kTetCorners[4][4] = {{0, 1, 2, 3}, {1, 0, 3, 2}, {2, 0, 1, 3}, {3, 0, 2, 1}};
    std::vector<CellCorner> corners;
    for (const auto& v : CellCornersOf(mesh)) {
        if (corners.size() < mesh.hexes.size()) {  // as many as the vertices of hexahedra
            corners.push_back({v, 1});
            continue;
        }
        for (const auto& e : kTetCorners) corners.push_back({{v[e[0]], v[e[1]], v[e[2]], v[e[3]]}, std::sqrt(.5)});
    }
    return corners;
}

}  // namespace SolidSubdiv::Fit::Starting
