// SPDX-License-Identifier: Apache-2.0
// Axis-aligned boxes around points.
#include <solidsubdiv/kit/geometry/box.h>

#include <algorithm>
#include <cmath>

namespace SolidSubdiv::Geometry {

void Box::Include(std::span<const double, 3> point) {
    for (int axis = 0; axis < 3; ++axis) {
        low[axis] = std::min(low[axis], point[axis]);
        high[axis] = std::max(high[axis], point[axis]);
    }
}

double Box::Diagonal() const { return std::hypot(Extent(0), Extent(1), Extent(2)); }

Box BoundingBox(std::span<const double> positions) {
    Box box;
    for (std::size_t i = 0; i + 3 <= positions.size(); i += 3) box.Include(positions.subspan(i).first<3>());
    return box;
}

}  // namespace SolidSubdiv::Geometry
