// SPDX-License-Identifier: Apache-2.0
// Whether a scheme can refine a mesh.
#pragma once

#include <solidsubdiv/far/topology_refiner.h>
#include <solidsubdiv/sdc/schemes.h>

namespace SolidSubdiv::Far::Internal {

/// @throws InvalidInput for a surface scheme on cells, for semi-sharp creases where the scheme's curves take them sharp
/// or not at all, and for options that contradict each other
void CheckScheme(const TopologyRefiner& refiner, const Sdc::Scheme& scheme);

}  // namespace SolidSubdiv::Far::Internal
