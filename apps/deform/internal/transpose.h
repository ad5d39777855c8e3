// SPDX-License-Identifier: Apache-2.0
// Gradients by the embedded points turned into gradients by the control points: the embedding transposed.
#pragma once

#include <span>
#include <vector>

#include <solidsubdiv/apps/deform/embedding.h>

namespace SolidSubdiv::Deform::Internal {

/// Triples, (n_control_points, 3): the sum over points p of (row of p)^T times triple p of (n_points, 3). Costs what
/// a deformation does, on one thread.
std::vector<double> ApplyTransposed(const EmbeddingTables& tables, std::span<const double> triples);

}  // namespace SolidSubdiv::Deform::Internal
