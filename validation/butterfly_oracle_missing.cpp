// SPDX-License-Identifier: Apache-2.0
// Stands in for butterfly_oracle.cpp where OpenSubdiv was not found: says so.
#include "butterfly_oracle.h"
#include "findings.h"

namespace SolidSubdiv::Validation {

ButterflyRefinement RefineByButterflyOracle(const ControlSurface&, const ButterflyRule&, int, int) {
    throw Unavailable{"OpenSubdiv was not found when this program was built (Debian: libosd-dev)"};
}

}  // namespace SolidSubdiv::Validation
