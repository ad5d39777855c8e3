// SPDX-License-Identifier: Apache-2.0
// Eigenvalues of local subdivision matrices, and what they say about smoothness.
//
//     auto m = Analysis::RegularLocalMatrix(Sdc::BoxSpline{});    // kit/analysis/places.h
//     auto s = Analysis::SpectrumOf(m);            // 1, 1/2 x 3, 1/4 x 6, 1/8 x 4, 1/16
//     auto v = Analysis::VerdictOf(s, 3);          // "C2 spectrum: ..."
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

/// What the eigenvalues of the vertex's ring allow.
enum class Smoothness {
    Diverges,  ///< an eigenvalue of modulus 1 or more besides the single 1
    C0,        ///< the `dimension` next eigenvalues are not one real value of that multiplicity
    C1,        ///< they are (C1 if the characteristic map is regular), but the next are larger than their square, or
               ///< more of that size than there are quadratic functions
    C2         ///< and the next are at most their square, as many as quadratics
};

struct Verdict {
    Smoothness smoothness = Smoothness::Diverges;
    double subdominant = 0;  ///< modulus of the second eigenvalue
    std::string text;        ///< one line for people
};

/// @param dimension 3 inside a solid, 2 on a surface, 1 on a curve
Verdict VerdictOf(const Spectrum& spectrum, int dimension);

/// What eigenvalues say at a vertex on an inner edge, where the map along the edge may shrink at another rate than
/// across it.
struct EdgeVerdict {
    /// Three real eigenvalues after 1, larger than all others: C1 if the characteristic map is regular. Otherwise it
    /// depends on which directions the functions of the others vary in.
    bool is_separated = false;
    std::string text;  ///< one line for people
};
EdgeVerdict EdgeVerdictOf(const Spectrum& spectrum);

/// "1, 1/2 x 3, 0.3125": eigenvalues that are m/2^k with k <= 6 as fractions.
std::string SpectrumText(const Spectrum& spectrum);

}  // namespace SolidSubdiv::Analysis
