// SPDX-License-Identifier: Apache-2.0
// Terms of the sum of squares beside distances and fairness.
#pragma once

#include <span>
#include <vector>

#include <solidsubdiv/apps/fit/internal/pairs.h>
#include <solidsubdiv/apps/fit/internal/rows.h>

namespace SolidSubdiv::Fit::Internal {

/// `normals` times the mean over the surface's pairs of n . t, squared, for both tangents t of length 1. Tangents that
/// are more than 60 degrees off, at sharp edges, take no part: which side such a vertex meets is chance.
/// @param pairs of the surface's vertices
void AddTangentRows(const MovingSurface& surface, std::span<const Pair> pairs, std::span<const double> control,
                    double normals, std::vector<LinearRow>& rows);

/// `spring` times the mean over pairs of neighbours of |p - q|^2.
void AddSpringRows(std::span<const std::vector<Index>> neighbors, double spring, std::vector<LinearRow>& rows);

}  // namespace SolidSubdiv::Fit::Internal
