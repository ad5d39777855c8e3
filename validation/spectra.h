// SPDX-License-Identifier: Apache-2.0
// Local subdivision matrices read off stencil tables, and spectra held to quoted figures.
#pragma once

#include <vector>

#include <solidsubdiv/far/stencil_table.h>

#include "findings.h"
#include "refined_points.h"
#include "spectrum.h"

namespace SolidSubdiv::Validation {

/// How the vertex and what its successors depend on move from one level to the next.
struct LocalSubdivision {
    std::vector<LatticePoint> offsets;  ///< from the vertex, in units of the level; the vertex itself first
    std::vector<double> matrix;         ///< (n, n), row-major
};

/// Starts with the vertex and its neighbours up to `n_rings` edges away, and adds whatever the rows of the points at
/// the same offsets, one level on, refer to.
/// @param rows those that make level + 1 from level
/// @throws std::runtime_error if no vertex of level + 1 is at such an offset
LocalSubdivision SubdivisionAround(const RefinedPoints& refined, const Far::StencilRows<double>& rows, int level,
                                   Index vertex, int n_rings = 1);

/// A quoted eigenvalue and how far the figure may be off by its rounding; exact: 0.
struct QuotedEigenvalue {
    double value;
    int multiplicity;
    double rounding = 0;
};

/// The largest eigenvalues against the quoted ones, in the order of their size.
void CompareSpectrum(const std::vector<Eigenvalue>& spectrum, const std::vector<QuotedEigenvalue>& quoted,
                     Findings& findings);

}  // namespace SolidSubdiv::Validation
