// SPDX-License-Identifier: Apache-2.0
// Characteristic maps: regular where the literature says so, folded and collapsed ones found.
#include <gtest/gtest.h>

#include <bit>
#include <vector>

#include "kit/analysis/analysis_testing.h"

namespace {

using namespace SolidSubdiv;
using namespace SolidSubdiv::Analysis;

PlaceReport OfValence(const Sdc::Scheme& scheme, int n) { return AnalyzeStar(SurfaceStar(scheme, n, false), scheme); }

// Of an affine map all Jacobians are alike; round-off of eigenvectors.
TEST(CharacteristicMapTest, OfRegularLatticesIsAffine) {
    Sdc::ForEachScheme([](auto s) {
        const Sdc::Scheme scheme = s;
        if (Sdc::NameOf(scheme).starts_with("linear")) return;  // 1/2 has too many eigenvectors for one map
        const PlaceReport report = AnalyzeStar(RegularStar(scheme), scheme);
        ASSERT_TRUE(report.map.has_value()) << Sdc::NameOf(scheme);
        EXPECT_NEAR(report.map->ratio(), 1, 1e-9) << Sdc::NameOf(scheme);
    });
}

// Peters and Reif 1998 for Catmull-Clark, Umlauf 2000 for Loop, Zorin 2000 for the modified butterfly: C1 at every
// valence.
TEST(CharacteristicMapTest, OfSurfacesIsRegularAtEveryValence) {
    for (const Sdc::Scheme& scheme :
         {Sdc::Scheme(Sdc::Loop{}), Sdc::Scheme(Sdc::CatmullClark{}), Sdc::Scheme(Sdc::ModifiedButterfly{})}) {
        for (int n = 3; n <= 16; ++n) {
            const PlaceReport report = OfValence(scheme, n);
            ASSERT_TRUE(report.map.has_value()) << Sdc::NameOf(scheme) << n;
            EXPECT_TRUE(report.map->is_regular()) << Sdc::NameOf(scheme) << n;
            EXPECT_GE(report.verdict.smoothness, Smoothness::C1) << Sdc::NameOf(scheme) << n;
        }
    }
}

// Biermann, Levin, Zorin 2000: rules of a smooth border with many faces have two eigenvalues above the 1/2 along it, so
// the border shrinks to a point of the map.
TEST(CharacteristicMapTest, CollapsesAtBordersOfManyFaces) {
    const Sdc::Scheme scheme = Sdc::CatmullClark{};
    const PlaceReport report = AnalyzeStar(SurfaceStar(scheme, 6, true), scheme);
    ASSERT_TRUE(report.map.has_value());
    EXPECT_LT(report.map->ratio(), 1e-9);
    EXPECT_EQ(report.verdict.smoothness, Smoothness::C0) << report.verdict.text;
    EXPECT_EQ(AnalyzeStar(SurfaceStar(scheme, 2, true), scheme).verdict.smoothness, Smoothness::C2);
}

TEST(SampleJacobiansTest, FindsAFold) {
    const std::vector<Index> tets{0, 1, 2, 3}, triangles{0, 1, 2}, hexes{0, 1, 2, 3, 4, 5, 6, 7};
    const auto ratio = [](const Far::TopologyDescriptor& mesh, Sdc::Split split, const std::vector<double>& points,
                          int dimension) {
        auto refiner = Far::TopologyRefiner::Create(mesh, split);
        return SampleJacobians(refiner, 0, points, dimension).ratio();
    };
    const std::vector<Index> two_tets{0, 1, 2, 3, 0, 2, 1, 4};
    const Far::TopologyDescriptor pair{.n_vertices = 5, .tets = two_tets};
    const std::vector<double> apart{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, -1};
    EXPECT_EQ(ratio(pair, Sdc::Split::TetOct, apart, 3), 1);
    std::vector<double> folded = apart;
    folded.back() = 0.5;  // the second tet lies in the first
    EXPECT_EQ(ratio(pair, Sdc::Split::TetOct, folded, 3), -0.5);

    const std::vector<Index> two_triangles{0, 1, 2, 2, 1, 3};
    Far::TopologyDescriptor sheet{.n_vertices = 4};
    sheet.triangles = two_triangles;
    EXPECT_EQ(ratio(sheet, Sdc::Split::TetOct, {0, 0, 1, 0, 0, 1, 1, 1}, 2), 1);
    EXPECT_LT(ratio(sheet, Sdc::Split::TetOct, {0, 0, 1, 0, 0, 1, 0.1, 0.1}, 2), 0);

    Far::TopologyDescriptor cube{.n_vertices = 8};
    cube.hexes = hexes;
    std::vector<double> corners{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1};
    EXPECT_EQ(ratio(cube, Sdc::Split::Polyhedral, corners, 3), 1);
    corners[3 * 6] = corners[3 * 6 + 1] = corners[3 * 6 + 2] = 0.2;  // pushed in beyond the middle of the other corners
    EXPECT_LT(ratio(cube, Sdc::Split::Polyhedral, corners, 3), 0);
}

// The pair across and the direction along, where other eigenvalues lie between them.
TEST(CharacteristicMapTest, TellsFunctionsAlongAnEdgeFromThoseAcross) {
    for (const Sdc::Scheme& scheme :
         {Sdc::Scheme(Sdc::Mlca{}), Sdc::Scheme(Sdc::CatmullClarkSolid{}), Sdc::Scheme(Sdc::BoxSpline{})}) {
        const PlaceReport report = AnalyzeStar(EdgeStar(scheme, 9), scheme);
        ASSERT_TRUE(report.map && report.map->edge) << Sdc::NameOf(scheme);
        const EdgeEigenvalues& edge = *report.map->edge;
        // Those of the surface scheme at valence 9, and the line's 1/2.
        EXPECT_NEAR(edge.across, 0.61994, 5e-6);
        EXPECT_NEAR(edge.next_across, 0.52843, 5e-6);
        EXPECT_NEAR(edge.along, 0.5, 1e-9);
        EXPECT_LT(edge.next_along, 0.4);
        EXPECT_TRUE(report.map->is_regular());
        EXPECT_EQ(report.verdict.smoothness, Smoothness::Uneven) << report.verdict.text;
    }
    const Sdc::Scheme interpolatory = Sdc::Interpolatory{};
    for (int n : {5, 7, 9}) {
        EXPECT_EQ(AnalyzeStar(EdgeStar(interpolatory, n), interpolatory).verdict.smoothness, Smoothness::C0) << n;
    }
}

// Seven tets around an edge, three with their diagonal along it: two eigenvalues .5692 are 1e-4 apart, not equal.
TEST(CharacteristicMapTest, TakesCloseEigenvaluesForTwo) {
    const Sdc::Scheme scheme = Sdc::BoxSpline{};
    int n_close = 0;
    for (unsigned along = 0; along < 128; ++along) {
        if (std::popcount(along) != 3) continue;
        std::vector<Index> tets;
        for (int i = 0; i < 7; ++i) {
            const Index a = 2 + i, b = 2 + (i + 1) % 7;
            if ((along >> i & 1) != 0) {
                tets.insert(tets.end(), {0, 1, a, b});
            } else if (i % 2 == 0) {
                tets.insert(tets.end(), {0, a, b, 1});
            } else {
                tets.insert(tets.end(), {0, b, 1, a});
            }
        }
        const auto refiner = Far::TopologyRefiner::Create({.n_vertices = 9, .tets = tets}, Sdc::Split::TetOct);
        const Star star = PointOnEdge(refiner, 0, refiner.level(0).FindEdge(0, 1));
        const Spectrum coarse = SpectrumOf(MatrixOf(star, scheme));
        n_close += coarse[1].multiplicity == 2 && SpectrumOf(MatrixOf(star, scheme), 1e-7)[1].multiplicity == 1;
        const PlaceReport report = AnalyzeStar(star, scheme);
        EXPECT_FALSE(report.map && report.map->is_defective) << along << " " << report.verdict.text;
    }
    EXPECT_GT(n_close, 0) << "the test meets the case";
}

}  // namespace
