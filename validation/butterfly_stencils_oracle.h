// SPDX-License-Identifier: Apache-2.0
// The stencil of one edge under a butterfly rule, walked on one level of OpenSubdiv's topology. For the butterfly
// oracle only: it shows OpenSubdiv's types.
#pragma once

#include <opensubdiv/far/topologyLevel.h>

#include <map>
#include <vector>

#include "butterfly_oracle.h"

namespace SolidSubdiv::Validation {

/// Weights by vertex.
using Stencil = std::map<int, double>;

/// One level with what is sharp on it.
struct TaggedLevel {
    const OpenSubdiv::Far::TopologyLevel& topology;
    std::vector<bool> is_crease;  ///< by edge; those with other than two triangles too
    std::vector<bool> is_corner;  ///< by vertex
};

Stencil ButterflyStencil(const TaggedLevel& level, const ButterflyRule& rule, int edge);

}  // namespace SolidSubdiv::Validation
