// SPDX-License-Identifier: Apache-2.0
// Whether a scheme can refine a mesh.
#pragma once

#include <solidsubdiv/sdc/schemes.h>
#include <solidsubdiv/vtr/level.h>

namespace SolidSubdiv::Far::Internal {

/// @throws InvalidInput for a surface scheme on cells, and for options that contradict each other
void CheckScheme(const Vtr::Level& base, const Sdc::Scheme& scheme);

}  // namespace SolidSubdiv::Far::Internal
