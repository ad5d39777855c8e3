// SPDX-License-Identifier: Apache-2.0
// The cpu backend: ranges of rows in parallel.
#include <solidsubdiv/osd/cpu/cpu.h>

#include <solidsubdiv/osd/cpu/internal/kernels.h>
#include <solidsubdiv/sdc/parallel.h>

namespace SolidSubdiv::Osd {

namespace {

/// The source's elements, three values each, at distances of four.
template <class Real>
Array<Real> Padded(const BufferView<const Real>& source, Index n) {
    Array<Real> padded(4 * static_cast<std::size_t>(n));
    Sdc::ParallelFor(n, 1 << 15, [&](Offset begin, Offset end) {
        for (Offset i = begin; i < end; ++i) {
            for (int c = 0; c < 3; ++c) padded[4 * i + c] = source.Element(i)[c];
            padded[4 * i + 3] = 0;
        }
    });
    return padded;
}

}  // namespace

template <class Real>
void EvalStencilsCpu(const Far::StencilRows<Real>& rows, const BufferView<const Real>& source,
                     const BufferView<Real>& destination, Index begin, Index end) {
    static const Internal::EvalRowsFunction<Real> eval_rows = Internal::BestEvalRows<Real>();
    constexpr Offset kGrain = 4096;        // rows: some 30 microseconds, a hundred times what a task costs
    constexpr Index kRowsWorthACopy = 16;  // a source element: a copy costs as much as a row or two

    Array<Real> padded;
    BufferView<const Real> from = source;
    if (source.descriptor.length == 3 && (end - begin) / kRowsWorthACopy >= rows.n_sources) {
        padded = Padded(source, rows.n_sources);
        from = BufferView<const Real>(std::span<const Real>(padded), 4);
    }
    Sdc::ParallelFor(end - begin, kGrain, [&](Offset first, Offset last) {
        eval_rows(rows, from, destination, static_cast<Index>(begin + first), static_cast<Index>(begin + last));
    });
}

template void EvalStencilsCpu(const Far::StencilRows<float>&, const BufferView<const float>&, const BufferView<float>&,
                              Index, Index);
template void EvalStencilsCpu(const Far::StencilRows<double>&, const BufferView<const double>&,
                              const BufferView<double>&, Index, Index);

}  // namespace SolidSubdiv::Osd
