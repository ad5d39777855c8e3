// SPDX-License-Identifier: Apache-2.0
// The cpu backend: ranges of rows in parallel.
#include <solidsubdiv/osd/cpu/cpu.h>

#include <solidsubdiv/osd/cpu/internal/kernels.h>
#include <solidsubdiv/sdc/parallel.h>

namespace SolidSubdiv::Osd {

template <class Real>
void EvalStencilsCpu(const Far::StencilRows<Real>& rows, const BufferView<const Real>& source,
                     const BufferView<Real>& destination, Index begin, Index end) {
    constexpr Offset kGrain = 4096;  // rows: some 30 microseconds, a hundred times what a task costs
    static const Internal::EvalRowsFunction<Real> eval_rows = Internal::BestEvalRows<Real>();
    Sdc::ParallelFor(end - begin, kGrain, [&](Offset first, Offset last) {
        eval_rows(rows, source, destination, static_cast<Index>(begin + first), static_cast<Index>(begin + last));
    });
}

template void EvalStencilsCpu(const Far::StencilRows<float>&, const BufferView<const float>&, const BufferView<float>&,
                              Index, Index);
template void EvalStencilsCpu(const Far::StencilRows<double>&, const BufferView<const double>&,
                              const BufferView<double>&, Index, Index);

}  // namespace SolidSubdiv::Osd
