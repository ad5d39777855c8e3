// SPDX-License-Identifier: Apache-2.0
// Stands in for hausdorff_oracle.cpp where CGAL was not found: says so.
#include "findings.h"
#include "hausdorff_oracle.h"

namespace SolidSubdiv::Validation {

double HausdorffDistance(std::span<const double>, std::span<const std::int32_t>, std::span<const double>,
                         std::span<const std::int32_t>, double) {
    throw Unavailable{"CGAL was not found when this program was built (Debian: libcgal-dev)"};
}

}  // namespace SolidSubdiv::Validation
