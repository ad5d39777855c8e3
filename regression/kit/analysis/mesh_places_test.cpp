// SPDX-License-Identifier: Apache-2.0
// Places of whole meshes: the quoted spectra found again, kinds that don't depend on numbers, nothing counted twice.
#include <gtest/gtest.h>
#include <solidsubdiv/kit/analysis/mesh_places.h>

#include <map>
#include <numeric>

#include "kit/analysis/analysis_testing.h"
#include "polyhedral_shapes.h"
#include "test_shapes.h"

namespace {

using namespace SolidSubdiv;
using namespace SolidSubdiv::Analysis;

Far::TopologyRefiner RefinerOf(const TestShapes::Shape& s) {
    return Far::TopologyRefiner::Create(
        {.n_vertices = s.n_vertices, .tets = s.tets, .octs = s.octs, .triangles = s.triangles, .edges = s.edges},
        Sdc::Split::TetOct);
}

std::vector<PlaceKind> KindsOf(const MeshPlaces& places, PlaceType type) {
    std::vector<PlaceKind> kinds;
    for (const PlaceKind& kind : places.kinds) {
        if (kind.type == type) kinds.push_back(kind);
    }
    return kinds;
}

Index Total(const std::vector<PlaceKind>& kinds) {
    return std::accumulate(kinds.begin(), kinds.end(), 0, [](Index n, const PlaceKind& k) { return n + k.count; });
}

TestShapes::Shape TetsAroundEdge(int n) {
    TestShapes::Shape s;
    s.n_vertices = n + 2;
    for (int i = 0; i < n; ++i) s.tets.insert(s.tets.end(), {0, 1, 2 + i, 2 + (i + 1) % n});
    return s;
}

// rules.md section 2 and docs/schemes/README.md: what EdgeStar gives, through the mesh.
TEST(PlacesOfTest, FindTheQuotedSpectraOfEdges) {
    for (const Sdc::Scheme& scheme :
         {Sdc::Scheme(Sdc::BoxSpline{}), Sdc::Scheme(Sdc::Interpolatory{}), Sdc::Scheme(Sdc::SmoothTet{})}) {
        for (int n : {3, 5}) {
            const auto refiner = RefinerOf(TetsAroundEdge(n));
            const auto kinds = KindsOf(PlacesOf(refiner, scheme), PlaceType::InnerEdge);
            ASSERT_EQ(kinds.size(), 1u);
            EXPECT_EQ(kinds[0].count, 1);
            const PlaceReport report = AnalyzeStar(StarOf(refiner, kinds[0]), scheme);
            EXPECT_EQ(SpectrumText(report.spectrum), SpectrumText(SpectrumOf(EdgeMatrix(scheme, n))));
        }
    }
}

TEST(PlacesOfTest, FindTheQuotedSpectraOfFaces) {
    const auto modulus = [](const Sdc::Scheme& scheme, const std::vector<Index>& tets) {
        TestShapes::Shape s;
        s.n_vertices = 5;
        s.tets = tets;
        const auto refiner = RefinerOf(s);
        const auto kinds = KindsOf(PlacesOf(refiner, scheme), PlaceType::InnerFace);
        EXPECT_EQ(kinds.size(), 1u);
        return std::abs(AnalyzeStar(StarOf(refiner, kinds.at(0)), scheme).spectrum[1].value);
    };
    const std::vector<Index> matched{0, 1, 2, 3, 1, 0, 2, 4}, unmatched{0, 1, 2, 3, 0, 2, 1, 4};
    EXPECT_NEAR(modulus(Sdc::Interpolatory{}, matched), 0.5, 1e-9);
    EXPECT_NEAR(modulus(Sdc::Interpolatory{}, unmatched), 0.698, 5e-4) << "rules.md section 1";
    EXPECT_NEAR(modulus(Sdc::BoxSpline{}, unmatched), 0.512, 5e-4);
    EXPECT_NEAR(modulus(Sdc::SmoothTet{}, unmatched), 0.5, 1e-9) << "needs no diagonals";
}

/// The same mesh with vertices and cells in another order, and cells turned by even permutations that keep their pair.
TestShapes::Shape Renumbered(const TestShapes::Shape& s, std::uint64_t seed) {
    TestShapes::Random random(seed);
    std::vector<Index> number(static_cast<std::size_t>(s.n_vertices)), order(s.tets.size() / 4);
    std::iota(number.begin(), number.end(), 0);
    std::iota(order.begin(), order.end(), 0);
    random.Shuffle(number);
    random.Shuffle(order);
    TestShapes::Shape other;
    other.n_vertices = s.n_vertices;
    for (Index t : order) {
        const Index* v = &s.tets[4 * static_cast<std::size_t>(t)];
        const bool is_turned = random.Below(2) == 1;
        for (int i : {0, 1, 2, 3}) other.tets.push_back(number[v[is_turned ? (i + 2) % 4 : i]]);
    }
    return other;
}

TEST(PlacesOfTest, DontDependOnNumbers) {
    TestShapes::Shape s = TestShapes::RandomSubset(TestShapes::KuhnBlock(4), 90, 3);
    TestShapes::Random random(5);
    for (std::size_t t = 0; t < s.tets.size(); t += 4) {  // any of the three pairs
        for (int turns = random.Below(3); turns > 0; --turns)
            std::rotate(&s.tets[t + 1], &s.tets[t + 2], &s.tets[t] + 4);
    }
    const auto summary = [](const TestShapes::Shape& shape) {
        std::multimap<std::pair<PlaceType, std::string>, Index> counts;
        const auto places = PlacesOf(RefinerOf(shape), Sdc::BoxSpline{});
        for (const PlaceKind& kind : places.kinds) counts.emplace(std::make_pair(kind.type, kind.what), kind.count);
        std::vector<std::string> lines;
        for (const auto& [key, n] : counts) {
            lines.push_back(std::to_string(static_cast<int>(key.first)) + key.second + " " + std::to_string(n));
        }
        std::sort(lines.begin(), lines.end());
        return lines;
    };
    const auto lines = summary(s);
    EXPECT_GT(lines.size(), 20u);
    for (std::uint64_t seed : {1, 2, 3}) EXPECT_EQ(summary(Renumbered(s, seed)), lines) << seed;
}

// What a kind says of its example holds for all: each place's own spectrum.
TEST(PlacesOfTest, OfOneKindHaveOneSpectrum) {
    const Sdc::Scheme scheme = Sdc::Interpolatory{};  // its rows at a vertex see diagonals
    TestShapes::Shape s = TestShapes::KuhnBlock(3);
    TestShapes::Random random(7);
    for (std::size_t t = 0; t < s.tets.size(); t += 4) {
        for (int turns = random.Below(8) / 6; turns > 0; --turns)
            std::rotate(&s.tets[t + 1], &s.tets[t + 2], &s.tets[t] + 4);
    }
    const auto refiner = RefinerOf(s);
    std::map<std::string, Index> by_spectrum;
    for (Index v = 0; v < refiner.n_vertices(0); ++v) {
        if (refiner.level(0).vertex_tags[v].rule() != Vtr::Rule::Solid) continue;
        ++by_spectrum[SpectrumText(SpectrumOf(MatrixOf(StarOf(refiner, 0, v, false), scheme)))];
    }
    std::map<std::string, Index> by_kind;
    for (const PlaceKind& kind : KindsOf(PlacesOf(refiner, scheme), PlaceType::InnerVertex)) {
        by_kind[SpectrumText(SpectrumOf(MatrixOf(StarOf(refiner, kind), scheme)))] += kind.count;
    }
    EXPECT_GT(by_kind.size(), 1u);
    EXPECT_EQ(by_kind, by_spectrum);
}

TEST(PlacesOfTest, CountEveryInnerPartOnce) {
    const auto refiner = RefinerOf(TestShapes::KuhnBlock(4));
    const Far::Level& level = refiner.level(0);
    const MeshPlaces places = PlacesOf(refiner, Sdc::BoxSpline{});
    EXPECT_EQ(Total(KindsOf(places, PlaceType::InnerVertex)), 27);
    EXPECT_EQ(Total(KindsOf(places, PlaceType::InnerFace)), level.n_faces - level.n_boundary_faces);
    // Euler's formula for a ball's boundary of F triangles: 3/2 F edges.
    EXPECT_EQ(Total(KindsOf(places, PlaceType::InnerEdge)), level.n_edges - 3 * level.n_boundary_faces / 2);
    EXPECT_EQ(Total(KindsOf(places, PlaceType::Surface)), level.n_vertices - 27);
    EXPECT_EQ(places.n_creased + places.n_others, 0);
}

TEST(PlacesOfTest, OfHexahedraAreRegularInABlock) {
    const TestShapes::PolyhedralShape block = TestShapes::HexBlock(3);
    Far::TopologyDescriptor mesh{.n_vertices = block.n_vertices};
    mesh.hexes = block.hexes;
    const auto refiner = Far::TopologyRefiner::Create(mesh, Sdc::Split::Polyhedral);
    for (const Sdc::Features features : {Sdc::Features::Sharp, Sdc::Features::Smooth}) {
        Sdc::CatmullClarkSolid catmull_clark;
        catmull_clark.features = features;
        const Sdc::Scheme scheme = catmull_clark;
        const MeshPlaces places = PlacesOf(refiner, scheme);
        EXPECT_EQ(Total(KindsOf(places, PlaceType::InnerVertex)), 8);
        EXPECT_EQ(Total(KindsOf(places, PlaceType::InnerEdge)), 36);
        EXPECT_EQ(Total(KindsOf(places, PlaceType::InnerFace)), 54);
        EXPECT_EQ(Total(KindsOf(places, PlaceType::InnerCell)), 27);
        // The cube's edges and corners are in one cell each.
        EXPECT_EQ(places.n_creased, features == Sdc::Features::Sharp ? 8 + 12 * 2 : 0);
        EXPECT_EQ(Total(KindsOf(places, PlaceType::Surface)), 56 - places.n_creased);
        for (const PlaceKind& kind : places.kinds) {
            if (kind.what == "3 faces") continue;  // the cube's corners, smooth
            EXPECT_EQ(AnalyzeStar(StarOf(refiner, kind), scheme).verdict.smoothness, Smoothness::C2) << kind.what;
        }
    }
}

// A vertex inside a wedge has three cells around the line along its axis; inside a tet four corners: the spectra of
// those are what mlca and catmull-clark-solid have there for ever.
TEST(PlacesOfTest, OfOtherCellsAreThoseOfTheirPoints) {
    const std::vector<Index> wedges{0, 1, 2, 3, 4, 5};
    Far::TopologyDescriptor mesh{.n_vertices = 6};
    mesh.wedges = wedges;
    const auto refiner = Far::TopologyRefiner::Create(mesh, Sdc::Split::Polyhedral);
    const Sdc::Scheme scheme = Sdc::Mlca{};
    const auto kinds = KindsOf(PlacesOf(refiner, scheme), PlaceType::InnerCell);
    ASSERT_EQ(kinds.size(), 1u);
    EXPECT_EQ(SpectrumText(AnalyzeStar(StarOf(refiner, kinds[0]), scheme).spectrum),
              SpectrumText(SpectrumOf(EdgeMatrix(scheme, 3))));
}

// Of a cell of no volume nothing says which way round it is.
TEST(PlacesOfTest, OfSurfacesDontDependOnHowCellsAreTurned) {
    TestShapes::Shape s = TestShapes::KuhnBlock(2);
    const Sdc::Scheme scheme = Sdc::BoxSpline{};
    const auto smoothness = [&] {
        std::vector<Smoothness> all;
        const auto refiner = RefinerOf(s);
        for (Index v = 0; v < s.n_vertices; ++v) {
            if (refiner.level(0).vertex_tags[v].rule() != Vtr::Rule::Surface) continue;
            all.push_back(AnalyzeStar(StarOf(refiner, 0, v, true), scheme).verdict.smoothness);
        }
        return all;
    };
    const auto before = smoothness();
    EXPECT_EQ(before.size(), 26u);
    for (std::size_t t = 0; t < s.tets.size(); t += 20) std::swap(s.tets[t + 2], s.tets[t + 3]);
    EXPECT_EQ(smoothness(), before);
}

TEST(PlacesOfTest, LeaveOutCreasesAndMixedPlacesAndCountThem) {
    const MeshPlaces mixed = PlacesOf(RefinerOf(TestShapes::MixedDimensions()), Sdc::BoxSpline{});
    EXPECT_GT(mixed.n_others, 0);
    const std::vector<Index> triangles{0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 1}, ends{0, 1, 0, 3};
    const auto n_creased = [&](float sharpness) {
        const std::vector<float> sharp{sharpness, sharpness};
        Far::TopologyDescriptor mesh{.n_vertices = 5};
        mesh.triangles = triangles;
        mesh.crease_edges = ends;
        mesh.crease_sharpness = sharp;
        const MeshPlaces places = PlacesOf(Far::TopologyRefiner::Create(mesh, Sdc::Split::TetOct), Sdc::Loop{});
        EXPECT_EQ(
            Total(KindsOf(places, PlaceType::Surface)) + Total(KindsOf(places, PlaceType::Border)) + places.n_creased,
            5);
        return places.n_creased;
    };
    EXPECT_GT(n_creased(10), 0);
    EXPECT_EQ(n_creased(2), 0) << "gone after two levels";
}

}  // namespace
