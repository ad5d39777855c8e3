// SPDX-License-Identifier: Apache-2.0
// The validator of spectra: its matrices are right by hand, and it catches faults planted in tables.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>

#include "validation/or_skip.h"
#include "validation/spectra.h"

namespace SolidSubdiv::Validation {
namespace {

constexpr double kTolerance = 1e-9;  // that of the validator

class SpectraValidator : public testing::Test {
  protected:
    SpectraValidator()
        : block_(MakeTrussBlock({4, 4, 4}, TrussCells::ParallelDiagonals)),
          refined_(RefinePoints(block_.vertices, block_.tets, block_.octs, 2)),
          middle_(block_.VertexAt({2, 2, 2})) {}

    void SetUp() override {
        OrSkip([] { Spectrum({1.0}, 1); });
    }

    Far::StencilTable Table(const Sdc::BoxSpline& scheme = {}) const {
        return Far::StencilTable::Create(refined_.refiner, scheme);
    }
    static std::vector<Eigenvalue> SpectrumOf(const LocalSubdivision& local) {
        return Spectrum(local.matrix, static_cast<int>(local.offsets.size()));
    }

    TrussBlock block_;
    RefinedPoints refined_;
    Index middle_;
    Findings findings_;
};

const std::vector<QuotedEigenvalue> kBoxSpline = {{1, 1}, {0.5, 3}, {0.25, 6}, {0.125, 1}};

TEST_F(SpectraValidator, ReadsTheVertexRuleOffTheTable) {
    const LocalSubdivision local = SubdivisionAround(refined_, Table().level(1), 0, middle_);
    ASSERT_EQ(local.offsets.size(), 15U);  // the vertex and its 14 neighbours
    EXPECT_EQ(local.matrix[0], 18.0 / 32);
    for (std::size_t k = 1; k < 15; ++k) EXPECT_EQ(local.matrix[k], 1.0 / 32);
    for (std::size_t i = 0; i < 15; ++i) {
        const auto row = local.matrix.begin() + static_cast<std::ptrdiff_t>(15 * i);
        EXPECT_NEAR(std::accumulate(row, row + 15, 0.0), 1, 1e-15) << i;  // sums of dyadic numbers, in any order
    }
}

TEST_F(SpectraValidator, PassesOnTheFrameworksOwnTable) {
    for (int level : {0, 1}) {
        const auto table = Table();
        CompareSpectrum(SpectrumOf(SubdivisionAround(refined_, table.level(level + 1), level, middle_)), kBoxSpline,
                        findings_);
    }
    EXPECT_TRUE(findings_.Passes(kTolerance)) << findings_.where;
}

TEST_F(SpectraValidator, CatchesEveryWeightOfTheVertexRowOffByAMillionth) {
    const auto table = Table();
    for (Offset k = 0; k < table.level(1).offsets[middle_ + 1] - table.level(1).offsets[middle_]; ++k) {
        Far::StencilRows<double> rows = table.level(1);
        rows.weights[rows.offsets[middle_] + k] += 1e-6;
        Findings found;
        CompareSpectrum(SpectrumOf(SubdivisionAround(refined_, rows, 0, middle_)), kBoxSpline, found);
        EXPECT_FALSE(found.Passes(kTolerance)) << k;
        EXPECT_LT(found.largest_error, 1e-5) << k;
    }
}

TEST_F(SpectraValidator, CatchesAnotherRule) {
    Sdc::BoxSpline printed;
    printed.edge_rule = Sdc::EdgeRule::Printed2002;
    CompareSpectrum(SpectrumOf(SubdivisionAround(refined_, Table(printed).level(1), 0, middle_)), kBoxSpline,
                    findings_);
    EXPECT_NEAR(findings_.largest_error, 0.0625, kTolerance);  // 0.3125 instead of 1/4
}

TEST_F(SpectraValidator, RoundingIsAllowedForButNoMore) {
    CompareSpectrum({{{0.27376, 0}, 1}}, {{0.274, 1, 5e-4}}, findings_);
    EXPECT_EQ(findings_.largest_error, 0);
    CompareSpectrum({{{0.2734, 0}, 1}}, {{0.274, 1, 5e-4}}, findings_);
    EXPECT_NEAR(findings_.largest_error, 1e-4, 1e-15);
    CompareSpectrum({{{0.274, 0.01}, 1}}, {{0.274, 1, 5e-4}}, findings_);
    EXPECT_NEAR(findings_.largest_error, 0.0095, 1e-15);
    CompareSpectrum({{{1, 0}, 1}}, {{1, 2}}, findings_);
    EXPECT_THAT(findings_.faults, testing::SizeIs(1));
}

TEST_F(SpectraValidator, CatchesSwappedChildren) {
    // Two of the new points next to the middle change places.
    auto& fine = refined_.points[1];
    const auto at = [&](const LatticePoint& p) { return std::find(fine.begin(), fine.end(), p); };
    ASSERT_NE(at({5, 4, 4}), fine.end());
    std::iter_swap(at({5, 4, 4}), at({4, 5, 4}));
    CompareSpectrum(SpectrumOf(SubdivisionAround(refined_, Table().level(1), 0, middle_)), kBoxSpline, findings_);
    EXPECT_FALSE(findings_.Passes(kTolerance));
}

TEST_F(SpectraValidator, SaysThatAPointIsNotWhereItShouldBe) {
    auto& fine = refined_.points[1];
    *std::find(fine.begin(), fine.end(), LatticePoint{5, 4, 4}) = {99, 0, 0};
    EXPECT_THROW(SubdivisionAround(refined_, Table().level(1), 0, middle_), std::runtime_error);
}

}  // namespace
}  // namespace SolidSubdiv::Validation
