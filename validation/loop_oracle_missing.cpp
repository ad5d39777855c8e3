// SPDX-License-Identifier: Apache-2.0
// Stands in for loop_oracle.cpp where OpenSubdiv was not found: says so.
#include "findings.h"
#include "loop_oracle.h"

namespace SolidSubdiv::Validation {

std::vector<SurfaceLevel> RefineByOpenSubdiv(const ControlSurface&, int, int) {
    throw Unavailable{"OpenSubdiv was not found when this program was built (Debian: libosd-dev)"};
}

std::vector<SurfaceLevel> RefineByOpenSubdiv(const PolygonSurface&, int, int) {
    throw Unavailable{"OpenSubdiv was not found when this program was built (Debian: libosd-dev)"};
}

}  // namespace SolidSubdiv::Validation
