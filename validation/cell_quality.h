// SPDX-License-Identifier: Apache-2.0
// Holds scaled Jacobians to VTK's Verdict library, and least determinants to samples.
#pragma once

#include <span>
#include <vector>

#include <solidsubdiv/kit/geometry/cell_quality.h>
#include <solidsubdiv/kit/io/mesh.h>

#include "findings.h"

namespace SolidSubdiv::Validation {

/// A mesh of tets or of hexahedra alone.
std::vector<Geometry::CellQuality> MeasureMesh(const Io::Mesh& mesh);

/// Errors: differences of scaled Jacobians. Faults: another number of cells; determinants, sampled from the positions
/// on a grid of 6^3 places of each hexahedron, below the lower bound or negative where the sign is said to be positive.
void CompareQuality(const Io::Mesh& mesh, std::span<const Geometry::CellQuality> ours,
                    std::span<const double> by_verdict, Findings& findings);

}  // namespace SolidSubdiv::Validation
