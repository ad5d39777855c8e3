// SPDX-License-Identifier: Apache-2.0
// Spectra around vertices of every kind: what the interpolating schemes owe (rules.md sections 3 and 6).
#include <gtest/gtest.h>
#include <solidsubdiv/kit/analysis/subdivision_matrix.h>

#include "kit/analysis/analysis_testing.h"
#include "test_shapes.h"

namespace {

using namespace SolidSubdiv;
using namespace SolidSubdiv::Analysis;

Far::LocalMatrix AroundFirstVertex(const TestShapes::Shape& s, const Sdc::Scheme& scheme) {
    auto refiner = Far::TopologyRefiner::Create(
        {.n_vertices = s.n_vertices, .tets = s.tets, .octs = s.octs, .triangles = s.triangles}, Sdc::Split::TetOct);
    refiner.RefineUniform({.max_level = 4});
    const auto m = MatrixAround(refiner, 0, 0, scheme);
    EXPECT_TRUE(m.has_value());
    return m.value_or(Far::LocalMatrix{});
}

/// k triangles around vertex 0 on a border, and a ring of regular ones around them.
TestShapes::Shape HalfDisc(int k) {
    TestShapes::Shape s = TestShapes::Disc(2 * k, 2);
    TestShapes::Shape half = s;
    half.triangles.clear();
    std::vector<Index> number(static_cast<std::size_t>(s.n_vertices), kNoIndex);
    half.n_vertices = 0;
    // Triangles of Disc come ring by ring, in each ring side by side: 1 and 3 a side.
    const auto keep = [&](int first, int n) {
        for (int i = 3 * first; i < 3 * (first + n); ++i) {
            Index& v = number[s.triangles[i]];
            if (v == kNoIndex) v = half.n_vertices++;
            half.triangles.push_back(v);
        }
    };
    keep(0, k);
    keep(2 * k, 3 * k);
    return half;
}

double Modulus(const Spectrum& s, std::size_t i) { return i < s.size() ? std::abs(s[i].value) : 0; }

TEST(MatrixAroundTest, IsTheQuickFormWhereThatSuffices) {
    for (const Sdc::Scheme& scheme : {Sdc::Scheme(Sdc::BoxSpline{}), Sdc::Scheme(Sdc::Loop{})}) {
        const Spectrum s = SpectrumOf(RegularMatrix(scheme));
        EXPECT_EQ(SpectrumText(s), std::holds_alternative<Sdc::Loop>(scheme) ? "1, 1/2 x 2, 1/4 x 3, 1/8"
                                                                             : "1, 1/2 x 3, 1/4 x 6, 1/8 x 4, 1/16");
    }
}

TEST(MatrixAroundTest, RowsSumToOne) {
    for (int n : {3, 5, 9}) {
        const auto m = AroundFirstVertex(TestShapes::Disc(n, 2), Sdc::ModifiedButterfly{});
        for (int i = 0; i < m.size(); ++i) {
            double sum = 0;
            for (int j = 0; j < m.size(); ++j) sum += m.weights[i * m.size() + j];
            EXPECT_NEAR(sum, 1, 1e-14);
        }
    }
}

TEST(RegularSpectrum, OfTheInterpolatorySchemeIsC1UpToOneSixteenth) {
    for (double w : {1.0 / 16, 0.05, 0.03, 0.01}) {
        const Spectrum s = SpectrumOf(RegularMatrix(Sdc::Interpolatory{.tension = w}));
        EXPECT_EQ(SpectrumText(s).substr(0, 10), "1, 1/2 x 3") << w;
        EXPECT_EQ(VerdictOf(s, 3).smoothness, Smoothness::C1) << w;
    }
    const Spectrum s = SpectrumOf(RegularMatrix(Sdc::Interpolatory{}));
    EXPECT_EQ(SpectrumText(s).substr(0, 16), "1, 1/2 x 3, 1/4 ") << "quadratics are reproduced";
}

TEST(RegularSpectrum, OfTheInterpolatorySchemeConvergesBelowOneEighthOnly) {
    const auto second = [](double w) {
        return Modulus(SpectrumOf(RegularMatrix(Sdc::Interpolatory{.tension = w})), 1);
    };
    EXPECT_GT(second(0.09), 0.5 + 1e-2) << "no longer C1";
    EXPECT_NEAR(second(0.12), 1 - 12 * 0.005, 1e-9) << "-12 w + 1/2 in modulus: it reaches 1 at 1/8";
    EXPECT_NEAR(second(0.125 - 1e-9), 1, 1e-7);
    EXPECT_THROW(second(0.125), InvalidInput);
}

TEST(ModifiedButterflySpectrum, IsC1AroundVerticesOfEveryValence) {
    for (int n : {3, 4, 5, 6, 7, 8, 9, 12}) {
        const Spectrum s = SpectrumOf(AroundFirstVertex(TestShapes::Disc(n, 3), Sdc::ModifiedButterfly{}));
        EXPECT_EQ(SpectrumText(s).substr(0, 10), "1, 1/2 x 2") << n;
        EXPECT_NEAR(Modulus(s, 2), 0.25, 1e-4) << n;
    }
}

TEST(ButterflySpectrum, IsNotC1AroundExtraordinaryVertices) {
    const auto of = [](int n) { return SpectrumOf(AroundFirstVertex(TestShapes::Disc(n, 3), Sdc::Butterfly{})); };
    EXPECT_EQ(VerdictOf(of(6), 2).smoothness, Smoothness::C1);
    EXPECT_EQ(VerdictOf(of(3), 2).smoothness, Smoothness::C0) << "Zorin et al. 1996: not at valence 3";
}

// rules.md section 6: 1, 1/2, 1/2, 1/4 for k = 2 to 12.
TEST(ModifiedButterflySpectrum, IsC1AtBorderVertices) {
    for (int k = 2; k <= 12; ++k) {
        const Spectrum s = SpectrumOf(AroundFirstVertex(HalfDisc(k), Sdc::ModifiedButterfly{}));
        EXPECT_EQ(SpectrumText(s).substr(0, 10), "1, 1/2 x 2") << k;
        EXPECT_NEAR(Modulus(s, 2), 0.25, 1e-4) << k;
    }
    // The eight-point rule has no ring of its own there: not C1 but at k = 3.
    for (int k : {2, 4, 5}) {
        const Spectrum s = SpectrumOf(AroundFirstVertex(HalfDisc(k), Sdc::Butterfly{}));
        EXPECT_NE(SpectrumText(s).substr(0, 10), "1, 1/2 x 2") << k << ": " << SpectrumText(s);
    }
}

}  // namespace
