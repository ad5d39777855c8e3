// SPDX-License-Identifier: Apache-2.0
// The reference backend: one thread, sums in double, nothing clever.
#pragma once

#include <solidsubdiv/osd/backend.h>

namespace SolidSubdiv::Osd {

template <class Real>
void EvalStencilsReference(const Far::StencilRows<Real>& rows, const BufferView<const Real>& source,
                           const BufferView<Real>& destination, Index begin, Index end);

}  // namespace SolidSubdiv::Osd
