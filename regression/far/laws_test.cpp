// SPDX-License-Identifier: Apache-2.0
// Laws of every scheme on every shape: they hold for any mesh, so they are checked before any particular number.
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <solidsubdiv/far/choose_diagonals.h>
#include <solidsubdiv/far/primvar_refiner.h>
#include <solidsubdiv/far/stencil_table.h>
#include <solidsubdiv/sdc/parallel.h>

#include "far/far_testing.h"
#include "sanitized.h"

namespace {

using namespace SolidSubdiv;
using namespace SolidSubdiv::TestFar;
using TestShapes::Shape;

/// Runs body(name, shape, scheme) for every scheme with every option that refines the shape.
template <class Body>
void ForEachShapeAndScheme(Body&& body) {
    for (const auto& [name, shape] : TestShapes::AllShapes()) {
        for (const auto& [scheme_name, scheme] : AllSchemes()) {
            if (!IsSolid(scheme) && !(shape.tets.empty() && shape.octs.empty())) continue;
            SCOPED_TRACE(std::string(name) + ", " + scheme_name);
            body(shape, scheme);
        }
    }
}

double LargestRowError(const Far::StencilRows<double>& rows) {
    double largest = 0;
    for (Index i = 0; i < rows.n_rows(); ++i) {
        double sum = 0;
        for (double w : rows.Weights(i)) sum += w;
        largest = std::max(largest, std::abs(sum - 1));
    }
    return largest;
}

// 1e-15 times the length of a row (20): each sum's round-off.
constexpr double kRoundOff = 2e-14;

TEST(LawsTest, WeightsOfEveryRowSumToOne) {
    ForEachShapeAndScheme([](const Shape& shape, const Sdc::Scheme& scheme) {
        const auto refiner = Refined(shape, 2);
        const auto table = Far::StencilTable::Create(refiner, scheme);
        for (int i = 1; i <= 2; ++i) EXPECT_LT(LargestRowError(table.level(i)), kRoundOff);
    });
}

TEST(LawsTest, APlantedWeightIsCaughtByTheSumOfItsRow) {
    const auto refiner = Refined(TestShapes::KuhnBlock(2), 1);
    auto rows = Far::StencilTable::Create(refiner, Sdc::BoxSpline{}).level(1);
    rows.weights[rows.weights.size() / 2] += 1e-6;
    EXPECT_GT(LargestRowError(rows), 1e-7);
}

TEST(LawsTest, AffineMapsOfTheControlPointsMapTheRefinedPoints) {
    const double a[3][4] = {{0.3, -1.2, 0.4, 5}, {0.8, 0.1, -0.5, -2}, {-0.7, 0.2, 0.9, 1}};
    const auto map = [&](const std::vector<double>& p) {
        std::vector<double> q(p.size());
        for (std::size_t i = 0; i < p.size(); i += 3) {
            for (int r = 0; r < 3; ++r) q[i + r] = a[r][0] * p[i] + a[r][1] * p[i + 1] + a[r][2] * p[i + 2] + a[r][3];
        }
        return q;
    };
    ForEachShapeAndScheme([&](const Shape& shape, const Sdc::Scheme& scheme) {
        const auto refiner = Refined(shape, 2);
        const auto table = Far::StencilTable::Create(refiner, scheme);
        ExpectNear(Apply(table, map(shape.positions)), map(Apply(table, shape.positions)), 1e-13);
    });
}

TEST(LawsTest, RefiningTwiceIsRefiningTwoLevels) {
    ForEachShapeAndScheme([](const Shape& shape, const Sdc::Scheme& scheme) {
        const auto at_once = Refined(shape, 2);
        // The first level as a mesh of its own: the same cells, triangles and edges, hence other numbers of edges.
        const auto first = Refined(shape, 1, true);
        const Shape middle = AsShape(first.level(1), Apply(Far::StencilTable::Create(first, scheme), shape.positions));
        const auto second = Refined(middle, 1);
        const auto a = SortedPoints(Apply(Far::StencilTable::Create(at_once, scheme), shape.positions));
        const auto b = SortedPoints(Apply(Far::StencilTable::Create(second, scheme), middle.positions));
        ASSERT_EQ(a.size(), b.size());
        for (std::size_t i = 0; i < a.size(); ++i) {
            for (int k = 0; k < 3; ++k) ASSERT_NEAR(a[i][k], b[i][k], 1e-9);  // rounded to 1e-10 for sorting
        }
    });
}

TEST(LawsTest, PrimvarRefinerGivesTheTablesBits) {
    ForEachShapeAndScheme([](const Shape& shape, const Sdc::Scheme& scheme) {
        const auto refiner = Refined(shape, 2);
        const auto table = Far::StencilTable::Create(refiner, scheme);
        const Far::PrimvarRefiner primvars(refiner, scheme);
        std::vector<double> values = shape.positions;
        for (int i = 1; i <= 2; ++i) {
            std::vector<double> next(3 * static_cast<std::size_t>(refiner.level(i).n_vertices));
            primvars.Interpolate<double>(i, values, next, 3);
            values = next;
        }
        EXPECT_EQ(values, Apply(table, shape.positions));
    });
}

TEST(LawsTest, CompositeRowsAreProductsOfCascadedOnes) {
    ForEachShapeAndScheme([](const Shape& shape, const Sdc::Scheme& scheme) {
        const int level = kIsSanitized ? 2 : 3;
        const auto refiner = Refined(shape, level);
        const auto composite = Far::StencilTable::CreateComposite(refiner, scheme, {{.level = level}});
        EXPECT_LT(LargestRowError(composite.level(1)), kRoundOff);
        ExpectNear(Apply(composite, shape.positions),
                   Apply(Far::StencilTable::Create(refiner, scheme), shape.positions), 1e-13);
        for (Index row = 0; row < composite.level(1).n_rows(); ++row) {
            const auto indices = composite.level(1).Indices(row);
            ASSERT_TRUE(std::is_sorted(indices.begin(), indices.end()));
            ASSERT_EQ(std::adjacent_find(indices.begin(), indices.end()), indices.end());
        }
    });
}

TEST(LawsTest, ChosenCompositeRowsAreThoseOfTheFullTables) {
    const Shape shape = TestShapes::RandomSubset(TestShapes::KuhnBlock(3), 60, 2);
    const auto refiner = Refined(shape, 3);
    std::vector<Far::StencilTable> full;
    for (int l = 0; l <= 3; ++l) {
        full.push_back(Far::StencilTable::CreateComposite(refiner, Sdc::BoxSpline{}, {{.level = l}}));
    }
    // Out of order, one twice, of several levels, alone and together, beside whole levels.
    const std::vector<Index> some{5, 0, 200, 5, 77}, other{300, 12}, controls{3, 1};
    const std::vector<std::vector<Far::CompositeRows>> cases = {
        {{.level = 2, .vertices = some}},
        {{.level = 3, .vertices = some}},
        {{.level = 3, .vertices = some}, {.level = 0, .vertices = controls}, {.level = 3, .vertices = other}},
        {{.level = 1, .vertices = controls}, {.level = 3, .vertices = some}, {.level = 2, .vertices = other}},
        {{.level = 3, .vertices = some}, {.level = 2}, {.level = 0}},
        {{.level = 1}, {.level = 3}},
        {},
    };
    for (std::size_t c = 0; c < cases.size(); ++c) {
        SCOPED_TRACE("case " + std::to_string(c));
        const auto table = Far::StencilTable::CreateComposite(refiner, Sdc::BoxSpline{}, cases[c]);
        const auto& rows = table.level(1);
        Index row = 0;
        for (const Far::CompositeRows& r : cases[c]) {
            const auto& whole = full[r.level].level(1);
            const Index n =
                r.vertices.empty() ? refiner.level(r.level).n_vertices : static_cast<Index>(r.vertices.size());
            for (Index i = 0; i < n; ++i, ++row) {
                const Index v = r.vertices.empty() ? i : r.vertices[i];
                EXPECT_TRUE(std::ranges::equal(rows.Indices(row), whole.Indices(v)));
                EXPECT_TRUE(std::ranges::equal(rows.Weights(row), whole.Weights(v)));
            }
        }
        EXPECT_EQ(rows.n_rows(), row);
    }
    EXPECT_THAT(full[0].level(1).weights, testing::Each(1.0));
    EXPECT_THROW(Far::StencilTable::CreateComposite(refiner, Sdc::BoxSpline{}, {{.level = 4}}), InvalidInput);
    const std::vector<Index> beyond{refiner.level(2).n_vertices};
    EXPECT_THROW(Far::StencilTable::CreateComposite(refiner, Sdc::BoxSpline{}, {{.level = 2, .vertices = beyond}}),
                 InvalidInput);
}

TEST(LawsTest, TablesAreTheSameBitsForAnyNumberOfThreads) {
    const Shape shape = TestShapes::RandomSubset(TestShapes::KuhnBlock(6), 70, 3);
    for (const auto& [name, scheme] : AllSchemes()) {
        if (!IsSolid(scheme)) continue;
        SCOPED_TRACE(name);
        std::vector<Far::StencilTable> cascaded, composite;
        for (int threads : {1, 2, 5}) {
            const Sdc::ThreadLimit limit(threads);
            const auto refiner = Refined(shape, 2);
            cascaded.push_back(Far::StencilTable::Create(refiner, scheme));
            composite.push_back(Far::StencilTable::CreateComposite(refiner, scheme, {{.level = 2}}));
        }
        for (std::size_t i = 1; i < cascaded.size(); ++i) {
            for (int l = 1; l <= 2; ++l) {
                EXPECT_EQ(cascaded[0].level(l).offsets, cascaded[i].level(l).offsets);
                EXPECT_EQ(cascaded[0].level(l).indices, cascaded[i].level(l).indices);
                EXPECT_EQ(cascaded[0].level(l).weights, cascaded[i].level(l).weights);
            }
            EXPECT_EQ(composite[0].level(1).indices, composite[i].level(1).indices);
            EXPECT_EQ(composite[0].level(1).weights, composite[i].level(1).weights);
        }
    }
}

/// The shape with vertices renumbered and cells shuffled; `vertices[v]` is the new number of v.
Shape Renumbered(const Shape& s, std::vector<Index>& vertices, std::uint64_t seed) {
    TestShapes::Random random(seed);
    vertices.resize(s.n_vertices);
    std::iota(vertices.begin(), vertices.end(), 0);
    random.Shuffle(vertices);
    Shape t;
    t.n_vertices = s.n_vertices;
    t.positions.resize(s.positions.size());
    for (Index v = 0; v < s.n_vertices; ++v) {
        std::copy_n(s.positions.begin() + 3 * v, 3, t.positions.begin() + 3 * vertices[v]);
    }
    const auto shuffle = [&](const std::vector<Index>& from, std::size_t arity, std::vector<Index>& to) {
        std::vector<std::size_t> order(from.size() / arity);
        std::iota(order.begin(), order.end(), 0);
        random.Shuffle(order);
        for (std::size_t i : order) {
            for (std::size_t k = 0; k < arity; ++k) to.push_back(vertices[from[i * arity + k]]);
        }
    };
    shuffle(s.tets, 4, t.tets);
    shuffle(s.octs, 6, t.octs);
    shuffle(s.triangles, 3, t.triangles);
    shuffle(s.edges, 2, t.edges);
    return t;
}

TEST(LawsTest, NumberingDoesNotMatterWithTheDiagonalsCarriedAlong) {
    ForEachShapeAndScheme([](const Shape& shape, const Sdc::Scheme& scheme) {
        std::vector<Index> vertices;
        const Shape other = Renumbered(shape, vertices, 7);
        const auto a = SortedPoints(Apply(Far::StencilTable::Create(Refined(shape, 2), scheme), shape.positions));
        const auto b = SortedPoints(Apply(Far::StencilTable::Create(Refined(other, 2), scheme), other.positions));
        ASSERT_EQ(a.size(), b.size());
        for (std::size_t i = 0; i < a.size(); ++i) {
            for (int k = 0; k < 3; ++k) ASSERT_NEAR(a[i][k], b[i][k], 1e-9);
        }
    });
}

/// The same cells with the vertices of each tet in another even order: another diagonal.
Shape WithOtherDiagonals(Shape s, std::uint64_t seed) {
    TestShapes::Random random(seed);
    for (std::size_t t = 0; t < s.tets.size(); t += 4) {
        for (int k = random.Below(3); k > 0; --k)
            std::rotate(s.tets.begin() + t + 1, s.tets.begin() + t + 2, s.tets.begin() + t + 4);
    }
    return s;
}

// Level 1 only: at level 2 the octahedra inside the tets split alike, but are listed in another order.
TEST(LawsTest, SchemesWithoutDiagonalsDoNotDependOnThem) {
    Sdc::BoxSpline averaged, directional;
    averaged.diagonals = Sdc::Diagonals::Averaged;
    for (const auto& [name, shape] : TestShapes::AllShapes()) {
        SCOPED_TRACE(name);
        const Shape other = WithOtherDiagonals(shape, 3);
        const auto points = [&](const Shape& s, const Sdc::Scheme& scheme) {
            return SortedPoints(Apply(Far::StencilTable::Create(Refined(s, 3), scheme), s.positions));
        };
        for (const Sdc::Scheme& scheme : {Sdc::Scheme(averaged), Sdc::Scheme(Sdc::SmoothTet{})}) {
            const auto a = points(shape, scheme), b = points(other, scheme);
            ASSERT_EQ(a.size(), b.size());
            for (std::size_t i = 0; i < a.size(); ++i) {
                for (int k = 0; k < 3; ++k) ASSERT_NEAR(a[i][k], b[i][k], 1e-9);
            }
        }
        if (std::string(name) == "kuhn 3") {
            EXPECT_NE(points(shape, directional), points(other, directional)) << "directional does: the test can tell";
        }
    }
}

/// Level 3 of a regular tet whose vertices are given in another order.
std::vector<std::array<double, 3>> PointsOfTurnedTet(const std::array<Index, 4>& order, const Sdc::Scheme& scheme) {
    const std::vector<double> regular{1, 1, 1, 1, -1, -1, -1, 1, -1, -1, -1, 1};
    Shape tet = TestShapes::SingleTet();
    for (int i = 0; i < 4; ++i) std::copy_n(regular.begin() + 3 * order[i], 3, tet.positions.begin() + 3 * i);
    return SortedPoints(Apply(Far::StencilTable::Create(Refined(tet, 3), scheme), tet.positions));
}

TEST(LawsTest, SchemesWithoutDiagonalsHaveAll24SymmetriesOfTheTetrahedron) {
    Sdc::BoxSpline averaged;
    averaged.diagonals = Sdc::Diagonals::Averaged;
    for (const Sdc::Scheme& scheme : {Sdc::Scheme(averaged), Sdc::Scheme(Sdc::SmoothTet{})}) {
        const auto points = [&](const std::array<Index, 4>& order) { return PointsOfTurnedTet(order, scheme); };
        std::array<Index, 4> order{0, 1, 2, 3};
        const auto expected = points(order);
        int n = 0;
        do {
            const auto got = points(order);
            for (std::size_t i = 0; i < expected.size(); ++i) {
                for (int k = 0; k < 3; ++k) ASSERT_NEAR(got[i][k], expected[i][k], 1e-9);
            }
            ++n;
        } while (std::next_permutation(order.begin(), order.end()));
        EXPECT_EQ(n, 24);
    }
}

// A turn or reflection of a tet that keeps the two edges of its diagonal, or swaps them, keeps the refined points.
TEST(LawsTest, SymmetriesThatKeepTheDiagonalKeepThePoints) {
    for (const auto& [name, scheme] : AllSchemes()) {
        if (!IsSolid(scheme)) continue;
        SCOPED_TRACE(name);
        const auto points = [&s = scheme](const std::array<Index, 4>& order) { return PointsOfTurnedTet(order, s); };
        std::array<Index, 4> order{0, 1, 2, 3};
        const auto expected = points(order);
        int n_kept = 0, n_others = 0;
        do {
            const bool keeps_diagonal = order[0] + order[1] == 1 || order[0] + order[1] == 5;
            const auto got = points(order);
            bool is_same = true;
            for (std::size_t i = 0; i < expected.size(); ++i) {
                for (int k = 0; k < 3; ++k) is_same = is_same && std::abs(got[i][k] - expected[i][k]) < 1e-9;
            }
            if (keeps_diagonal) {
                EXPECT_TRUE(is_same);
            }
            n_kept += keeps_diagonal;
            n_others += !keeps_diagonal && !is_same;
        } while (std::next_permutation(order.begin(), order.end()));
        EXPECT_EQ(n_kept, 8);
        // Sharp, a tet's edges stay and all points are where the linear scheme has them.
        const bool is_directional = name.find("box-spline directional") != std::string::npos;
        if (is_directional && name.find("smooth") != std::string::npos) {
            EXPECT_EQ(n_others, 16) << "other turns do not: the test can tell";
        }
    }
}

}  // namespace
