// SPDX-License-Identifier: Apache-2.0
// The inner loops of the cpu backend on one thread, once for each set of instructions.
//
// All of them sum a row's terms in the row's order, one component independent of the others, each product rounded
// before it is added. So they give the same bits, and so does any way to cut the rows into ranges.
#pragma once

#include <solidsubdiv/far/stencil_table.h>
#include <solidsubdiv/osd/buffer.h>

namespace SolidSubdiv::Osd::Internal {

/// Applies rows [begin, end). Lengths are equal; or the destination's is 3 and the source's 4, of which the last is not
/// used: elements that lie so are summed faster.
template <class Real>
using EvalRowsFunction = void (*)(const Far::StencilRows<Real>& rows, const BufferView<const Real>& source,
                                  const BufferView<Real>& destination, Index begin, Index end);

/// What every processor of the architecture can do.
template <class Real>
void EvalRowsBaseline(const Far::StencilRows<Real>& rows, const BufferView<const Real>& source,
                      const BufferView<Real>& destination, Index begin, Index end);

/// The same with AVX2, where compiler and processor have it; otherwise the baseline.
template <class Real>
EvalRowsFunction<Real> BestEvalRows();

}  // namespace SolidSubdiv::Osd::Internal
