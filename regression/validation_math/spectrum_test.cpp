// SPDX-License-Identifier: Apache-2.0
// Spectra of matrices whose eigenvalues are known, and of the regular subdivision matrix.
#include "validation/spectrum.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "validation/lattice_convolution.h"
#include "validation_math/random_points.h"

namespace SolidSubdiv::Validation {
namespace {

void ExpectSpectrum(const std::vector<Eigenvalue>& spectrum, const std::vector<Eigenvalue>& expected,
                    double tolerance) {
    ASSERT_EQ(spectrum.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
        EXPECT_LT(std::abs(spectrum[i].value - expected[i].value), tolerance)
            << "eigenvalue " << i << ": " << spectrum[i].value;
        EXPECT_EQ(spectrum[i].multiplicity, expected[i].multiplicity)
            << "eigenvalue " << i << ": " << spectrum[i].value;
    }
}

// P D P^-1 with P a product of elementary shears, so that its inverse is known exactly.
std::vector<double> Disguised(const std::vector<double>& diagonal) {
    const int n = static_cast<int>(diagonal.size());
    std::vector<double> a(n * n, 0.0);
    for (int i = 0; i < n; ++i) a[i * n + i] = diagonal[i];
    const auto points = RandomPoints(n * n, 0.5, 31);
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            if (i == j) continue;
            const double s = points[i * n + j][0];
            for (int k = 0; k < n; ++k) a[i * n + k] += s * a[j * n + k];  // row i += s row j
            for (int k = 0; k < n; ++k) a[k * n + j] -= s * a[k * n + i];  // column j -= s column i
        }
    return a;
}

TEST(Spectrum, SortsByModulusAndCountsMultiplicities) {
    // The disguise has a condition number of a few hundred: semisimple eigenvalues keep 1e-12.
    ExpectSpectrum(Spectrum(Disguised({0.25, 1, 0.5, 0.25, -0.25, 0.5, 0.25, 0, 0.5}), 9, 1e-9),
                   {{1, 1}, {0.5, 3}, {0.25, 3}, {-0.25, 1}, {0, 1}}, 1e-11);
}

TEST(Spectrum, OfACyclicShiftIsTheRootsOfUnity) {
    const int n = 5;
    std::vector<double> shift(n * n, 0.0);
    for (int i = 0; i < n; ++i) shift[i * n + (i + 1) % n] = 1;
    // All of modulus 1: by falling real part, then falling imaginary part.
    std::vector<Eigenvalue> expected = {{1, 1}};
    for (int k = 1; k <= 2; ++k)
        for (const int sign : {1, -1}) expected.push_back({std::polar(1.0, sign * 2 * std::numbers::pi * k / n), 1});
    ExpectSpectrum(Spectrum(shift, n), expected, 1e-14);
}

TEST(Spectrum, OfADefectiveMatrixIsFoundWithAWiderTolerance) {
    const std::vector<double> jordan = {0.5, 1, 0, 0, 0.5, 1, 1e-15, 0, 0.5};
    // The corner of 1e-15 spreads the triple eigenvalue by its third root, 1e-5; the mean stays.
    EXPECT_EQ(Spectrum(jordan, 3, 1e-9).size(), 3U);
    ExpectSpectrum(Spectrum(jordan, 3, 1e-4), {{0.5, 3}}, 1e-12);
}

TEST(Spectrum, OfSmallMatrices) {
    ExpectSpectrum(Spectrum({0, 6, 1, -1}, 2), {{-3, 1}, {2, 1}}, 1e-14);  // (x - 2)(x + 3)
    ExpectSpectrum(Spectrum({7}, 1), {{7, 1}}, 1e-14);
}

// Subdivision around a lattice vertex: the values on the vertex and its fourteen neighbours determine themselves one
// level finer.
std::vector<double> RegularSubdivisionMatrix(const std::vector<LatticePoint>& star) {
    const int n = static_cast<int>(star.size());
    std::vector<double> matrix(n * n, 0.0);
    for (int row = 0; row < n; ++row)
        for (const auto& [q, w] : SubdivisionRow(star[row], 1)) {
            const auto found = std::find(star.begin(), star.end(), q);
            EXPECT_NE(found, star.end());
            matrix[row * n + (found - star.begin())] = w;
        }
    return matrix;
}

std::vector<LatticePoint> Star() {
    std::vector<LatticePoint> star = {{0, 0, 0}};
    for (int x = -1; x <= 1; ++x)
        for (int y = -1; y <= 1; ++y)
            for (int z = -1; z <= 1; ++z)
                if (ClassifyEdge({0, 0, 0}, {x, y, z}) != EdgeKind::None) star.push_back({x, y, z});
    return star;
}

// 1, three linear, six quadratic eigenfunctions; of the ten cubics and fifteen quartics five fit on fifteen points.
TEST(Spectrum, OfTheRegularBoxSplineStartsAsThatOfPolynomials) {
    ExpectSpectrum(Spectrum(RegularSubdivisionMatrix(Star()), 15, 1e-9),
                   {{1, 1}, {0.5, 3}, {0.25, 6}, {0.125, 4}, {0.0625, 1}}, 1e-12);
}

// The printed edge rule at link 4, weights (10, 10, 3, 3, 3, 3)/32, on the B edges of an octet truss with diagonals
// along (1,1,0): larger than 1/4 behind the linear part, so not C2. The two values are those quoted in the rules,
// section 2.
TEST(Spectrum, OfThePrintedEdgeRuleIsNotThatOfABoxSpline) {
    const std::vector<LatticePoint> star = Star();
    std::vector<double> matrix = RegularSubdivisionMatrix(star);
    const int n = static_cast<int>(star.size());
    for (int row = 0; row < n; ++row) {
        const bool diagonal = star[row] == LatticePoint{1, 1, 0} || star[row] == LatticePoint{-1, -1, 0};
        if (diagonal || ClassifyEdge({0, 0, 0}, star[row]) != EdgeKind::B) continue;
        for (int column = 0; column < n; ++column) {
            double& weight = matrix[row * n + column];
            if (weight == 8.0 / 32)
                weight = 10.0 / 32;
            else if (weight == 4.0 / 32)
                weight = 3.0 / 32;
        }
    }
    const std::vector<Eigenvalue> spectrum = Spectrum(matrix, n, 1e-9);
    ASSERT_GE(spectrum.size(), 5U);
    EXPECT_NEAR(spectrum[2].value.real(), 0.3125, 1e-12);
    EXPECT_NEAR(spectrum[3].value.real(), 0.2759, 5e-5);
}

TEST(Spectrum, NoticesAWeightOffByOneMillionth) {
    std::vector<double> matrix = RegularSubdivisionMatrix(Star());
    matrix[0] += 1e-6;
    EXPECT_GT(std::abs(Spectrum(matrix, 15)[0].value - 1.0), 1e-8);
}

TEST(Spectrum, RefusesWhatIsNoSquareMatrixOfFiniteNumbers) {
    EXPECT_THROW(Spectrum({1, 2, 3}, 2), std::invalid_argument);
    EXPECT_THROW(Spectrum({}, 0), std::invalid_argument);
    EXPECT_THROW(Spectrum({std::numeric_limits<double>::quiet_NaN()}, 1), std::invalid_argument);
    EXPECT_THROW(Spectrum({1}, 1, -1), std::invalid_argument);
}

}  // namespace
}  // namespace SolidSubdiv::Validation
