// SPDX-License-Identifier: Apache-2.0
// How fast fits to smooth shapes come nearer as control points grow more.
#pragma once

#include <string>
#include <vector>

#include <solidsubdiv/apps/fit/fit.h>

#include "findings.h"

namespace SolidSubdiv::Validation {

/// A torus of radii 1 and 0.4 in control meshes of n rings of m points each around the tube, regular everywhere.
enum class TorusMesh { Triangles, Quads };

/// The RMS distance from the torus of the best fit in the least-squares sense, points of equal parameters being
/// partners.
double TorusError(TorusMesh kind, int n, int m);

/// The RMS distance from the unit sphere of a Loop cage, an octahedron cut n by n: six vertices of valence 4.
double SphereError(int n);

/// Errors are what the orders between consecutive errors, h halved each time, lack of `expected`.
void CompareOrders(const std::vector<double>& errors, double expected, Findings& findings);

}  // namespace SolidSubdiv::Validation
