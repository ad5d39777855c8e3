// SPDX-License-Identifier: Apache-2.0
// Sharp edges and vertices: what they cut apart, how they fade, what is refused.
#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <solidsubdiv/far/creases.h>
#include <solidsubdiv/far/limit_stencil_table.h>
#include <solidsubdiv/far/stencil_table.h>

#include "far/far_testing.h"

namespace {

using namespace SolidSubdiv;
using namespace SolidSubdiv::TestFar;
using testing::ElementsAre;
using TestShapes::Shape;

struct Tags {
    std::vector<Index> edges;
    std::vector<float> edge_sharpness;
    std::vector<Index> vertices;
    std::vector<float> vertex_sharpness;
};

Far::TopologyRefiner Refined(const Shape& s, const Tags& tags, int levels, bool full = false) {
    Far::TopologyDescriptor d = Describe(s);
    d.crease_edges = tags.edges;
    d.crease_sharpness = tags.edge_sharpness;
    d.corner_vertices = tags.vertices;
    d.corner_sharpness = tags.vertex_sharpness;
    auto refiner = Far::TopologyRefiner::Create(d, Sdc::Split::TetOct);
    refiner.RefineUniform({.max_level = levels, .full_topology_in_last_level = full});
    return refiner;
}

std::vector<double> Points(const Shape& s, const Tags& tags, const Sdc::Scheme& scheme, int levels) {
    return Apply(Far::StencilTable::Create(Refined(s, tags, levels), scheme), s.positions);
}

/// A shaken grid of n by n squares, and its middle line of edges x = n / 2.
Shape Grid(int n) {
    Shape s = TestShapes::TriangleGrid(n);
    TestShapes::Jitter(s, 0.2, 3);
    return s;
}
Tags MiddleLine(int n, float sharpness) {
    Tags tags;
    for (Index y = 0; y < n; ++y) {
        tags.edges.insert(tags.edges.end(), {n / 2 + (n + 1) * y, n / 2 + (n + 1) * (y + 1)});
        tags.edge_sharpness.push_back(sharpness);
    }
    return tags;
}

std::vector<Sdc::Scheme> SurfaceSchemes() {
    return {Sdc::Loop{}, Sdc::Butterfly{}, Sdc::ModifiedButterfly{}, Sdc::LinearSurface{}};
}

// The two sides of a crease for ever are surfaces of their own, but that the crease's ends on the border are corners.
TEST(Creases, CutASurfaceInTwoForEver) {
    constexpr int kSize = 6, kLevels = 3;
    const Shape whole = Grid(kSize);
    Tags tags = MiddleLine(kSize, 10);
    tags.vertices = {kSize / 2, kSize / 2 + (kSize + 1) * kSize};
    tags.vertex_sharpness = {10, 10};
    std::array<Shape, 2> halves{whole, whole};
    for (Shape& half : halves) half.triangles.clear();
    for (std::size_t t = 0; t < whole.triangles.size(); t += 3) {
        double x = 0;
        for (int k = 0; k < 3; ++k) x += whole.triangles[t + k] % (kSize + 1);
        Shape& half = halves[x / 3 > kSize / 2];
        half.triangles.insert(half.triangles.end(), &whole.triangles[t], &whole.triangles[t] + 3);
    }
    const Tags ends{{}, {}, tags.vertices, tags.vertex_sharpness};
    for (const Sdc::Scheme& scheme : SurfaceSchemes()) {
        SCOPED_TRACE(std::string(Sdc::NameOf(scheme)));
        std::vector<std::array<double, 3>> apart;
        for (const Shape& half : halves) {
            const auto refiner = Refined(half, ends, kLevels);
            const auto points = Points(half, ends, scheme, kLevels);
            std::vector<bool> is_used(points.size() / 3, false);
            for (Index v : refiner.level(kLevels).boundary_vertices) is_used[v] = true;
            std::vector<double> used;
            for (std::size_t v = 0; v < is_used.size(); ++v) {
                if (is_used[v]) used.insert(used.end(), &points[3 * v], &points[3 * v] + 3);
            }
            const auto sorted = SortedPoints(used);
            apart.insert(apart.end(), sorted.begin(), sorted.end());
        }
        // Points on the crease come from both halves.
        std::sort(apart.begin(), apart.end());
        const auto is_same = [](const auto& a, const auto& b) {
            return std::abs(a[0] - b[0]) + std::abs(a[1] - b[1]) + std::abs(a[2] - b[2]) < 1e-9;
        };
        apart.erase(std::unique(apart.begin(), apart.end(), is_same), apart.end());
        const auto together = SortedPoints(Points(whole, tags, scheme, kLevels));
        ASSERT_EQ(together.size(), apart.size());
        for (std::size_t i = 0; i < apart.size(); ++i) EXPECT_TRUE(is_same(together[i], apart[i])) << i;
    }
}

TEST(Creases, OfSharpnessZeroAreNone) {
    const Shape grid = Grid(4);
    for (const Sdc::Scheme& scheme : SurfaceSchemes())
        EXPECT_EQ(Points(grid, MiddleLine(4, 0), scheme, 2), Points(grid, {}, scheme, 2));
    EXPECT_TRUE(Refined(grid, MiddleLine(4, 0), 0).sharpness().empty());
}

TEST(Creases, AreSharpForAsManyLevelsAsTheySay) {
    const Shape grid = Grid(4);
    const auto points = [&](float sharpness, int levels) {
        return Points(grid, MiddleLine(4, sharpness), Sdc::Loop{}, levels);
    };
    EXPECT_EQ(points(3, 3), points(10, 3));
    EXPECT_NE(points(2, 3), points(10, 3));
    EXPECT_EQ(points(12, 3), points(10, 3)) << "above 10 is for ever";
}

// DeRose et al. 1998: between whole numbers the two results are blended.
TEST(Creases, OfFractionalSharpnessAreBlends) {
    const Shape grid = Grid(4);
    const auto at = [&](float sharpness) { return Points(grid, MiddleLine(4, sharpness), Sdc::Loop{}, 1); };
    const auto smooth = at(0), sharp = at(1), half = at(0.25f);
    double largest = 0;
    for (std::size_t i = 0; i < half.size(); ++i) {
        EXPECT_NEAR(half[i], 0.25 * sharp[i] + 0.75 * smooth[i], 1e-14);
        largest = std::max(largest, std::abs(sharp[i] - smooth[i]));
    }
    EXPECT_GT(largest, 1e-3) << "the test can tell";
}

TEST(Creases, KeepRowsThatSumToOneAndLevelsThatGoOn) {
    const Shape grid = Grid(4);
    Tags tags = MiddleLine(4, 0);
    tags.edge_sharpness = {0.3f, 1.7f, 2.5f, 10};
    tags.vertices = {12, 6, 0};
    tags.vertex_sharpness = {1.4f, 0.6f, 10};
    for (const auto method : {Sdc::CreasingMethod::Uniform, Sdc::CreasingMethod::Chaikin}) {
        const Sdc::Loop scheme{.features = Sdc::Features::Sharp, .creasing = method};
        const auto refiner = Refined(grid, tags, 3);
        const auto table = Far::StencilTable::Create(refiner, scheme);
        for (int l = 1; l <= 3; ++l) {
            for (Index row = 0; row < table.level(l).n_rows(); ++row) {
                double sum = 0;
                for (double w : table.level(l).Weights(row)) sum += w;
                ASSERT_NEAR(sum, 1, 1e-15);
            }
        }
        // Level 1 with what is still sharp there, refined on, is level 3. Corners are found anew.
        const auto first = Refined(grid, tags, 1, true);
        const Far::Creases rest = Far::CreasesAt(first, scheme, 1);
        const Shape middle = AsShape(first.level(1), Points(grid, tags, scheme, 1));
        const Tags middle_tags{rest.edges, rest.edge_sharpness, rest.vertices, rest.vertex_sharpness};
        const auto a = SortedPoints(Apply(table, grid.positions));
        const auto b = SortedPoints(Points(middle, middle_tags, scheme, 2));
        ASSERT_EQ(a.size(), b.size());
        for (std::size_t i = 0; i < a.size(); ++i) {
            for (int k = 0; k < 3; ++k) ASSERT_NEAR(a[i][k], b[i][k], 1e-7);  // sums of sharpness are floats
        }
        // Composite rows and interpolation follow the same rules.
        ExpectNear(Apply(Far::StencilTable::CreateComposite(refiner, scheme, {{.level = 3}}), grid.positions),
                   Apply(table, grid.positions), 1e-14);
    }
}

// Found by fuzzing: the vertex is on no surface whose smooth rule it could follow.
TEST(Creases, ACornerOnACurveFadesIntoTheCurve) {
    Shape curve;
    curve.n_vertices = 3;
    curve.edges = {0, 1, 1, 2};
    curve.positions = {0, 0, 0, 1, 2, 0, 2, 0, 0};
    const Tags tags{{}, {}, {1}, {0.25f}};
    const std::vector<double> fading = Points(curve, tags, Sdc::Loop{}, 1), smooth = Points(curve, {}, Sdc::Loop{}, 1);
    EXPECT_EQ(smooth[4], 1.5);
    EXPECT_DOUBLE_EQ(fading[4], 0.25 * 2 + 0.75 * 1.5);
    EXPECT_EQ(Points(curve, {{}, {}, {1}, {10.0f}}, Sdc::Loop{}, 1)[4], 2);
    // The same under the other split.
    Far::TopologyDescriptor d = Describe(curve);
    d.corner_vertices = tags.vertices;
    d.corner_sharpness = tags.vertex_sharpness;
    auto refiner = Far::TopologyRefiner::Create(d, Sdc::Split::Polyhedral);
    refiner.RefineUniform({.max_level = 1});
    EXPECT_EQ(Apply(Far::StencilTable::Create(refiner, Sdc::CatmullClark{}), curve.positions), fading);
}

TEST(Creases, FadeByOneALevelOrByChaikin) {
    const Shape grid = Grid(2);  // the middle line has two edges: 1-4 and 4-7
    Tags tags = MiddleLine(2, 0);
    tags.edge_sharpness = {2.5f, 1.5f};
    tags.vertices = {4};
    tags.vertex_sharpness = {1.25f};
    const auto refiner = Refined(grid, tags, 1);
    const Far::Creases uniform = Far::CreasesAt(refiner, Sdc::Loop{}, 1);
    EXPECT_THAT(uniform.edge_sharpness, ElementsAre(1.5f, 1.5f, 0.5f, 0.5f));
    EXPECT_THAT(uniform.vertices, ElementsAre(4));
    EXPECT_THAT(uniform.vertex_sharpness, ElementsAre(0.25f));
    const Far::Creases chaikin = Far::CreasesAt(refiner, Sdc::Loop{.creasing = Sdc::CreasingMethod::Chaikin}, 1);
    // At vertex 4 both meet: 3/4 of each and 1/4 of the other; at the border each is alone.
    EXPECT_THAT(chaikin.edge_sharpness, ElementsAre(1.5f, 1.25f, 0.75f, 0.5f));
    // Children: from each end of 1-4 to its point, then of 4-7.
    const Index e = refiner.level(0).FindEdge(1, 4), n = refiner.level(0).n_vertices;
    EXPECT_THAT(std::vector<Index>(uniform.edges.begin(), uniform.edges.begin() + 4), ElementsAre(1, n + e, n + e, 4));
}

TEST(Creases, SharpFeaturesFixTheCornersOfOpenSurfaces) {
    const Shape grid = Grid(3);  // two of its corners are in one triangle: 3 and 12
    const auto smooth = Points(grid, {}, Sdc::Loop{}, 2);
    const auto sharp = Points(grid, {}, Sdc::Loop{.features = Sdc::Features::Sharp}, 2);
    for (Index v = 0; v < 16; ++v) {
        const bool is_same = std::equal(&sharp[3 * v], &sharp[3 * v] + 3, &grid.positions[3 * v]);
        EXPECT_EQ(is_same, v == 3 || v == 12) << v;
    }
    EXPECT_NE(smooth, sharp);
}

TEST(Creases, LimitsAreFixedPointsOnceNothingFades) {
    const Shape grid = Grid(4);
    Tags tags = MiddleLine(4, 10);
    tags.edges.resize(4);  // two edges: the crease ends inside, in a dart
    tags.edge_sharpness.resize(2);
    tags.vertices = {6};
    tags.vertex_sharpness = {10};
    const auto refiner = Refined(grid, tags, 1, true);
    const auto rows = Far::StencilTable::Create(refiner, Sdc::Loop{}).level(1);
    const auto before = Far::LimitStencilTable::Create(refiner, Sdc::Loop{}, {.level = 0});
    const auto after = Far::LimitStencilTable::Create(refiner, Sdc::Loop{}, {.level = 1});
    EXPECT_TRUE(before.without_limit().empty());
    const auto limits = [](const Far::LimitStencilTable& table, const std::vector<double>& values) {
        return Apply(Far::StencilTable::FromRows(table.rows().n_sources, {table.rows()}), values);
    };
    const auto a = limits(before, grid.positions);
    auto b = limits(after, Apply(Far::StencilTable::FromRows(grid.n_vertices, {rows}), grid.positions));
    b.resize(a.size());
    ExpectNear(a, b, 2e-14);
    EXPECT_TRUE(std::equal(&a[18], &a[18] + 3, &grid.positions[18])) << "the corner stays";

    // Where creases fade the limit is not this level's to say.
    const auto fading = Refined(grid, MiddleLine(4, 1.5f), 2, true);
    EXPECT_EQ(Far::LimitStencilTable::Create(fading, Sdc::Loop{}, {.level = 0}).without_limit().size(), 5u);
    EXPECT_TRUE(Far::LimitStencilTable::Create(fading, Sdc::Loop{}, {.level = 2}).without_limit().empty());
}

TEST(Creases, ThatCannotBeAreRefusedOrReported) {
    const Shape grid = Grid(2);
    const auto create = [&](const Tags& tags) { return Refined(grid, tags, 0); };
    constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_THROW(create({{1, 4}, {-1}, {}, {}}), InvalidInput);
    EXPECT_THROW(create({{1, 4}, {kNan}, {}, {}}), InvalidInput);
    EXPECT_THROW(create({{}, {}, {1}, {-0.5f}}), InvalidInput);
    EXPECT_THROW(create({{1, 4}, {}, {}, {}}), InvalidInput) << "no sharpness given";
    EXPECT_THROW(create({{1, 9}, {1}, {}, {}}), InvalidInput) << "no such vertex";
    EXPECT_THROW(create({{1, 1}, {1}, {}, {}}), InvalidInput);
    EXPECT_THROW(create({{}, {}, {-1}, {1}}), InvalidInput);
    const auto refiner = create({{0, 8}, {1}, {}, {}});  // no edge of a triangle
    ASSERT_EQ(refiner.defects().size(), 1u);
    EXPECT_EQ(refiner.defects()[0].code, Far::DefectCode::UnusedSharpness);
    EXPECT_TRUE(refiner.sharpness().empty());

    const auto semi_sharp = Refined(grid, MiddleLine(2, 1.5f), 1);
    for (const Sdc::Scheme& scheme : {Sdc::Scheme(Sdc::Butterfly{}), Sdc::Scheme(Sdc::ModifiedButterfly{})})
        EXPECT_THROW(Far::StencilTable::Create(semi_sharp, scheme), InvalidInput);
}

// The boundary of a solid is a surface like any other.
TEST(Creases, OnTheBoundaryOfASolidAreThoseOfItsSurface) {
    Shape solid = TestShapes::KuhnBlock(2);
    TestShapes::Jitter(solid, 0.1, 5);
    // Around the block at z = 1: a closed crease, and one corner of the block.
    Tags tags;
    const std::vector<Index> ring{9, 10, 11, 14, 17, 16, 15, 12};
    for (std::size_t i = 0; i < ring.size(); ++i) {
        tags.edges.insert(tags.edges.end(), {ring[i], ring[(i + 1) % ring.size()]});
        tags.edge_sharpness.push_back(2.25f);
    }
    tags.vertices = {26};
    tags.vertex_sharpness = {10};
    const auto refiner = Refined(solid, tags, 3, true);
    EXPECT_TRUE(refiner.defects().empty());
    Shape surface = solid;
    surface.tets.clear();
    surface.triangles.assign(refiner.level(0).boundary_vertices.begin(), refiner.level(0).boundary_vertices.end());
    const auto inside = Apply(Far::StencilTable::Create(refiner, Sdc::BoxSpline{}), solid.positions);
    const auto alone = Points(surface, tags, Sdc::Loop{}, 3);
    std::vector<double> boundary, of_surface;
    for (Index v = 0; v < refiner.level(3).n_vertices; ++v) {
        if (refiner.level(3).vertex_tags[v].rule() == Vtr::Rule::Solid) continue;
        boundary.insert(boundary.end(), &inside[3 * v], &inside[3 * v] + 3);
    }
    for (std::size_t v = 0; v < alone.size() / 3; ++v) {
        if (v == 13) continue;  // the inner vertex, in no triangle
        of_surface.insert(of_surface.end(), &alone[3 * v], &alone[3 * v] + 3);
    }
    const auto a = SortedPoints(boundary), b = SortedPoints(of_surface);
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
        for (int k = 0; k < 3; ++k) ASSERT_NEAR(a[i][k], b[i][k], 1e-9);
    }
}

}  // namespace
