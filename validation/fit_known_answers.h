// SPDX-License-Identifier: Apache-2.0
// Fits whose answer is known: control meshes fitted to what they carry themselves, and to affine images.
#pragma once

#include <solidsubdiv/apps/fit/fit.h>

#include "findings.h"
#include "fit_shapes.h"

namespace SolidSubdiv::Validation {

/// Refits a mesh to the points of its own limit, from control points shaken by a twentieth of the size: errors are
/// those of the control points that the surface depends on, over the size.
void CheckKnownPartners(const FitCase& fit_case, Findings& findings);

/// From a per cent away to its own limit as triangles: the larger RMS distance, over the target's diagonal.
void CheckFreePartners(const FitCase& fit_case, Findings& findings);

/// How far the control points that the surface depends on are from those wanted, over the size.
void CompareSeen(const Fit::Problem& problem, const std::vector<double>& found, const std::vector<double>& wanted,
                 Findings& findings);

/// The last round's RMS distances over the diagonal. The first must have had some.
void CompareRounds(const std::vector<Fit::Round>& rounds, double diagonal, Findings& findings);

/// What fair rows leave of an affine image of the positions, over the size. They must see a shaken one.
void CompareFairness(const Far::StencilRows<double>& rows, const std::vector<double>& positions, Findings& findings);

/// What fairness has to say of an affine image, over the size.
void CheckFairness(const FitCase& fit_case, Findings& findings);

/// Coordinates of points and of those wanted, (n, 3), over the size.
void ComparePoints(const std::vector<double>& found, const std::vector<double>& wanted, Findings& findings);

/// A box lattice that carries a model to an affine image of it, points being known: distances over the size.
void CheckAffineLattice(const FitTarget& model, const Sdc::Scheme& scheme, Findings& findings);

}  // namespace SolidSubdiv::Validation
