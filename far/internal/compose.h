// SPDX-License-Identifier: Apache-2.0
// Composite rows: products of the levels' rows for chosen vertices.
#pragma once

#include <span>

#include <solidsubdiv/far/stencil_table.h>

namespace SolidSubdiv::Far::Internal {

/// Rows over the control vertices for the requests, one after another. Only rows that they stand on are made.
/// @pre the scheme can refine the mesh @throws InvalidInput naming a level or a vertex that is not there
template <class Real>
StencilRows<Real> Compose(const TopologyRefiner& refiner, const Sdc::Scheme& scheme,
                          std::span<const CompositeRows> requests, const Progress& progress);

extern template StencilRows<double> Compose(const TopologyRefiner&, const Sdc::Scheme&, std::span<const CompositeRows>,
                                            const Progress&);
extern template StencilRows<float> Compose(const TopologyRefiner&, const Sdc::Scheme&, std::span<const CompositeRows>,
                                           const Progress&);

}  // namespace SolidSubdiv::Far::Internal
