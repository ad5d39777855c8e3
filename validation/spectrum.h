// SPDX-License-Identifier: Apache-2.0
// Eigenvalues of a dense square matrix, largest modulus first, equal ones counted together.
#pragma once

#include <complex>
#include <vector>

namespace SolidSubdiv::Validation {

struct Eigenvalue {
    std::complex<double> value;
    int multiplicity = 1;
};

/// Eigenvalues with algebraic multiplicities, by falling modulus, then falling real part, then falling imaginary part.
/// Values that a chain of neighbours nearer than `tolerance` connects count as one, their mean. A defective eigenvalue
/// of multiplicity m is found to about the m-th root of round-off only (m = 3: 1e-5): choose the tolerance accordingly.
/// @param matrix (n, n), row-major, any real matrix
/// @throws std::invalid_argument if matrix has not n * n finite entries or the tolerance is negative;
/// std::runtime_error if the iteration fails
std::vector<Eigenvalue> Spectrum(const std::vector<double>& matrix, int n, double tolerance = 1e-9);

}  // namespace SolidSubdiv::Validation
