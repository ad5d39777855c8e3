// SPDX-License-Identifier: Apache-2.0
// What a target must be, whatever is made of it.
#include <cmath>
#include <cstdio>
#include <string>

#include <solidsubdiv/apps/fit/control_mesh.h>
#include <solidsubdiv/kit/geometry/box.h>
#include <solidsubdiv/sdc/errors.h>

namespace SolidSubdiv::Fit {

namespace {

// Squares of squares must fit a double.
constexpr double kMost = 1e75, kLeast = 1e-75;

void RequireCoordinates(std::span<const double> positions) {
    for (std::size_t i = 0; i < positions.size(); ++i) {
        if (std::abs(positions[i]) <= kMost) continue;
        char value[32];
        std::snprintf(value, sizeof value, "%g", positions[i]);
        throw InvalidInput("point " + std::to_string(i / 3) + " of the target has the coordinate " + value +
                           "; must be finite and at most 1e75");
    }
    const Geometry::Box box = Geometry::BoundingBox(positions);
    if (!(box.Diagonal() >= kLeast)) {
        throw InvalidInput("the points of the target are all at one place, or within 1e-75");
    }
}

void RequireTriangles(std::span<const Index> triangles, Index n_points) {
    for (std::size_t t = 0; t + 2 < triangles.size(); t += 3) {
        const Index a = triangles[t], b = triangles[t + 1], c = triangles[t + 2];
        for (Index v : {a, b, c}) {
            if (v >= 0 && v < n_points) continue;
            throw InvalidInput("triangle " + std::to_string(t / 3) + " of the target names point " + std::to_string(v) +
                               "; there are " + std::to_string(n_points));
        }
        if (a == b || b == c || c == a) {
            throw InvalidInput("triangle " + std::to_string(t / 3) + " of the target has point " +
                               std::to_string(a == b ? a : c) + " twice");
        }
    }
}

}  // namespace

void TargetSurface::Validate() const {
    if (positions.size() < 3) throw InvalidInput("the target is empty: it has no points");
    if (positions.size() % 3 + triangles.size() % 3 > 0) {
        throw InvalidInput("the target has " + std::to_string(positions.size()) + " coordinates and " +
                           std::to_string(triangles.size()) + " corners of triangles; both must be multiples of 3");
    }
    if (!normals.empty() && normals.size() != positions.size()) {
        throw InvalidInput("the target has " + std::to_string(normals.size() / 3) + " normals for " +
                           std::to_string(positions.size() / 3) + " points");
    }
    RequireCoordinates(positions);
    RequireTriangles(triangles, static_cast<Index>(positions.size() / 3));
}

}  // namespace SolidSubdiv::Fit
