// SPDX-License-Identifier: Apache-2.0
// A solid's start needs a closed surface; scans have holes.
//
//     const Fit::CloudShape closed = Fit::CloseSurface(positions, triangles);
//     const Fit::ControlMesh lattice = Fit::MakeSolidStart({closed.positions, closed.triangles}, {.n_control = 400});
//     // Fitted to the scan itself: over its holes nothing draws, and the lattice goes on as around them.
//     const Fit::SolidFit fit = Fit::FitSolid(lattice, scheme, {positions, triangles}, {});
#pragma once

#include <solidsubdiv/apps/fit/cloud.h>

namespace SolidSubdiv::Fit {

/// The closing of points spread over the triangles, with their normals, which say whether triangles look inwards
/// (has_turned_normals). Holes up to about half as wide as the shape are bridged. `normals` are those of the points
/// spread, none of the surface's vertices.
/// @throws InvalidInput as TargetSurface::Validate, and where all triangles are degenerate; Cancelled
CloudShape CloseSurface(std::span<const double> positions, std::span<const Index> triangles,
                        const Progress& progress = {});

}  // namespace SolidSubdiv::Fit
