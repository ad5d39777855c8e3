// SPDX-License-Identifier: Apache-2.0
// Targets of tests.
#pragma once

#include <solidsubdiv/apps/fit/fit.h>

#include <utility>
#include <vector>

namespace SolidSubdiv::Fit {

/// A surface that owns its arrays.
struct Surface {
    std::vector<double> positions;
    std::vector<Index> triangles;

    TargetSurface View() const { return {.positions = positions, .triangles = triangles, .normals = {}}; }
    void Add(const Surface& other) {
        const auto first = static_cast<Index>(positions.size() / 3);
        positions.insert(positions.end(), other.positions.begin(), other.positions.end());
        for (Index v : other.triangles) triangles.push_back(first + v);
    }
    Surface InsideOut() const {
        Surface turned = *this;
        for (std::size_t t = 0; t < triangles.size(); t += 3) std::swap(turned.triangles[t], turned.triangles[t + 1]);
        return turned;
    }
};

}  // namespace SolidSubdiv::Fit
