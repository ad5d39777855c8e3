// SPDX-License-Identifier: Apache-2.0
// Stands in for the validators of fitting where apps/fit was not built: says so.
#include "validators.h"

namespace SolidSubdiv::Validation {

namespace {

[[noreturn]] void Missing() {
    throw Unavailable{
        "apps/fit was not built: Ceres or OpenMesh was not found (Debian: libceres-dev, libopenmesh-dev)"};
}

}  // namespace

Findings ValidateFitAffine(const Context&) { Missing(); }
Findings ValidateFitAffineLattice(const Context&) { Missing(); }
Findings ValidateFitDistances(const Context&) { Missing(); }
Findings ValidateFitFolded(const Context&) { Missing(); }
Findings ValidateFitFreePartners(const Context&) { Missing(); }
Findings ValidateFitJacobians(const Context&) { Missing(); }
Findings ValidateFitKnownPartners(const Context&) { Missing(); }
Findings ValidateFitOrders(const Context&) { Missing(); }

}  // namespace SolidSubdiv::Validation
