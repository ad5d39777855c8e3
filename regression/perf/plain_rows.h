// SPDX-License-Identifier: Apache-2.0
// The plainest quick loop over compressed rows of three floats: what our evaluator must not be slower than.
#pragma once

#include <solidsubdiv/sdc/types.h>

namespace SolidSubdiv::Perf {

/// Rows [begin, end); reads four floats of each element, one behind the last.
void EvaluatePlainRows(const Offset* offsets, const Index* indices, const float* weights, const float* source,
                       float* destination, Offset begin, Offset end);

}  // namespace SolidSubdiv::Perf
