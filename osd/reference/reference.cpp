// SPDX-License-Identifier: Apache-2.0
// The reference backend.
#include <solidsubdiv/osd/reference/reference.h>

namespace SolidSubdiv::Osd {

template <class Real>
void EvalStencilsReference(const Far::StencilRows<Real>& rows, const BufferView<const Real>& source,
                           const BufferView<Real>& destination, Index begin, Index end) {
    for (Index row = begin; row < end; ++row) {
        for (int c = 0; c < destination.descriptor.length; ++c) {
            double sum = 0;
            for (Offset k = rows.offsets[row]; k < rows.offsets[row + 1]; ++k) {
                sum += static_cast<double>(rows.weights[k]) * static_cast<double>(source.Element(rows.indices[k])[c]);
            }
            destination.Element(row)[c] = static_cast<Real>(sum);
        }
    }
}

template void EvalStencilsReference(const Far::StencilRows<float>&, const BufferView<const float>&,
                                    const BufferView<float>&, Index, Index);
template void EvalStencilsReference(const Far::StencilRows<double>&, const BufferView<const double>&,
                                    const BufferView<double>&, Index, Index);

}  // namespace SolidSubdiv::Osd
