// SPDX-License-Identifier: Apache-2.0
// Eigenvalues of local subdivision matrices. What they say about smoothness: kit/analysis/verdict.h.
//
//     auto m = Analysis::RegularLocalMatrix(Sdc::BoxSpline{});    // kit/analysis/places.h
//     auto s = Analysis::SpectrumOf(m);                           // 1, 1/2 x 3, 1/4 x 6, 1/8 x 4, 1/16
#pragma once

#include <complex>
#include <string>
#include <vector>

#include <solidsubdiv/far/local_matrix.h>

namespace SolidSubdiv::Analysis {

/// Equal eigenvalues (to the tolerance) together.
struct Eigenvalue {
    std::complex<double> value;
    int multiplicity = 1;
};

/// By descending modulus.
using Spectrum = std::vector<Eigenvalue>;

/// Eigenvalues within `tolerance` of each other are one of higher multiplicity, and their mean its value: where
/// eigenvectors lack, QR finds k equal ones spread by the k-th root of round-off about a mean that is exact.
Spectrum SpectrumOf(const Far::LocalMatrix& matrix, double tolerance = 1e-4);

/// "1, 1/2 x 3, 0.3125": eigenvalues that are m/2^k with k <= 6 as fractions. Of more than n_shown different ones the
/// rest are dots.
std::string SpectrumText(const Spectrum& spectrum, std::size_t n_shown = static_cast<std::size_t>(-1));

/// The `dimension` eigenvalues after 1, and how they stand to the others.
struct Separation {
    bool settles = false;                        ///< 1 is single and the largest
    bool is_positive = false;                    ///< they are real and positive
    bool is_separated = false;                   ///< and above all others
    bool is_even = false;                        ///< and equal
    std::size_t end = 0;                         ///< of them, in the spectrum
    double largest = 0, smallest = 0, next = 0;  ///< moduli
};
Separation SeparationOf(const Spectrum& spectrum, int dimension);

}  // namespace SolidSubdiv::Analysis
