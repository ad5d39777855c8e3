// SPDX-License-Identifier: Apache-2.0
// Spectra of the regular lattices, and the words that eigenvalues get.
#include <gtest/gtest.h>

#include "kit/analysis/analysis_testing.h"

namespace {

using namespace SolidSubdiv;
using namespace SolidSubdiv::Analysis;

TEST(RegularSpectrum, OfTheBoxSplineIsThatOfItsMask) {
    const Spectrum s = SpectrumOf(RegularMatrix(Sdc::BoxSpline{}));
    EXPECT_EQ(SpectrumText(s), "1, 1/2 x 3, 1/4 x 6, 1/8 x 4, 1/16");
    EXPECT_EQ(VerdictOf(s, 3).smoothness, Smoothness::C2);
}

// rules.md section 2: eq. (11) taken literally.
TEST(RegularSpectrum, OfThePrintedRuleIsNotC2) {
    Sdc::BoxSpline printed;
    printed.edge_rule = Sdc::EdgeRule::Printed2002;
    const Spectrum s = SpectrumOf(RegularMatrix(printed));
    EXPECT_NEAR(s[2].value.real(), 0.3125, 1e-12);
    EXPECT_NEAR(s[3].value.real(), 0.2759, 5e-5);
    EXPECT_EQ(VerdictOf(s, 3).smoothness, Smoothness::C1);
}

TEST(RegularSpectrum, OfTheAveragedVariantIsC2) {
    Sdc::BoxSpline averaged;
    averaged.diagonals = Sdc::Diagonals::Averaged;
    const Spectrum s = SpectrumOf(RegularMatrix(averaged));
    EXPECT_EQ(SpectrumText(s).substr(0, 20), "1, 1/2 x 3, 1/4 x 6,");
    EXPECT_NEAR(s[3].value.real(), 0.1458, 5e-5);
    EXPECT_EQ(VerdictOf(s, 3).smoothness, Smoothness::C2);
}

TEST(RegularSpectrum, OfLoopIsThatOfTheQuarticBoxSpline) {
    const Spectrum s = SpectrumOf(RegularMatrix(Sdc::Loop{}));
    EXPECT_EQ(SpectrumText(s), "1, 1/2 x 2, 1/4 x 3, 1/8") << "Loop 1987: 1, 1/2, 1/2, 1/4 three times, 1/8";
    EXPECT_EQ(VerdictOf(s, 2).smoothness, Smoothness::C2);
}

TEST(RegularSpectrum, OfTheSchemesOfHexahedraIsThatOfTricubicSplines) {
    for (const Sdc::Scheme& scheme : {Sdc::Scheme(Sdc::CatmullClarkSolid{}), Sdc::Scheme(Sdc::Mlca{})}) {
        const Spectrum s = SpectrumOf(RegularMatrix(scheme));
        // Products of 1, 1/2, 1/4, 1/8 ... of one axis (of three points: 1, 1/2, 1/4): 27 in all.
        EXPECT_EQ(SpectrumText(s), "1, 1/2 x 3, 1/4 x 6, 1/8 x 7, 1/16 x 6, 1/32 x 3, 1/64");
        EXPECT_EQ(VerdictOf(s, 3).smoothness, Smoothness::C2);
        EXPECT_EQ(SpectrumText(SpectrumOf(EdgeMatrix(scheme, 4))), SpectrumText(s));
    }
    EXPECT_EQ(SpectrumText(SpectrumOf(RegularMatrix(Sdc::CatmullClark{}))), "1, 1/2 x 2, 1/4 x 3, 1/8 x 2, 1/16");
}

// rules.md section 4b.
TEST(RegularSpectrum, OfSmoothTetIsC2) {
    const Spectrum s = SpectrumOf(RegularMatrix(Sdc::SmoothTet{}));
    EXPECT_EQ(SpectrumText(s).substr(0, 25), "1, 1/2 x 3, 1/4 x 6, 1/8 ");
    EXPECT_EQ(VerdictOf(s, 3).smoothness, Smoothness::C2);
}

// The lattice has edges of four tets (with the diagonal along them) and of six (without).
TEST(EdgeSpectrum, OfFourAndSixTetsIsThatOfTheLattice) {
    for (const Sdc::Scheme& scheme : {Sdc::Scheme(Sdc::BoxSpline{}), Sdc::Scheme(Sdc::Interpolatory{})}) {
        const std::string regular = SpectrumText(SpectrumOf(RegularMatrix(scheme)));
        for (int n : {4, 6})
            EXPECT_EQ(SpectrumText(SpectrumOf(EdgeMatrix(scheme, n))).substr(0, 20), regular.substr(0, 20)) << n;
        EXPECT_NE(SpectrumText(SpectrumOf(EdgeMatrix(scheme, 5))).substr(0, 20), regular.substr(0, 20));
    }
    EXPECT_THROW(EdgeMatrix(Sdc::BoxSpline{}, 2), InvalidInput);
    EXPECT_THROW(EdgeMatrix(Sdc::Loop{}, 4), InvalidInput);
}

TEST(SpectrumOfTest, FindsThePlantedFault) {
    Far::LocalMatrix m = RegularMatrix(Sdc::BoxSpline{});
    m.weights[1] += 1e-3;
    m.weights[0] -= 1e-3;
    EXPECT_NE(SpectrumText(SpectrumOf(m)), "1, 1/2 x 3, 1/4 x 6, 1/8 x 4, 1/16");
}

}  // namespace
