// SPDX-License-Identifier: Apache-2.0
// Each control point as a sum of those around it.
#pragma once

#include <span>
#include <vector>

#include <solidsubdiv/far/stencil_table.h>

namespace SolidSubdiv::Fit::Internal {

/// Row i: weights of the neighbours of point i, summing to 1, whose sum of positions is that of i: so it is after any
/// affine map. The least weights of those that do, in the sense of squares. A point whose neighbours reach no such sum
/// (it lies off their plane or line) gets an empty row.
/// Source: roweis2000lle, section on reconstruction weights, with the constraint met exactly.
Far::StencilRows<double> AffineRows(std::span<const double> positions, std::span<const std::vector<Index>> neighbors);

}  // namespace SolidSubdiv::Fit::Internal
