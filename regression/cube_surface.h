// SPDX-License-Identifier: Apache-2.0
// The surface of a cube as a part: flat sides, sharp edges, no vertex twice.
#pragma once

#include <array>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <solidsubdiv/sdc/types.h>

namespace SolidSubdiv {

struct CubeSurface {
    std::vector<std::array<int, 3>> vertices{};  ///< in [0, n]
    std::vector<std::array<Index, 4>> quads{};   ///< counterclockwise from outside

    /// Of n x n quadrilaterals a side.
    explicit CubeSurface(int n) {
        std::map<std::array<int, 3>, Index> numbers;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            for (int side : {0, n}) {
                for (int i = 0; i < n; ++i) {
                    for (int j = 0; j < n; ++j) {
                        std::array<Index, 4> quad{};
                        constexpr int kCorners[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
                        for (std::size_t k = 0; k < 4; ++k) {
                            const std::size_t x = side > 0 ? 0 : 1;  // the other way round on the far sides
                            std::array<int, 3> at{};
                            at[axis] = side;
                            at[(axis + 1) % 3] = i + kCorners[k][x];
                            at[(axis + 2) % 3] = j + kCorners[k][1 - x];
                            const auto found = numbers.try_emplace(at, static_cast<Index>(vertices.size()));
                            if (found.second) vertices.push_back(at);
                            quad[k] = found.first->second;
                        }
                        quads.push_back(quad);
                    }
                }
            }
        }
    }
};

/// The same as the text of an OBJ file.
inline std::string CubeObj(int n) {
    const CubeSurface cube(n);
    std::ostringstream text;
    for (const auto& v : cube.vertices) text << "v " << v[0] << " " << v[1] << " " << v[2] << "\n";
    for (const auto& q : cube.quads) {
        text << "f " << q[0] + 1 << " " << q[1] + 1 << " " << q[2] + 1 << " " << q[3] + 1 << "\n";
    }
    return text.str();
}

}  // namespace SolidSubdiv
