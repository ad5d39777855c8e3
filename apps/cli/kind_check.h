// SPDX-License-Identifier: Apache-2.0
// Whether a scheme takes a mesh's kinds of elements, and if not, which schemes do.
#pragma once

#include <solidsubdiv/kit/io/mesh.h>
#include <solidsubdiv/sdc/schemes.h>

namespace SolidSubdiv::Cli {

/// @throws InvalidInput in one line: the kinds that the scheme does not take, those that it takes, the schemes to
/// choose
void RequireKinds(const Io::Topology& topology, const Sdc::Scheme& scheme);

/// RequireKinds, and how the mesh is cut then: tets, octs, triangles and edges alone as such, where the scheme has
/// rules for them.
Sdc::Split SplitFor(const Io::Topology& topology, const Sdc::Scheme& scheme);

}  // namespace SolidSubdiv::Cli
