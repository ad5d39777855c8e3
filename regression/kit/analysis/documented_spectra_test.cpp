// SPDX-License-Identifier: Apache-2.0
// The figures of docs/schemes/: spectra of the interpolating schemes by tension, by valence and across faces.
#include <gtest/gtest.h>
#include <solidsubdiv/kit/analysis/subdivision_matrix.h>

#include <array>
#include <cmath>
#include <map>
#include <vector>

#include "kit/analysis/analysis_testing.h"
#include "test_shapes.h"

namespace {

using namespace SolidSubdiv;
using namespace SolidSubdiv::Analysis;

constexpr double kQuoted = 5e-4;  // three digits

Smoothness RegularSmoothness(const Sdc::Scheme& scheme) {
    const bool is_solid = std::holds_alternative<Sdc::Interpolatory>(scheme);
    return VerdictOf(SpectrumOf(RegularMatrix(scheme)), is_solid ? 3 : 2).smoothness;
}

/// The moduli after the eigenvalue 1.
std::vector<double> After1(const Spectrum& spectrum) {
    std::vector<double> moduli;
    for (const Eigenvalue& e : spectrum) {
        moduli.insert(moduli.end(), static_cast<std::size_t>(e.multiplicity), std::abs(e.value));
    }
    moduli.erase(moduli.begin());
    return moduli;
}

// docs/schemes/interpolatory.md: an eigenvalue 12 w - 1/2 in modulus passes 1/2 at w = 1/12.
TEST(DocumentedSpectra, OfInterpolatorySolidsAreC1BelowOneTwelfth) {
    for (double w : {0.001, 1.0 / 32, 1.0 / 16, 0.07, 0.083}) {
        EXPECT_EQ(RegularSmoothness(Sdc::Interpolatory{.tension = w}), Smoothness::C1) << w;
    }
    for (double w : {0.0, 0.0834, 0.09, 0.12}) {
        EXPECT_EQ(RegularSmoothness(Sdc::Interpolatory{.tension = w}), Smoothness::C0) << w;
    }
}

// docs/schemes/butterfly.md, of the far points' weight.
TEST(DocumentedSpectra, OfTheModifiedButterflyAreC1FromMinusOneSixteenthToOneTwentyFourth) {
    for (double w : {-0.0624, -1.0 / 32, 0.0, 1.0 / 32, 0.0416}) {
        EXPECT_EQ(RegularSmoothness(Sdc::ModifiedButterfly{.far_weight = w}), Smoothness::C1) << w;
    }
    for (double w : {-1.0 / 16, 0.0418, 1.0 / 16}) {
        EXPECT_EQ(RegularSmoothness(Sdc::ModifiedButterfly{.far_weight = w}), Smoothness::C0) << w;
    }
}

Spectrum AroundApex(int n, const Sdc::Scheme& scheme) {
    const TestShapes::Shape disc = TestShapes::Disc(n, 3);
    auto refiner =
        Far::TopologyRefiner::Create({.n_vertices = disc.n_vertices, .triangles = disc.triangles}, Sdc::Split::TetOct);
    refiner.RefineUniform({.max_level = 4});
    return SpectrumOf(MatrixAround(refiner, 0, 0, scheme).value());
}

// docs/schemes/butterfly.md: the eight-point rule by valence, the two largest pairs.
TEST(DocumentedSpectra, OfTheButterflyByValence) {
    const std::map<int, std::array<double, 2>> quoted = {{4, {0.469, 0.250}},  {5, {0.507, 0.250}}, {6, {0.5, 0.25}},
                                                         {7, {0.482, 0.406}},  {8, {0.469, 0.462}}, {9, {0.497, 0.444}},
                                                         {10, {0.507, 0.429}}, {12, {0.500, 0.469}}};
    for (const auto& [n, pairs] : quoted) {
        const std::vector<double> moduli = After1(AroundApex(n, Sdc::Butterfly{}));
        EXPECT_NEAR(moduli[0], pairs[0], kQuoted) << n;
        EXPECT_NEAR(moduli[1], pairs[0], kQuoted) << n;
        EXPECT_NEAR(moduli[2], pairs[1], kQuoted) << n;
    }
    // Valence 3: seven alike, so that the height shrinks no faster than the two others.
    const Spectrum at_3 = AroundApex(3, Sdc::Butterfly{});
    EXPECT_EQ(SpectrumText(at_3).substr(0, 10), "1, 1/4 x 7");
    EXPECT_EQ(VerdictOf(at_3, 2).smoothness, Smoothness::C0);
    // What goes round twice at valence 2n goes round once at valence n: at 8, 10 and 12 that is the largest pair.
    for (int n : {4, 5, 6}) {
        EXPECT_NEAR(After1(AroundApex(n, Sdc::Butterfly{}))[0], After1(AroundApex(2 * n, Sdc::Butterfly{}))[0], 1e-4)
            << n;
    }
}

/// Around a vertex inside the face of two tets, which choose the same of its edges for their B edges or not.
Spectrum InsideAFace(bool is_matched, const Sdc::Scheme& scheme) {
    const std::vector<Index> tets =
        is_matched ? std::vector<Index>{0, 1, 2, 3, 1, 0, 2, 4} : std::vector<Index>{0, 1, 2, 3, 2, 0, 1, 4};
    auto refiner = Far::TopologyRefiner::Create({.n_vertices = 5, .tets = tets}, Sdc::Split::TetOct);
    refiner.RefineUniform({.max_level = 5});
    const auto middle = [&](int level, Index a, Index b) {
        return refiner.level(level).n_vertices + refiner.level(level).FindEdge(a, b);
    };
    const Index inside = middle(1, middle(0, 0, 1), middle(0, 0, 2));
    return SpectrumOf(MatrixAround(refiner, 2, inside, scheme).value());
}

// docs/schemes/interpolatory.md and box-spline.md.
TEST(DocumentedSpectra, InsideOriginalFacesAreRegularWhereTheTetsMatch) {
    const Sdc::Scheme interpolatory = Sdc::Interpolatory{}, box_spline = Sdc::BoxSpline{};
    for (const Sdc::Scheme& scheme : {interpolatory, box_spline}) {
        EXPECT_EQ(SpectrumText(InsideAFace(true, scheme)), SpectrumText(SpectrumOf(RegularMatrix(scheme))));
    }
    EXPECT_NEAR(After1(InsideAFace(false, interpolatory))[0], 0.698, kQuoted);
    for (double modulus : After1(InsideAFace(false, interpolatory))) {
        EXPECT_GT(std::abs(modulus - 0.5), 5e-3) << "linear functions are not reproduced";
    }
    EXPECT_NEAR(After1(InsideAFace(false, box_spline))[0], 0.512, kQuoted);
}

// docs/schemes/README.md: around inner edges, the pair across the edge and the largest of the rest.
TEST(DocumentedSpectra, AroundEdges) {
    struct Quoted {
        Sdc::Scheme scheme;
        std::map<int, std::array<double, 2>> by_cells;
    };
    const std::map<int, std::array<double, 2>> of_quads = {
        {3, {0.4101, 0.25}}, {4, {0.5, 0.25}}, {5, {0.550, 0.340}}, {6, {0.580, 0.410}}, {7, {0.599, 0.462}}};
    std::map<int, std::array<double, 2>> of_classic = of_quads;
    of_classic[3] = {0.4101, 0.234};
    const std::vector<Quoted> all = {{Sdc::Mlca{}, of_quads},
                                     {Sdc::CatmullClarkSolid{}, of_classic},
                                     {Sdc::SmoothTet{},
                                      {{3, {0.317, 0.287}},
                                       {4, {0.428, 0.287}},
                                       {5, {0.495, 0.287}},
                                       {6, {0.536, 0.317}},
                                       {7, {0.562, 0.379}},
                                       {8, {0.580, 0.428}}}},
                                     {Sdc::BoxSpline{},
                                      {{3, {0.410, 0.307}},
                                       {4, {0.5, 0.25}},
                                       {5, {0.550, 0.340}},
                                       {6, {0.5, 0.25}},
                                       {7, {0.599, 0.462}},
                                       {8, {0.552, 0.375}}}}};
    for (const auto& [scheme, by_cells] : all) {
        for (const auto& [n, quoted] : by_cells) {
            SCOPED_TRACE(std::string(Sdc::NameOf(scheme)) + " " + std::to_string(n));
            const Spectrum spectrum = SpectrumOf(EdgeMatrix(scheme, n));
            EXPECT_TRUE(SeparationOf(spectrum, 3).is_separated);
            const std::vector<double> moduli = After1(spectrum);
            EXPECT_NEAR(moduli[quoted[0] < 0.5 ? 1 : 0], quoted[0], kQuoted);
            EXPECT_NEAR(moduli[quoted[0] < 0.5 ? 0 : 2], 0.5, 1e-9) << "along the edge";
            EXPECT_NEAR(moduli[3], quoted[1], kQuoted);
        }
    }
    EXPECT_FALSE(SeparationOf(SpectrumOf(EdgeMatrix(Sdc::Mlca{}, 8)), 3).is_separated);
    for (int n : {5, 7}) {
        EXPECT_FALSE(SeparationOf(SpectrumOf(EdgeMatrix(Sdc::Interpolatory{}, n)), 3).is_separated) << n;
    }
}

}  // namespace
