// SPDX-License-Identifier: Apache-2.0
// The plain loop, in the compilers' own vectors of four.
#include "perf/plain_rows.h"

#include <cstring>

namespace SolidSubdiv::Perf {

void EvaluatePlainRows(const Offset* offsets, const Index* indices, const float* weights, const float* source,
                       float* destination, Offset begin, Offset end) {
    typedef float Vector __attribute__((vector_size(16)));
    for (Offset row = begin; row < end; ++row) {
        Vector sum = {0, 0, 0, 0};
        for (Offset k = offsets[row]; k < offsets[row + 1]; ++k) {
            Vector value;
            std::memcpy(&value, source + 3 * static_cast<Offset>(indices[k]), sizeof value);
            sum += value * weights[k];
        }
        for (int c = 0; c < 3; ++c) destination[3 * row + c] = sum[c];
    }
}

}  // namespace SolidSubdiv::Perf
