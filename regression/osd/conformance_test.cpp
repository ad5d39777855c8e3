// SPDX-License-Identifier: Apache-2.0
// Runs the conformance suite on every backend of the list, and the list's own promises.
#include <gtest/gtest.h>
#include <solidsubdiv/osd/backends.h>
#include <solidsubdiv/osd/cpu/internal/kernels.h>

#include "osd/conformance.h"

namespace SolidSubdiv::TestOsd {
namespace {

struct Case {
    const Osd::Backend* backend;
    const Check* check;
};

std::vector<Case> AllCases() {
    std::vector<Case> cases;
    for (const Osd::Backend& backend : Osd::Backends()) {
        for (const Check& check : kConformance) cases.push_back({&backend, &check});
    }
    return cases;
}

class Conformance : public testing::TestWithParam<Case> {};

TEST_P(Conformance, Holds) { EXPECT_EQ(GetParam().check->Run(*GetParam().backend), ""); }

INSTANTIATE_TEST_SUITE_P(Backends, Conformance, testing::ValuesIn(AllCases()), [](const auto& param) {
    return std::string(param.param.backend->name()) + "_" + param.param.check->name;
});

TEST(Backends, AreFoundByTheirNames) {
    for (const Osd::Backend& backend : Osd::Backends()) EXPECT_EQ(&Osd::BackendOf(backend.name()), &backend);
    EXPECT_EQ(Osd::Backend::Reference().name(), "reference");
    EXPECT_EQ(Osd::Backend::Best().name(), "cpu");
    try {
        Osd::BackendOf("gpu");
        FAIL();
    } catch (const InvalidInput& error) {
        EXPECT_STREQ(error.what(), "there is no backend 'gpu'; there are reference, cpu");
    }
}

/// The sums of doubles run in the same order in both, each product rounded before it is added.
TEST(Backends, CpuAndReferenceGiveTheSameDoubles) {
    for (const Index n_sources : kSourceCounts) {
        const auto rows = RandomRows<double>(n_sources, 300, 21, false);
        for (const auto& [from, to] : Layouts()) {
            Trial<double> reference(rows, from, to, 22, false), cpu = reference;
            reference.Run(Osd::BackendOf("reference").eval<double>());
            cpu.Run(Osd::BackendOf("cpu").eval<double>());
            EXPECT_TRUE(SameBits(reference.destination, cpu.destination)) << "length " << from.length;
        }
    }
}

template <class Real>
void ExpectSameBitsOfInstructions() {
    const auto rows = RandomRows<Real>(50, 300, 23, false);
    auto layouts = Layouts();
    layouts.push_back({{0, 4, 4}, {0, 3, 3}});  // a copied source
    for (const auto& [from, to] : layouts) {
        Trial<Real> baseline(rows, from, to, 24, false), best = baseline;
        baseline.Run(&Osd::Internal::EvalRowsBaseline<Real>);
        best.Run(Osd::Internal::BestEvalRows<Real>());
        EXPECT_TRUE(SameBits(baseline.destination, best.destination)) << "length " << to.length;
    }
}

TEST(CpuBackend, EverySetOfInstructionsGivesTheSameBits) {
    ExpectSameBitsOfInstructions<float>();
    ExpectSameBitsOfInstructions<double>();
}

/// The suite holds for what processors without AVX2 run, too.
TEST(CpuBackend, BaselineConforms) {
    const Osd::Backend baseline("baseline", &Osd::Internal::EvalRowsBaseline<float>,
                                &Osd::Internal::EvalRowsBaseline<double>);
    for (const Check& check : kConformance) EXPECT_EQ(check.Run(baseline), "") << check.name;
}

}  // namespace
}  // namespace SolidSubdiv::TestOsd
