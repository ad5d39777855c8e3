// SPDX-License-Identifier: Apache-2.0
// Vertices at the same place.
#include <solidsubdiv/kit/geometry/coincident_vertices.h>

#include <algorithm>
#include <numeric>
#include <tuple>

namespace SolidSubdiv::Geometry {

std::vector<Index> FindCoincidentVertices(std::span<const double> positions) {
    const auto place = [&](Index v) {
        const double* p = positions.data() + 3 * static_cast<std::size_t>(v);
        return std::tie(p[0], p[1], p[2]);
    };
    std::vector<Index> order(positions.size() / 3);
    std::iota(order.begin(), order.end(), Index{0});
    std::sort(order.begin(), order.end(),
              [&](Index a, Index b) { return place(a) != place(b) ? place(a) < place(b) : a < b; });
    std::vector<Index> found;
    for (std::size_t i = 1; i < order.size(); ++i) {
        if (place(order[i]) == place(order[i - 1])) found.push_back(order[i]);
    }
    std::sort(found.begin(), found.end());
    return found;
}

}  // namespace SolidSubdiv::Geometry
