// SPDX-License-Identifier: Apache-2.0
// The cpu backend: vectors and threads. Sums run in Real, in the order of each row, so results are the same bits for
// any number of threads, any range, and any processor of the architecture.
#pragma once

#include <solidsubdiv/osd/backend.h>

namespace SolidSubdiv::Osd {

template <class Real>
void EvalStencilsCpu(const Far::StencilRows<Real>& rows, const BufferView<const Real>& source,
                     const BufferView<Real>& destination, Index begin, Index end);

}  // namespace SolidSubdiv::Osd
