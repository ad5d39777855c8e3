// SPDX-License-Identifier: Apache-2.0
// The counting validator: right on cases that can be counted by hand, and catches wrong counts and wrong cells.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>

#include "validation/counts.h"
#include "validation/meshes.h"
#include "validation/solid_shapes.h"

namespace SolidSubdiv::Validation {
namespace {

std::vector<CountedLevel> LevelsOfOneTet() {
    const std::vector<Index> tet = {0, 1, 2, 3};
    Far::TopologyDescriptor descriptor;
    descriptor.n_vertices = 4;
    descriptor.tets = tet;
    auto refiner = Far::TopologyRefiner::Create(descriptor, Sdc::Split::TetOct);
    Far::UniformRefinementOptions options;
    options.max_level = 2;
    refiner.RefineUniform(options);
    return LevelsOf(refiner);
}

TEST(CellsOracle, CountsPartsOfATetAndAnOct) {
    EXPECT_EQ(CountParts({{{0, 1, 2, 3}}, {}}), (PartCounts{4, 6, 4, 1, 0}));
    EXPECT_EQ(CountParts({{}, {{0, 1, 2, 3, 4, 5}}}), (PartCounts{6, 12, 8, 0, 1}));
    // Split by hand: 4 + 6 vertices; 4 tets around one octahedron, which shares its other four faces with nobody.
    EXPECT_EQ(CountsAfterSplit({4, 6, 4, 1, 0}), (PartCounts{10, 24, 20, 4, 1}));
}

TEST(CellsOracle, BoundaryIsSeenCounterclockwiseFromOutside) {
    for (const SolidShape& shape : ManifoldShapes()) {
        double volume = 0;  // six times, by the divergence theorem: positive if the boundary looks outwards
        for (const Triangle& t : BoundaryTriangles(shape.complex)) {
            std::array<std::array<double, 3>, 3> p;
            for (int k = 0; k < 3; ++k) std::copy_n(&shape.positions[3 * t[k]], 3, p[k].begin());
            volume += p[0][0] * (p[1][1] * p[2][2] - p[1][2] * p[2][1]) -
                      p[0][1] * (p[1][0] * p[2][2] - p[1][2] * p[2][0]) +
                      p[0][2] * (p[1][0] * p[2][1] - p[1][1] * p[2][0]);
        }
        EXPECT_GT(volume, 0) << shape.name;
    }
}

TEST(CountsValidator, PassesOnTheFrameworksOwnLevels) {
    Findings findings;
    CompareCounts(LevelsOfOneTet(), findings);
    EXPECT_TRUE(findings.Passes(0)) << findings.where;
    EXPECT_EQ(findings.n_compared, 30);
}

TEST(CountsValidator, CatchesEveryCountThatIsOffByOne) {
    const auto plant = [](auto PartCounts::*part) {
        auto levels = LevelsOfOneTet();
        ++(levels[2].counts.*part);
        Findings findings;
        CompareCounts(levels, findings);
        return findings.largest_error;
    };
    EXPECT_EQ(plant(&PartCounts::n_vertices), 1);
    EXPECT_EQ(plant(&PartCounts::n_edges), 1);
    EXPECT_EQ(plant(&PartCounts::n_faces), 1);
    EXPECT_EQ(plant(&PartCounts::n_tets), 1);
    EXPECT_EQ(plant(&PartCounts::n_octs), 1);
}

TEST(CountsValidator, CatchesAChildWithAWrongVertex) {
    auto levels = LevelsOfOneTet();
    auto& tet = levels[1].cells.tets[0];
    for (int v = 0; v < 10; ++v) {
        if (std::find(tet.begin(), tet.end(), v) == tet.end()) {
            tet[3] = v;
            break;
        }
    }
    Findings findings;
    CompareCounts(levels, findings);
    EXPECT_FALSE(findings.Passes(0));
}

TEST(CountsValidator, CatchesAPublishedFigureThatIsNotMet) {
    constexpr std::array<std::int64_t, 3> kRight = {1, 5, 34}, kWrong = {1, 5, 35};
    Findings right, wrong;
    ComparePublished(LevelsOfOneTet(), kRight, right);
    ComparePublished(LevelsOfOneTet(), kWrong, wrong);
    EXPECT_TRUE(right.Passes(0));
    EXPECT_EQ(wrong.largest_error, 1);
}

}  // namespace
}  // namespace SolidSubdiv::Validation
