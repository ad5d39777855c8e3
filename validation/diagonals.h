// SPDX-License-Identifier: Apache-2.0
// Holds chosen diagonals to the definition of matched faces and to a share of them that must be reached.
#pragma once

#include <string>

#include <solidsubdiv/far/choose_diagonals.h>

#include "diagonals_oracle.h"
#include "findings.h"
#include "solid_shapes.h"

namespace SolidSubdiv::Validation {

/// The same solid with its vertices, cells and (keeping orientation) vertices of cells in another order.
SolidShape Shuffle(const SolidShape& shape, std::uint32_t seed);

/// Errors: what the share of matched faces lacks of `least_share`. Faults: cells that are not those of the shape,
/// counts that are not those of the definition.
void CompareChoice(const SolidShape& shape, const Far::DiagonalChoice& choice, double least_share, Findings& findings);

}  // namespace SolidSubdiv::Validation
