// SPDX-License-Identifier: Apache-2.0
// Stands in for spectrum.cpp where Eigen was not found: says so.
#include "findings.h"
#include "spectrum.h"

namespace SolidSubdiv::Validation {

std::vector<Eigenvalue> Spectrum(const std::vector<double>&, int, double) {
    throw Unavailable{"Eigen was not found when this program was built (Debian: libeigen3-dev)"};
}

}  // namespace SolidSubdiv::Validation
