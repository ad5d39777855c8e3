// SPDX-License-Identifier: Apache-2.0
// The words that eigenvalues and characteristic maps get.
#include <gtest/gtest.h>

#include "kit/analysis/analysis_testing.h"

namespace {

using namespace SolidSubdiv;
using namespace SolidSubdiv::Analysis;

TEST(SeparationOfTest, AsksForThreeRealEigenvaluesAboveTheOthers) {
    const auto is_separated = [](const Spectrum& s) { return SeparationOf(s, 3).is_separated; };
    EXPECT_TRUE(is_separated({{1.0, 1}, {0.5, 1}, {0.4, 2}, {0.3, 1}}));
    EXPECT_TRUE(is_separated({{1.0, 1}, {0.6, 2}, {0.5, 1}, {0.4, 1}}));
    EXPECT_FALSE(is_separated({{1.0, 1}, {0.5, 1}, {0.45, 1}, {0.4, 2}}));
    EXPECT_FALSE(is_separated({{1.0, 1}, {0.5, 4}}));
    EXPECT_FALSE(is_separated({{1.0, 1}, {0.5, 1}, {{0.3, 0.3}, 1}, {{0.3, -0.3}, 1}, {0.1, 1}}));
    EXPECT_FALSE(is_separated({{1.0, 1}, {1.0, 1}}));
    EXPECT_FALSE(is_separated({}));
}

TEST(VerdictOfTest, NamesEachCase) {
    const auto verdict = [](const Spectrum& s) { return VerdictOf(s, 2).smoothness; };
    EXPECT_EQ(verdict({{1.0, 1}, {0.5, 2}, {0.25, 3}}), Smoothness::C2);
    EXPECT_EQ(verdict({{1.0, 1}, {0.5, 2}, {0.3, 1}}), Smoothness::C1);
    EXPECT_EQ(verdict({{1.0, 1}, {0.4, 2}, {0.1, 1}}), Smoothness::C1) << "at most the square, but not 1/2";
    EXPECT_EQ(verdict({{1.0, 1}, {0.5, 1}, {0.4, 1}, {0.3, 1}}), Smoothness::Uneven);
    EXPECT_EQ(verdict({{1.0, 1}, {-0.5, 2}, {0.3, 1}}), Smoothness::C0) << "flips at every split";
    EXPECT_EQ(verdict({{1.0, 1}, {0.5, 2}, {0.25, 3}, {-0.25, 1}}), Smoothness::C1);
    EXPECT_EQ(verdict({{1.0, 1}, {0.6, 1}, {0.5, 2}}), Smoothness::C0);
    EXPECT_EQ(verdict({{1.0, 1}, {{0.3, 0.4}, 1}, {{0.3, -0.4}, 1}}), Smoothness::C0);
    EXPECT_EQ(verdict({{1.0, 2}, {0.5, 2}}), Smoothness::Diverges);
    EXPECT_EQ(verdict({{1.2, 1}, {1.0, 1}}), Smoothness::Diverges);
}

TEST(VerdictOfTest, AsksTheCharacteristicMap) {
    const Spectrum s = {{1.0, 1}, {0.5, 2}, {0.25, 3}};
    const auto verdict = [&](const CharacteristicMap& map) { return VerdictOf(s, 2, map).smoothness; };
    EXPECT_EQ(verdict({.smallest = 0.5, .largest = 1, .n_samples = 9}), Smoothness::C2);
    EXPECT_EQ(verdict({.smallest = -0.01, .largest = 1, .n_samples = 9}), Smoothness::C0);
    EXPECT_EQ(verdict({.smallest = 0, .largest = 1, .n_samples = 9}), Smoothness::C0);
    EXPECT_EQ(verdict({.is_defective = true}), Smoothness::C0);
}

TEST(VerdictOfTest, LetsFunctionsThatAreConstantAlongAnEdgeShrinkSlower) {
    const Spectrum s = {{1.0, 1}, {0.6, 2}, {0.55, 2}, {0.5, 1}, {0.3, 2}};
    const auto verdict = [&](const EdgeEigenvalues& edge) {
        return VerdictOf(s, 3, CharacteristicMap{.smallest = 0.5, .largest = 1, .n_samples = 9, .edge = edge})
            .smoothness;
    };
    EXPECT_EQ(VerdictOf(s, 3).smoothness, Smoothness::C0);
    EXPECT_EQ(verdict({0.6, 0.55, 0.5, 0.3}), Smoothness::Uneven);
    EXPECT_EQ(verdict({0.6, 0.6, 0.5, 0.3}), Smoothness::C0) << "a third function across as slow as the pair";
    EXPECT_EQ(verdict({0.6, 0.3, 0.5, 0.55}), Smoothness::C0) << "one that varies along the edge, and slower";
}

/// Planted: some weight moved from a point to another in one row.
TEST(AnalyzeMatrixTest, APerturbedRowChangesTheVerdict) {
    const Sdc::Scheme scheme = Sdc::BoxSpline{};
    const Star star = RegularStar(scheme);
    Far::LocalMatrix m = MatrixOf(star, scheme);
    EXPECT_EQ(AnalyzeMatrix(m, star, scheme).verdict.smoothness, Smoothness::C2);
    const auto n = static_cast<std::size_t>(m.size());
    m.weights[n + 1] += 1e-3;
    m.weights[n] -= 1e-3;
    EXPECT_NE(AnalyzeMatrix(m, star, scheme).verdict.smoothness, Smoothness::C2);
    m.weights[0] -= 1e-3;  // no longer affine; all eigenvalues stay below 1
    EXPECT_EQ(AnalyzeMatrix(m, star, scheme).verdict.smoothness, Smoothness::Diverges);
    EXPECT_EQ(AnalyzeMatrix(m, star, scheme).verdict.text.substr(0, 10), "not affine");
}

}  // namespace
