// SPDX-License-Identifier: Apache-2.0
// Composite rows: products of cascaded tables for chosen vertices.
#pragma once

#include <span>

#include <solidsubdiv/far/stencil_table.h>

namespace SolidSubdiv::Far::Internal {

/// Rows over the control vertices for the requests, one after another. Only rows that they stand on are multiplied out.
template <class Real>
StencilRows<Real> Compose(const StencilTableReal<double>& cascaded, std::span<const CompositeRows> requests,
                          const Progress& progress);

extern template StencilRows<double> Compose(const StencilTableReal<double>&, std::span<const CompositeRows>,
                                            const Progress&);
extern template StencilRows<float> Compose(const StencilTableReal<double>&, std::span<const CompositeRows>,
                                           const Progress&);

}  // namespace SolidSubdiv::Far::Internal
