// SPDX-License-Identifier: Apache-2.0
// From a place in a polyhedron or a polygon to the place in the child that has it.
//
// A part of a cell (place.h) is a tet of its centroid, a face's centroid and two corners A, B; the children at A and at
// B share it in halves. In the child at A the half is the tet along a path from corner to corner: A, the middle of the
// edge AB, the face's point, the cell's point. A hexahedron is six such tets, and splits them as it splits. A cell at a
// corner where other than three edges met has them too, along paths from one of its two odd corners to the other: there
// a place is a path and coordinates 1 >= x >= y >= z >= 0 along it.
#pragma once

#include <solidsubdiv/far/internal/limit_state.h>

namespace SolidSubdiv::Far::Internal {

struct StepInParts {
    const Transition* next = nullptr;
    Coordinates at{};             ///< in the child: coordinates, or, if it has parts, along the path
    std::array<Index, 4> path{};  ///< corners of the child's root, if it has parts
    Matrix3 matrix{};             ///< of `at` by the coordinates before
};

/// @pre state is expanded and has parts
StepInParts StepFromPart(const LimitState& state, Index part, const Coordinates& at);
StepInParts StepFromPath(const LimitState& state, const std::array<Index, 4>& path, const Coordinates& at);

}  // namespace SolidSubdiv::Far::Internal
