// SPDX-License-Identifier: Apache-2.0
// The point of a trilinear hexahedron nearest to the origin: corners come relative to the point that is asked for.
//
// Descent finds a place, bounds say that there is no better one: a part of the cell lies in the convex hull of its
// corners, so what all corners keep away from along some direction, the part does too. Where that does not decide,
// the part is halved. So a fold, a second solution or a step that goes astray can't hide a place.
#pragma once

#include <solidsubdiv/kit/geometry/internal/nearest_in_tet.h>
#include <solidsubdiv/kit/geometry/internal/trilinear.h>

namespace SolidSubdiv::Geometry::Internal {

/// The nearest place. Its distance is at most a part in 1e6 (and `round_off`) more than the least.
/// What is certainly further than `limit` may be said to be nowhere, sooner; otherwise limit has no influence.
Nearest NearestInHex(const Trilinear& hex, double round_off, double limit);

/// The same where the origin lies within `reach`: the first such place that is met. Otherwise a distance that is
/// larger than reach.
Nearest HoldInHex(const Trilinear& hex, double reach);

}  // namespace SolidSubdiv::Geometry::Internal
