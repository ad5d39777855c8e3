// SPDX-License-Identifier: Apache-2.0
// Stands in for limit_surfaces_oracle.cpp where OpenSubdiv was not found: says so.
#include "findings.h"
#include "limit_surfaces_oracle.h"

namespace SolidSubdiv::Validation {

namespace {
const Unavailable kMissing{"OpenSubdiv was not found when this program was built (Debian: libosd-dev)"};
}  // namespace

SurfaceLimits LimitsByOpenSubdiv(const ControlSurface&, std::span<const SurfacePlace>) { throw kMissing; }
SurfaceLimits LimitsByOpenSubdiv(const PolygonSurface&, std::span<const SurfacePlace>) { throw kMissing; }
VertexLimits VertexLimitsByOpenSubdiv(const ControlSurface&) { throw kMissing; }
VertexLimits VertexLimitsByOpenSubdiv(const PolygonSurface&) { throw kMissing; }

}  // namespace SolidSubdiv::Validation
