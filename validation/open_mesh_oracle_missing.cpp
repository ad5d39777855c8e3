// SPDX-License-Identifier: Apache-2.0
// Stands in for open_mesh_oracle.cpp where OpenMesh was not found: says so.
#include "findings.h"
#include "open_mesh_oracle.h"

namespace SolidSubdiv::Validation {

std::vector<SurfaceLevel> RefineByOpenMesh(const ControlSurface&, int) {
    throw Unavailable{"OpenMesh was not found when this program was built (Debian: libopenmesh-dev)"};
}

}  // namespace SolidSubdiv::Validation
