// SPDX-License-Identifier: Apache-2.0
// Where a place goes in a split: in which child, at which coordinates, and where the split's points are.
#pragma once

#include <array>
#include <vector>

#include "limit_walk.h"

namespace SolidSubdiv::Validation {

using Matrix3 = std::array<Vector3, 3>;

/// A place in an element of a complex, by vertices alone.
///
/// Tets, octahedra and triangles among them: `vertices` are the element's, `at` as in far/place.h. Among polyhedra the
/// vertices are a path along edges, v, v's edge, face (and cell) on: with s = at, all within [0, 1] and descending, the
/// point is v0 + s1 (v1 - v0) + s2 (v2 - v1) + s3 (v3 - v2). In a hexahedron that is its trilinear coordinates sorted;
/// in the cells that a split makes at corners of other cells the same, around the diagonal from corner to centre.
struct PlaceByVertices {
    std::vector<Index> vertices;
    int d = 3;  ///< dimension of the element
    Vector3 at{};
    Matrix3 by_control{};  ///< derivative of `at` by the coordinates of the control element
};

/// A point of a split, and where it is by `at` of the parent.
struct SplitPoint {
    Index vertex;
    Vector3 at;
};

/// By a refiner whose level 0 has the element and whose level 1 is refined.
/// @param points of the split: of the place's element, or on its path
PlaceByVertices StepDown(const Far::TopologyRefiner& refiner, const PlaceByVertices& place,
                         std::vector<SplitPoint>& points);

/// The same of a control mesh's place. The element may have parts, of which there are no points.
PlaceByVertices FirstStep(const Far::TopologyRefiner& refiner, const Far::Place& place, Far::Elements elements,
                          std::vector<SplitPoint>& points);

}  // namespace SolidSubdiv::Validation
